// Warnings: counted by kind, the first few of each kind shown.
#pragma once

#include "rt/core/error.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace rt {

/// Collects what should be said to the user. Not thread-safe: one for each phase, on its thread.
class Diagnostics {
  public:
    struct Warning {
        SourceLocation where;
        std::string message;
        std::string kind;  ///< short, for "[-Wkind]"
    };

    /// "scene.lua:12: warning: message [-Wkind]".
    void warn(const std::string& kind, const SourceLocation& where, const std::string& message);

    /// The first kShownPerKind of each kind, in order of arrival.
    const std::vector<Warning>& shown() const { return shown_; }
    std::size_t total() const { return total_; }
    const std::map<std::string, std::size_t>& countByKind() const { return countByKind_; }

    static constexpr std::size_t kShownPerKind = 5;

  private:
    std::vector<Warning> shown_;
    std::map<std::string, std::size_t> countByKind_;
    std::size_t total_ = 0;
};

/// Control bytes and broken UTF-8 made visible, and the text cut to `most` bytes, for messages.
std::string printable(const std::string& text, std::size_t most = 4096);

}  // namespace rt
