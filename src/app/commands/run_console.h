// What a run says: on the terminal, and to those who follow it.
#pragma once

#include "rt/app/options.h"
#include "rt/app/progress.h"
#include "run_follower.h"

#include <string>
#include <vector>

namespace rt {

class RunConsole {
  public:
    explicit RunConsole(const Options& options);

    /// Called before the first run; it must outlive the last.
    void add(RunFollower& follower) { followers_.push_back(&follower); }
    const std::vector<RunFollower*>& followers() const { return followers_; }
    /// Whether somebody knows that what is rendered is out of date.
    bool isStale() const;

    Progress& progress() { return progress_; }
    void show(const std::string& line) { progress_.message(line); }
    /// A line that --quiet leaves out.
    void tell(const std::string& line);
    /// An error or a warning.
    void say(const std::string& line);
    /// A sentence to warn with, or "".
    void warnIfAny(const std::string& sentence);

  private:
    bool quiet_;
    Progress progress_;
    std::vector<RunFollower*> followers_;
};

}  // namespace rt
