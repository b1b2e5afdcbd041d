#include "manual_page.h"

#include "rt/app/options.h"
#include "rt/core/version.h"

namespace rt {

namespace {

constexpr const char* kDate = "2026-11-27";  // of the words below

/// Plain text for roff: no escape, no hyphen that becomes a dash, no control line.
std::string roff(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\\') {
            safe += "\\e";
        } else if (c == '-') {
            safe += "\\-";
        } else if ((c == '.' || c == '\'') && safe.empty()) {
            safe += std::string("\\&") + c;
        } else {
            safe += c;
        }
    }
    return safe;
}

std::string entry(const OptionHelp& row) {
    std::string text = ".TP\n\\fB" + roff(row.flags) + "\\fR";
    if (!row.valueName.empty()) text += " \\fI" + roff(row.valueName) + "\\fR";
    return text + "\n" + roff(row.text) + "\n";
}

std::string optionSections(const std::vector<OptionHelp>& rows) {
    std::string text;
    std::string section;
    for (const OptionHelp& row : rows) {
        if (row.section != section) text += ".SS " + roff(row.section) + "\n";
        section = row.section;
        text += entry(row);
    }
    return text;
}

std::string ownOptions(const char* section, Command command) {
    std::string text;
    for (const OptionHelp& row : optionHelp(command)) {
        if (row.section == section) text += entry(row);
    }
    return text;
}

constexpr const char* kSynopsis = R"(.SH SYNOPSIS
.B Project
.RI [ scene.lua " ...] [" options "] [\-\- " "script arguments" ]
.br
.B Project compare
.I A B
.RB [ \-\-tolerance
.IR E ]
.br
.B Project merge
.I OUT PART ...
.br
.B Project golden
.I DIR
.RI [ options ]
.SH DESCRIPTION
.B Project
runs scene scripts written in Lua 5.3 and renders the pictures that they ask for, as exact as
.B \-\-error
says, with the same bytes for any number of threads.
Without a scene,
.I project.lua
of the current folder is rendered.
A scene named
.B \-
is read from standard input.
)";

constexpr const char* kCompare = R"(.SH COMMANDS
.SS compare A B
Shows how two images differ, and ends with 10 if they differ by more than the tolerance.
)";

constexpr const char* kMerge = R"(.SS merge OUT PART...
Joins the parts that
.B \-\-shard
wrote to the picture that a single run writes, byte for byte.
)";

constexpr const char* kGolden = R"(.SS golden DIR
Renders every scene of a folder and holds it against the image beside it.
Options of a render count too.
)";

constexpr const char* kRest = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
the scene: a script, one of its calls, or an asset; with
.B \-\-werror
a warning, too
.TP
.B 2
usage
.TP
.B 3
output: a file cannot be written
.TP
.B 4
a limit on time, memory, pixels, objects or frames
.TP
.B 5
an internal error
.TP
.B 10
a comparison failed
.TP
.B 128+n
ended by signal n
.SH EXAMPLES
.TP
.B Project scene.lua \-o picture.png
Renders a scene into a file.
.TP
.B Project scene.lua \-\-watch \-\-preview
Renders again whenever the scene changes, and shows the picture in a browser.
.TP
.B Project animation.lua \-\-frames 1\-48 \-o 'frame_###.png'
Renders the frames of an animation.
.TP
.B Project scene.lua \-\-list\-params
Shows what
.B \-D
can set.
)";

}  // namespace

std::string manualPage() {
    return std::string(".TH PROJECT 1 ") + kDate + " \"" + kProgramName + " " + kProgramVersion +
           "\" \"User Commands\"\n.SH NAME\n" + kProgramName +
           " \\- render scenes that are written in Lua\n" + kSynopsis + ".SH OPTIONS\n" +
           optionSections(optionHelp(Command::kRender)) + kCompare +
           ownOptions("Compare", Command::kCompare) + kMerge + kGolden +
           ownOptions("Golden", Command::kGolden) + kRest;
}

}  // namespace rt
