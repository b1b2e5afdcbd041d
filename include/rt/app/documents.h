// Texts about the program, made from its own tables: for --print.
#pragma once

#include <string>
#include <vector>

namespace rt {

/// stubs, reference, man, bash-completion, zsh-completion.
const std::vector<std::string>& documentNames();

/// One of those. Stubs and reference: rt/script/language_documents.h. A manual page in the macros
/// of man(7), and completions for the shells.
std::string documentText(const std::string& name);

}  // namespace rt
