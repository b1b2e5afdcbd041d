// A preloaded library in which the n-th allocation from main on fails, and every later one if
// RT_FAIL_STAYS is set: RT_FAIL_AT=n. Without RT_FAIL_AT it counts; the count goes to the file
// RT_COUNT_TO at the end. What comes before main are libraries' static objects, and nothing can
// catch what they throw. C++'s operator new and Lua's allocator both end in malloc and realloc.
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

std::atomic<long> calls{0};
long failAt = 0;
bool stays = false;
const char* countTo = nullptr;
std::atomic<bool> running{false};

bool fails() {
    if (!running.load(std::memory_order_relaxed)) return false;
    const long call = ++calls;
    if (failAt == 0 || (stays ? call < failAt : call != failAt)) return false;
    errno = ENOMEM;
    return true;
}

using Main = int (*)(int, char**, char**);
Main realMain = nullptr;

void end() {
    running = false;
    if (countTo == nullptr) return;
    if (std::FILE* file = std::fopen(countTo, "w")) {
        std::fprintf(file, "%ld\n", calls.load());
        std::fclose(file);
    }
}

int countedMain(int argc, char** argv, char** environment) {
    if (const char* text = std::getenv("RT_FAIL_AT")) failAt = std::atol(text);
    stays = std::getenv("RT_FAIL_STAYS") != nullptr;
    countTo = std::getenv("RT_COUNT_TO");
    running = true;
    const int result = realMain(argc, argv, environment);
    end();
    return result;
}

}  // namespace

extern "C" {

int __libc_start_main(Main program, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loaderFini)(), void* stackEnd) {
    realMain = program;
    const auto next =
        reinterpret_cast<decltype(&__libc_start_main)>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return next(countedMain, argc, argv, init, fini, loaderFini, stackEnd);
}

void* malloc(std::size_t size) {
    return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return fails() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
    return fails() ? nullptr : __libc_realloc(old, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return fails() ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** to, std::size_t alignment, std::size_t size) {
    if (fails()) return ENOMEM;
    *to = __libc_memalign(alignment, size);
    return *to == nullptr ? ENOMEM : 0;
}
}
