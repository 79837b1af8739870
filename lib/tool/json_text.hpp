// A JSON object's text.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace passgraph::tool {

/// What is not UTF-8 in a user's file is replaced, as JSON has no other encoding.
std::string json_text(const nlohmann::ordered_json& json);

} // namespace passgraph::tool
