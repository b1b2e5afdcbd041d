// Signals that ask the program to stop.
#pragma once

#include <atomic>

namespace rt {

/// From handle() until the process has ended, SIGINT, SIGTERM and SIGHUP leave at once with 128 +
/// their number, unless there is an image to save: then the first only sets a flag, and the second
/// leaves. Nobody reading the messages any more costs no image.
class Interrupts {
  public:
    static void handle();

    /// While one lives, there is an image to save.
    class Deferred {
      public:
        Deferred();
        ~Deferred();
        Deferred(const Deferred&) = delete;
        Deferred& operator=(const Deferred&) = delete;
    };

    static const std::atomic<bool>& requested();
    /// 128 + the signal's number, or 0.
    static int exitCode();
};

}  // namespace rt
