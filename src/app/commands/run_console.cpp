#include "run_console.h"

#include <algorithm>

namespace rt {

RunConsole::RunConsole(const Options& options)
    : quiet_(options.quiet), progress_(standardError(options.color), options.quiet) {}

bool RunConsole::isStale() const {
    return std::any_of(followers_.begin(), followers_.end(),
                       [](const RunFollower* follower) { return follower->isStale(); });
}

void RunConsole::tell(const std::string& line) {
    if (!quiet_) progress_.message(line);
}

void RunConsole::say(const std::string& line) {
    progress_.message(line);
    for (RunFollower* follower : followers_) follower->said(line);
}

void RunConsole::warnIfAny(const std::string& sentence) {
    if (!sentence.empty()) say("warning: " + sentence);
}

}  // namespace rt
