// Stacks of a known size, whatever the limits that the program was started with.
#pragma once

#include <functional>

namespace rt {

/// What `work` returns, run where kStackBytes are free: here if the limit of the process says so,
/// else on a thread. The threads that it starts have as much. `work` throws nothing.
int withRoomyStack(const std::function<int()>& work);

}  // namespace rt
