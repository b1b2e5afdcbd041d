// The way through the program: options -> command. Rendering is src/app/commands/render.cpp:
// script -> description -> compiled scene -> tiles -> film -> file.
#include "roomy_stack.h"
#include "rt/app/commands.h"
#include "rt/app/options.h"
#include "rt/core/error.h"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace {

int run(const std::vector<std::string>& arguments) {
    const rt::Options options = rt::parseOptions(arguments);
    switch (options.command) {
        case rt::Command::kHelp:
            return rt::helpCommand();
        case rt::Command::kVersion:
            return rt::versionCommand();
        case rt::Command::kCompare:
            return rt::compareCommand(options.compare);
        case rt::Command::kGolden:
            return rt::goldenCommand(options);
        case rt::Command::kMerge:
            return rt::mergeCommand(options.merge);
        case rt::Command::kPrint:
            return rt::printCommand(options);
        case rt::Command::kRender:
            return rt::renderCommand(options);
    }
    return static_cast<int>(rt::ExitCode::kInternal);
}

/// Ends the process without allocating anything.
[[noreturn]] void leave(rt::ExitCode code, std::string_view message) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(static_cast<int>(code));
}

/// What nobody could catch: libraries allocate in destructors, which may not throw.
[[noreturn]] void onTerminate() {
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
        leave(rt::ExitCode::kLimit, "error: the system has no memory left\n");
    } catch (...) {
    }
    leave(rt::ExitCode::kInternal, "error: internal error: terminated; please report it\n");
}

int runAndReport(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const rt::Error& error) {
        std::fprintf(stderr, "%s\n", error.shown().c_str());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        leave(rt::ExitCode::kLimit, "error: the system has no memory left\n");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: internal error: %s; please report it\n", error.what());
        return static_cast<int>(rt::ExitCode::kInternal);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::set_terminate(onTerminate);
    return rt::withRoomyStack([&] { return runAndReport(argc, argv); });
}
