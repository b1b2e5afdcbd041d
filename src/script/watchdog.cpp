#include "watchdog.h"

#include "memory_budget.h"

#include <chrono>
#include <system_error>
#include <utility>

namespace rt {

Watchdog::Watchdog(double seconds, std::string message) : message_(std::move(message)) {
    try {
        thread_ = std::thread([this, seconds] { wait(seconds); });
    } catch (const std::system_error& error) {
        throw LimitError(std::string("no thread for the time limit of the script: ") +
                         error.what());
    }
}

Watchdog::~Watchdog() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void Watchdog::wait(double seconds) {
    std::unique_lock<std::mutex> lock(mutex_);
    const std::chrono::duration<double> patience(seconds);
    if (wake_.wait_for(lock, patience, [this] { return stop_; })) return;
    endProcess(ExitCode::kLimit, message_.c_str());
}

}  // namespace rt
