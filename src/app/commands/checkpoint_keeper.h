// The checkpoint of one render: read, saved, and removed once there is an image.
#pragma once

#include "checkpoint.h"
#include "scene_renderer.h"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rt {

class CheckpointKeeper {
  public:
    using Time = std::chrono::system_clock::time_point;

    /// For a render to the file `output` whose script began at `began` and read `filesRead`.
    /// `traits` tells what is rendered, and is asked when that is to be known; it may throw
    /// SceneError.
    CheckpointKeeper(const Options& options, const std::string& output,
                     std::vector<std::string> filesRead, Time began,
                     std::function<std::vector<Trait>()> traits);

    const std::string& file() const { return file_; }

    /// With --resume, reads what is there; returns "" or a sentence to warn with. Throws SceneError
    /// for a checkpoint of another picture, and with --resume=require for one that is useless.
    std::string open();

    /// Has the render told of what it needs.
    void listen(RenderListener& listener);

    /// What the render has come to is kept, and the next one goes on from it.
    void pause() { log_.gather(); }

    /// There is an image: the checkpoint goes. Returns as `open` does.
    std::string finish();

    /// Whether the render goes on from what the file held.
    bool goesOn() const { return goesOn_; }
    /// Whether the file holds what the render has come to.
    bool isSaved() const { return saved_; }
    /// Why not, where it should.
    const std::string& problem() const { return problem_; }

  private:
    void save();
    void saveOrThrow();
    void refuseChangedFiles() const;
    bool isLessThanThere(std::size_t bytes) const;

    const Options& options_;
    std::string file_;
    std::vector<std::string> filesRead_;
    Time began_;
    std::function<std::vector<Trait>()> makeTraits_;
    std::optional<std::vector<Trait>> traits_;
    RenderLog log_;
    bool isOurs_ = false;  ///< the file is one of this picture's checkpoints, or a useless one
    bool goesOn_ = false;
    bool saved_ = false;
    std::string problem_;
};

}  // namespace rt
