// What can go wrong, as types: each carries its exit code and, where there is one, the script line.
#pragma once

#include <stdexcept>
#include <string>

namespace rt {

/// A line of a script or an asset; line 0 means the file as a whole, an empty file means nowhere.
struct SourceLocation {
    std::string file;
    int line = 0;

    /// "scene.lua:12: ", "scene.lua: " or "".
    std::string prefix() const {
        if (file.empty()) return "";
        return line > 0 ? file + ":" + std::to_string(line) + ": " : file + ": ";
    }
};

enum class ExitCode : int {
    kDone = 0,
    kScene = 1,
    kUsage = 2,
    kOutput = 3,
    kLimit = 4,
    kInternal = 5,
    kComparison = 10,
};

/// Base of every error that this program raises on purpose. `what()` is the whole message:
/// what was wrong, where, and what would be right.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const SourceLocation& where, const std::string& message)
        : std::runtime_error(where.prefix() + message),
          code_(code),
          prefix_(where.prefix()),
          message_(message) {}

    ExitCode code() const { return code_; }
    /// As it is shown to the user: "scene.lua:12: error: what was wrong".
    std::string shown() const { return prefix_ + "error: " + message_; }

    /// Adds where the script named the asset that is wrong.
    void namedAt(const SourceLocation& where) {
        if (!where.file.empty()) {
            message_ += " (named at " + where.file + ":" + std::to_string(where.line) + ")";
        }
    }

    /// What --verbose adds: where a script was when it failed.
    const std::string& details() const { return details_; }
    void attach(const std::string& details) { details_ = details; }

  private:
    ExitCode code_;
    std::string prefix_;
    std::string message_;
    std::string details_;
};

/// The script, one of its calls, or an asset is wrong.
class SceneError : public Error {
  public:
    explicit SceneError(const std::string& message, const SourceLocation& where = {})
        : Error(ExitCode::kScene, where, message) {}
};

/// The command line is wrong.
class UsageError : public Error {
  public:
    explicit UsageError(const std::string& message) : Error(ExitCode::kUsage, {}, message) {}
};

/// A result cannot be written.
class OutputError : public Error {
  public:
    explicit OutputError(const std::string& message) : Error(ExitCode::kOutput, {}, message) {}
};

/// A limit on time, memory, pixels or instances was met; the message names what raises it.
class LimitError : public Error {
  public:
    explicit LimitError(const std::string& message, const SourceLocation& where = {})
        : Error(ExitCode::kLimit, where, message) {}
};

}  // namespace rt
