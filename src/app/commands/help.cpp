#include "rt/app/commands.h"
#include "rt/app/documents.h"
#include "rt/core/error.h"

#include <cstdio>

namespace rt {
namespace {

int print(const std::string& text) {
    const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
    return static_cast<int>(written ? ExitCode::kDone : ExitCode::kOutput);
}

}  // namespace

int helpCommand() {
    return print(helpText());
}

int printCommand(const Options& options) {
    return print(documentText(options.document));
}

int versionCommand() {
    return print(versionText());
}

}  // namespace rt
