#include "dependency_file.h"

#include "rt/core/diagnostics.h"
#include "rt/core/error.h"
#include "rt/output/atomic_file.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <system_error>

namespace rt {
namespace {

/// Backslashes are plain but before an escaped character, where they count double.
std::string escaped(const std::string& name) {
    std::string text;
    std::size_t backslashes = 0;
    for (const char c : name) {
        if (c == '\n' || c == '\r') {
            throw OutputError("--deps: '" + printable(name, 300) +
                              "' has a line break in its name, which make cannot read");
        }
        if (c == ' ' || c == '\t' || c == '#' || c == ':') {
            text.append(backslashes + 1, '\\');
        } else if (c == '$') {
            text += '$';
        }
        backslashes = c == '\\' ? backslashes + 1 : 0;
        text += c;
    }
    return text;
}

/// As make files name it: from the current folder, if it lies below.
std::string nameFrom(const std::string& folder, const std::string& file) {
    const std::string prefix = folder.ends_with('/') ? folder : folder + "/";
    return file.starts_with(prefix) ? file.substr(prefix.size()) : file;
}

}  // namespace

std::string dependencyText(const std::vector<DependencyRule>& rules, const std::string& folder) {
    std::string text;
    std::set<std::string> all;
    for (const DependencyRule& rule : rules) {
        if (rule.images.empty()) continue;
        for (std::size_t i = 0; i < rule.images.size(); ++i) {
            text += (i > 0 ? " " : "") + escaped(rule.images[i]);
        }
        text += ":";
        for (const std::string& file : rule.files) {
            const std::string name = escaped(nameFrom(folder, file));
            text += " \\\n  " + name;
            all.insert(name);
        }
        text += "\n";
    }
    for (const std::string& name : all) text += name + ":\n";
    return text;
}

std::string writeDependencies(const std::string& path, const std::vector<DependencyRule>& rules) {
    std::error_code failed;
    const std::filesystem::path folder =
        std::filesystem::canonical(std::filesystem::current_path(failed), failed);
    const std::string text = dependencyText(rules, failed ? "/" : folder.string());
    return writeFile(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace rt
