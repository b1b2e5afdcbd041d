// Work shared out over threads.
#pragma once

#include <cstddef>
#include <functional>

namespace rt {

/// The number of threads that this process may run at once: its affinity mask and CPU quota.
int availableThreads();

/// Calls work(index, thread) once for each index < count, on at most `threads` threads, indices
/// handed out in ascending order. The first exception stops the handing out and is rethrown here
/// once all threads have come back. Runs on the calling thread alone where one is enough.
void forEachIndex(std::size_t count, int threads,
                  const std::function<void(std::size_t index, int thread)>& work);

}  // namespace rt
