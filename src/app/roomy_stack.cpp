#include "roomy_stack.h"

#include <pthread.h>
#include <sys/resource.h>

#include <cstddef>
#include <system_error>
#include <thread>

namespace rt {
namespace {

/// Lua nests 200 C calls, of which string.gsub's hold 8 KB each, and its parser as many.
constexpr std::size_t kStackBytes = std::size_t{8} << 20;

bool isRoomy() {
    rlimit limit{};
    return getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur >= kStackBytes;
}

void setStackOfThreads() {
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return;
    pthread_attr_setstacksize(&attributes, kStackBytes);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
}

}  // namespace

int withRoomyStack(const std::function<int()>& work) {
    if (isRoomy()) return work();
    setStackOfThreads();
    int result = 0;
    try {
        std::thread thread([&] { result = work(); });
        thread.join();
    } catch (const std::system_error&) {
        return work();  // no thread: what fits in the small stack still works
    }
    return result;
}

}  // namespace rt
