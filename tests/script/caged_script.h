// Runs a script in the cage, in a folder of its own, and keeps what came of it.
#pragma once

#include "script/lua_access.h"
#include "script/lua_state.h"
#include "script/sandbox.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rt::test {

/// A folder with a folder "scene" in it, and a file outside of that; gone with its owner.
class CageFolder {
  public:
    CageFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "cage_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp");
        path_ = std::filesystem::canonical(pattern);
        std::filesystem::create_directory(path_ / "scene");
        write("../secret.txt", "secret");
        write("../secret.lua", "return 'secret'");
    }
    ~CageFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    CageFolder(const CageFolder&) = delete;
    CageFolder& operator=(const CageFolder&) = delete;

    std::string scene() const { return (path_ / "scene").string(); }
    std::string file(const std::string& name) const { return scene() + "/" + name; }
    void write(const std::string& name, const std::string& text) const {
        const std::filesystem::path target = path_ / "scene" / name;
        std::filesystem::create_directories(target.parent_path());
        std::ofstream(target, std::ios::binary) << text;
    }

  private:
    std::filesystem::path path_;
};

struct Outcome {
    int code = 0;
    std::string message;
    std::string shown;  ///< the message as a user sees it
    std::string traceback;
    std::string told;  ///< what the script gave to tell(...): by spaces, calls by lines
    std::vector<std::string> files;
};

inline int tell(lua_State* state) {
    std::string& told = *static_cast<std::string*>(contextOf(state));
    const int count = lua_gettop(state);
    for (int i = 1; i <= count; ++i) told += (i > 1 ? " " : "") + displayText(state, i);
    told += "\n";
    return 0;
}

/// Opens the sandbox, adds tell, and does `what` with the state.
inline Outcome outcomeOf(const SandboxSettings& settings, const LuaLimits& limits,
                         const std::function<void(LuaState&)>& what) {
    Outcome outcome;
    try {
        LuaState state(limits);
        state.setContext(&outcome.told);
        try {
            openSandbox(state, settings);
            state.protect([](lua_State* inner) {
                lua_pushglobaltable(inner);
                assignFunction(inner, -1, "tell", guarded<tell>);
            });
            what(state);
        } catch (const Error& error) {
            outcome.code = static_cast<int>(error.code());
            outcome.message = error.what();
            outcome.shown = error.shown();
        }
        outcome.traceback = state.traceback();
        outcome.files = filesRead(state.get());
    } catch (const Error& error) {
        outcome.code = static_cast<int>(error.code());
        outcome.message = error.what();
    }
    return outcome;
}

/// Runs text as "scene.lua".
inline Outcome runCaged(const std::string& text, const LuaLimits& limits = {},
                        const SandboxSettings& settings = {}) {
    return outcomeOf(settings, limits, [&](LuaState& state) { state.runText(text, "scene.lua"); });
}

/// Runs text as "scene.lua", caged in the folder.
inline Outcome runIn(const CageFolder& folder, const std::string& text, bool trust = false) {
    return runCaged(text, {}, {folder.scene(), trust, false});
}

/// Runs a file of the folder by its path.
inline Outcome runFileIn(const CageFolder& folder, const std::string& name) {
    return outcomeOf({folder.scene(), false, false}, {},
                     [&](LuaState& state) { state.runFile(folder.file(name)); });
}

struct ChildEnd {
    int exitCode = -1;
    int signal = 0;
    std::string errors;  ///< its stderr
};

/// What becomes of a process that does `what` and then exits with what it returns.
inline ChildEnd inChild(const std::function<int()>& what) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        dup2(ends[1], STDERR_FILENO);
        alarm(20);
        _exit(what());
    }
    close(ends[1]);
    ChildEnd end;
    char block[4096];
    for (ssize_t got; (got = read(ends[0], block, sizeof block)) > 0;) {
        end.errors.append(block, static_cast<std::size_t>(got));
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) end.exitCode = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    return end;
}

}  // namespace rt::test
