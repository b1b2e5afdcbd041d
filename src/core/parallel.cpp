#include "rt/core/parallel.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <fstream>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace rt {
namespace {

int affinityCount() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) != 0) {
        return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    }
    return std::max(1, CPU_COUNT(&set));
}

/// CPUs granted by the control group, or infinity. "max 100000" or "50000 100000".
double quotaCount() {
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    std::string quota;
    double period = 0.0;
    if (!(file >> quota >> period) || quota == "max" || !(period > 0.0)) return INFINITY;
    try {
        return std::stod(quota) / period;
    } catch (const std::exception&) {
        return INFINITY;
    }
}

/// What the threads of one forEachIndex share.
class Queue {
  public:
    Queue(std::size_t count, const std::function<void(std::size_t, int)>& work)
        : count_(count), work_(work) {}

    void drain(int thread) {
        try {
            for (;;) {
                const std::size_t index = next_.fetch_add(1, std::memory_order_relaxed);
                if (index >= count_) return;
                work_(index, thread);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            next_.store(count_, std::memory_order_relaxed);
        }
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    std::size_t count_;
    const std::function<void(std::size_t, int)>& work_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

int availableThreads() {
    const double quota = std::ceil(quotaCount());
    const int affinity = affinityCount();
    return quota < affinity ? std::max(1, static_cast<int>(quota)) : affinity;
}

void forEachIndex(std::size_t count, int threads,
                  const std::function<void(std::size_t, int)>& work) {
    const auto wanted = static_cast<int>(
        std::min<std::size_t>(count, static_cast<std::size_t>(std::max(threads, 1))));
    Queue queue(count, work);
    std::vector<std::thread> helpers;
    for (int thread = 1; thread < wanted; ++thread) {
        try {
            helpers.emplace_back([&queue, thread] { queue.drain(thread); });
        } catch (const std::system_error&) {
            break;  // the system grants no more threads: those that run do all the work
        }
    }
    queue.drain(0);
    for (auto& helper : helpers) helper.join();
    queue.rethrow();
}

}  // namespace rt
