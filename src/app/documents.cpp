#include "rt/app/documents.h"

#include "manual_page.h"
#include "rt/core/error.h"
#include "rt/script/language_documents.h"
#include "shell_completion.h"

namespace rt {

namespace {

struct Document {
    const char* name;
    std::string (*text)();
};

constexpr Document kDocuments[] = {
    {"stubs", editorStubs},
    {"reference", languageReference},
    {"man", manualPage},
    {"bash-completion", bashCompletion},
    {"zsh-completion", zshCompletion},
};

}  // namespace

const std::vector<std::string>& documentNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const Document& document : kDocuments) all.emplace_back(document.name);
        return all;
    }();
    return names;
}

std::string documentText(const std::string& name) {
    for (const Document& document : kDocuments) {
        if (document.name == name) return document.text();
    }
    throw UsageError("no document is named " + name);
}

}  // namespace rt
