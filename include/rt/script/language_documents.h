// The scene language as text for people and editors, from the table that checks the arguments.
#pragma once

#include <string>

namespace rt {

/// Every call, field and option with its types, as a definition file of the Lua language server
/// (luals.github.io, "Annotations"): valid Lua that does nothing.
std::string editorStubs();

/// The same as a page of Markdown: Documentation/reference.md.
std::string languageReference();

}  // namespace rt
