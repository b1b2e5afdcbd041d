// Who follows a run, beside the messages.
#pragma once

#include "rt/script/scene_script.h"
#include "scene_renderer.h"

#include <string>

namespace rt {

class RunFollower {
  public:
    virtual ~RunFollower() = default;

    /// A script has run or failed.
    virtual void ranScript(const std::string& /*scene*/, const ScriptFiles& /*files*/) {}
    /// An image is about to be rendered for this output.
    virtual void startsImage(const std::string& /*output*/, const PreparedScene& /*prepared*/) {}
    /// An image is in its file.
    virtual void savedImage(const Picture& /*picture*/) {}
    /// An error or a warning, as it is shown to the user.
    virtual void said(const std::string& /*line*/) {}
    /// What a render should tell it.
    virtual void listen(RenderListener& /*listener*/) {}
    /// Whether what is rendered is out of date, and to be left.
    virtual bool isStale() const { return false; }
};

}  // namespace rt
