// Watches the files of a run for --watch, and stops a render that is out of date.
#pragma once

#include "file_watch.h"
#include "run_follower.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rt {

class Watcher : public RunFollower {
  public:
    Watcher();
    ~Watcher() override;

    void beginRound();
    void endRound();
    /// The files that changed since the last call; waits for some.
    std::vector<std::string> changes();
    std::size_t fileCount() const { return files_.size(); }

    void ranScript(const std::string& scene, const ScriptFiles& files) override;
    /// What the run writes itself is no reason to run again.
    void startsImage(const std::string& output, const PreparedScene& prepared) override;
    bool isStale() const override { return stale_; }

  private:
    void look();

    FileWatch files_;
    std::atomic<bool> ending_{false};
    std::atomic<bool> stale_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::string> changes_;
    std::thread thread_;
};

}  // namespace rt
