// Ends the process when a script does not come back.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace rt {

/// From construction to destruction, a thread that ends the process with exit code 4 and the
/// message when `seconds` have passed. Nothing is flushed, so that no file is left half-written.
class Watchdog {
  public:
    /// Throws LimitError when the system gives no thread.
    Watchdog(double seconds, std::string message);
    ~Watchdog();
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

  private:
    void wait(double seconds);

    std::string message_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool stop_ = false;
    std::thread thread_;
};

}  // namespace rt
