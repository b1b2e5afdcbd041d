#include "rt/script/parameter_file.h"

#include "rt/core/diagnostics.h"
#include "rt/core/error.h"
#include "rt/core/input_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>

namespace rt {

namespace {

constexpr std::size_t kShown = 64;
constexpr const char* kBlanks = " \t\r";

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// The position behind the quote that ends what begins at `start`; npos without one.
std::size_t endOfQuoted(const std::string& text, std::size_t start) {
    for (std::size_t i = start + 1; i < text.size(); ++i) {
        if (text[i] == '\\') {
            ++i;
        } else if (text[i] == '"') {
            return i + 1;
        }
    }
    return std::string::npos;
}

/// What \x.. or another escape at text[i] means; i is moved to its last character.
std::optional<char> escaped(const std::string& text, std::size_t& i) {
    constexpr std::array<std::array<char, 2>, 5> kEscapes{
        {{'"', '"'}, {'\\', '\\'}, {'n', '\n'}, {'r', '\r'}, {'t', '\t'}}};
    for (const auto& [written, meant] : kEscapes) {
        if (text[i] == written) return meant;
    }
    if (text[i] != 'x' || i + 2 >= text.size()) return std::nullopt;
    unsigned char byte = 0;
    const char* first = text.data() + i + 1;
    const auto parsed = std::from_chars(first, first + 2, byte, 16);
    if (parsed.ptr != first + 2) return std::nullopt;
    i += 2;
    return static_cast<char>(byte);
}

/// A bare or quoted word, all of `text`; nothing where quotes or escapes are wrong.
std::optional<std::string> unquoted(const std::string& text) {
    if (text.empty() || text[0] != '"') return text;
    if (endOfQuoted(text, 0) != text.size()) return std::nullopt;
    std::string value;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        if (text[i] != '\\') {
            value += text[i];
            continue;
        }
        const std::optional<char> meant = escaped(text, ++i);
        if (!meant) return std::nullopt;
        value += *meant;
    }
    return value;
}

GivenParameter parseLine(const std::string& line, const SourceLocation& where) {
    const bool isQuoted = line[0] == '"';
    const std::size_t end = isQuoted ? endOfQuoted(line, 0) : 0;
    const std::size_t equals = end == std::string::npos ? end : line.find('=', end);
    if (equals == std::string::npos || equals == 0) {
        throw SceneError("'" + printable(line, kShown) + "' must be name = value", where);
    }
    const auto name = unquoted(trimmed(line.substr(0, equals)));
    const auto value = unquoted(trimmed(line.substr(equals + 1)));
    if (!name || !value) {
        throw SceneError("'" + printable(line, kShown) +
                             "' has quotes that do not match or an escape that is none of \\\" "
                             "\\\\ \\n \\r \\t \\xHH",
                         where);
    }
    return {*name, *value, where};
}

bool isControl(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// Whether a word reads back as it is.
bool isBare(const std::string& text) {
    return !text.empty() && text == trimmed(text) && text[0] != '"' && text[0] != '#' &&
           std::none_of(text.begin(), text.end(), isControl) &&
           printable(text, text.size()) == text;
}

/// A comment for each line of a sentence.
std::string commented(const std::string& doc) {
    std::string text = "# ";
    for (const char c : printable(doc)) {
        text += c;
        if (c == '\n') text += "# ";
    }
    return text + "\n";
}

std::string quotedText(const std::string& text) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += std::string("\\") + c;
        } else if (byte < 0x20 || byte >= 0x7f) {
            quoted += std::string("\\x") + kDigits[byte >> 4] + kDigits[byte & 15];
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

}  // namespace

std::string GivenParameter::text() const {
    const std::string shownName = printable(name, kShown);
    const std::string shownValue = printable(value, kShown);
    if (where.file.empty()) return "-D " + shownName + "=" + shownValue;
    return shownName + " = " + shownValue + " (" + printable(where.file, 256) + ":" +
           std::to_string(where.line) + ")";
}

std::vector<GivenParameter> readParameterFile(const std::string& path, std::size_t most) {
    InputFile file(path);
    if (file.size() > most) {
        throw LimitError(
            "the parameters are more than " + std::to_string(most) + " bytes (see --script-memory)",
            {path, 0});
    }
    const std::vector<std::uint8_t> bytes = file.readAll();
    const std::string text(bytes.begin(), bytes.end());
    std::vector<GivenParameter> all;
    std::map<std::string, int> lineOf;
    int number = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = trimmed(text.substr(at, end - at));
        const SourceLocation where{path, ++number};
        at = end + 1;
        if (line.empty() || line[0] == '#') continue;
        all.push_back(parseLine(line, where));
        const auto [first, isNew] = lineOf.emplace(all.back().name, number);
        if (isNew) continue;
        throw SceneError("'" + printable(all.back().name, kShown) + "' is set in line " +
                             std::to_string(first->second) + " already",
                         where);
    }
    return all;
}

std::string parameterFileText(const std::vector<ScriptParameter>& parameters) {
    std::string text;
    for (const ScriptParameter& parameter : parameters) {
        const std::string& name = parameter.name;
        if (!parameter.doc.empty()) text += commented(parameter.doc);
        const bool plainName = isBare(name) && name.find('=') == std::string::npos;
        text += (plainName ? name : quotedText(name)) + " = " +
                (isBare(parameter.value) ? parameter.value : quotedText(parameter.value)) + "\n";
    }
    return text;
}

}  // namespace rt
