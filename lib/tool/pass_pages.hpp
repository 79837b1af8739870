// A pass's declaration, for people and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <passgraph/core/declaration.hpp>

namespace passgraph::tool {

/// Everything there is to know before using the pass; lines end with a newline.
std::string pass_page(const PassDeclaration& pass);
/// Summary, ports and settings in three or four lines.
std::string pass_entry(const PassDeclaration& pass);
/// The same as an object; its schema is pass.schema.json.
nlohmann::ordered_json pass_json(const PassDeclaration& pass);

/// The object's text. What is not UTF-8 in a user's file is replaced, as JSON has no other encoding.
std::string json_text(const nlohmann::ordered_json& json);

} // namespace passgraph::tool
