#include "shell_completion.h"

#include "rt/app/options.h"
#include "rt/core/text.h"

#include <vector>

namespace rt {

namespace {

struct SubCommand {
    const char* name;
    Command command;
    const char* does;
};

constexpr SubCommand kSubCommands[] = {
    {"compare", Command::kCompare, "shows how two images differ"},
    {"merge", Command::kMerge, "joins the parts of a picture"},
    {"golden", Command::kGolden, "holds scenes against their images"},
};

/// All spellings, with spaces between them.
std::string allFlags(Command command) {
    std::vector<std::string> all;
    for (const OptionHelp& row : optionHelp(command)) {
        all.insert(all.end(), row.spellings.begin(), row.spellings.end());
    }
    return joined(all, " ");
}

// bash

std::string bashCase(const OptionHelp& row) {
    if (row.valueName.empty()) return "";
    std::string body = "return ;;";
    if (!row.choices.empty()) {
        body =
            "COMPREPLY=($(compgen -W '" + joined(row.choices, " ") + "' -- \"$cur\")); return ;;";
    } else if (row.valueName == "FILE") {
        body = "compopt -o filenames; COMPREPLY=($(compgen -f -- \"$cur\")); return ;;";
    } else if (row.valueName == "DIR") {
        body = "compopt -o filenames; COMPREPLY=($(compgen -d -- \"$cur\")); return ;;";
    }
    return "        " + joined(row.spellings, "|") + ") " + body + "\n";
}

std::string bashCases() {
    std::string text;
    for (const OptionHelp& row : optionHelp()) text += bashCase(row);
    return text;
}

// zsh

/// Text inside brackets inside single quotes of a specification of _arguments.
std::string zshText(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\'') {
            safe += "'\\''";
        } else {
            if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
            safe += c;
        }
    }
    return safe;
}

std::string zshAction(const OptionHelp& row) {
    if (!row.choices.empty()) return "(" + joined(row.choices, " ") + ")";
    if (row.valueName == "FILE") return "_files";
    if (row.valueName == "DIR") return "_files -/";
    return " ";
}

/// The specifications of a command's options, a line each.
std::string zshOptions(Command command) {
    std::string text;
    for (const OptionHelp& row : optionHelp(command)) {
        for (const std::string& flag : row.spellings) {
            const bool isLong = flag.compare(0, 2, "--") == 0;
            std::string spec = "*" + flag;
            if (!row.valueName.empty()) spec += isLong ? "=" : "+";
            spec += "[" + zshText(row.text) + "]";
            if (!row.valueName.empty()) {
                spec += ":" + zshText(row.valueName) + ":" + zshAction(row);
            }
            text += "        '" + spec + "' \\\n";
        }
    }
    return text;
}

}  // namespace

std::string bashCompletion() {
    std::string commands;
    std::vector<std::string> names;
    for (const SubCommand& sub : kSubCommands) {
        names.emplace_back(sub.name);
        commands +=
            "        " + std::string(sub.name) + ") flags='" + allFlags(sub.command) + "' ;;\n";
    }
    return "# bash completion of Project, made by `Project --print bash-completion`\n"
           "_Project() {\n"
           "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} flags\n"
           "    # bash takes --option=value for three words.\n"
           "    if [ \"$cur\" = = ]; then\n"
           "        cur=\n"
           "    elif [ \"$prev\" = = ]; then\n"
           "        prev=${COMP_WORDS[COMP_CWORD-2]}\n"
           "    fi\n"
           "    case $prev in\n" +
           bashCases() +
           "    esac\n"
           "    case ${COMP_WORDS[1]} in\n" +
           commands + "        *) flags='" + allFlags(Command::kRender) +
           "' ;;\n"
           "    esac\n"
           "    if [ \"${cur:0:1}\" = - ]; then\n"
           "        COMPREPLY=($(compgen -W \"$flags\" -- \"$cur\"))\n"
           "        return\n"
           "    fi\n"
           "    compopt -o filenames\n"
           "    COMPREPLY=($(compgen -f -- \"$cur\"))\n"
           "    if [ \"$COMP_CWORD\" = 1 ]; then\n"
           "        COMPREPLY+=($(compgen -W '" +
           joined(names, " ") +
           "' -- \"$cur\"))\n"
           "    fi\n"
           "}\n"
           "complete -F _Project Project\n";
}

std::string zshCompletion() {
    std::string commands;
    std::string described;
    for (const SubCommand& sub : kSubCommands) {
        described += " '" + std::string(sub.name) + ":" + sub.does + "'";
        commands += "    " + std::string(sub.name) + ")\n        _arguments -s \\\n" +
                    zshOptions(sub.command) + "        '*:file:_files'\n        return ;;\n";
    }
    return "#compdef Project\n"
           "# zsh completion of Project, made by `Project --print zsh-completion`\n"
           "_Project() {\n"
           "    local -a commands=(" +
           described +
           " )\n"
           "    case $words[2] in\n" +
           commands +
           "    esac\n"
           "    (( CURRENT == 2 )) && _describe command commands\n"
           "    _arguments -s \\\n" +
           zshOptions(Command::kRender) +
           "        '*:scene:_files'\n"
           "}\n"
           "_Project \"$@\"\n";
}

}  // namespace rt
