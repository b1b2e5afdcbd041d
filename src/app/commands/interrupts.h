// Signals that ask the program to stop.
#pragma once

#include <atomic>

namespace rt {

/// From handle() until the process has ended, SIGINT, SIGTERM and SIGHUP leave at once with 128 +
/// their number, unless there is an image to save: then the first only sets a flag, and the second
/// leaves. SIGUSR1 asks for a snapshot of that image. Nobody reading the messages any more costs no
/// image.
class Interrupts {
  public:
    static void handle();

    /// While one lives, there is an image to save.
    class Deferred {
      public:
        /// With `pauses`, the render can be gone on with after a snapshot.
        explicit Deferred(bool pauses);
        ~Deferred();
        Deferred(const Deferred&) = delete;
        Deferred& operator=(const Deferred&) = delete;
    };

    /// True once a render should stop, for a signal or by stopRender.
    static const std::atomic<bool>& requested();
    /// Stops the render at hand as a signal would, but the program goes on.
    static void stopRender();
    /// Lets the next one run, unless there was a signal.
    static void allowRender();
    static bool isSnapshotAsked();
    /// Whether the render was stopped for a snapshot, and for nothing else; then it may go on.
    static bool takeSnapshotRequest();
    /// 128 + the signal's number, or 0.
    static int exitCode();
};

}  // namespace rt
