// A pass's declaration, for people and for programs.
#pragma once

#include <string>

#include <passgraph/core/declaration.hpp>
#include <passgraph/core/pass_library.hpp>

namespace passgraph::tool {

/// Everything there is to know before using the pass; lines end with a newline.
std::string pass_page(const PassDeclaration& pass);
/// Summary, ports and settings in three or four lines.
std::string pass_entry(const PassDeclaration& pass);
/// The same as a JSON object; its schema is describe.schema.json.
std::string pass_json(const PassDeclaration& pass);
/// All passes of the library; the schema is passes.schema.json.
std::string passes_json(const PassLibrary& library);

} // namespace passgraph::tool
