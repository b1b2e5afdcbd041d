// The way through the program: options -> command. Rendering is src/app/commands/render.cpp:
// script -> description -> compiled scene -> tiles -> film -> file.
#include "roomy_stack.h"
#include "rt/app/commands.h"
#include "rt/app/options.h"
#include "rt/core/error.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>
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
        case rt::Command::kRender:
            return rt::renderCommand(options);
    }
    return static_cast<int>(rt::ExitCode::kInternal);
}

int runAndReport(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const rt::Error& error) {
        std::fprintf(stderr, "%s\n", error.shown().c_str());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        std::fputs("error: out of memory\n", stderr);
        return static_cast<int>(rt::ExitCode::kLimit);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: internal error: %s; please report it\n", error.what());
        return static_cast<int>(rt::ExitCode::kInternal);
    }
}

}  // namespace

int main(int argc, char** argv) {
    return rt::withRoomyStack([&] { return runAndReport(argc, argv); });
}
