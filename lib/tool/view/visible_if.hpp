// The conditions under which a header wants a parameter shown.
#pragma once

#include <string>

#include <passgraph/core/graph.hpp>

namespace passgraph::tool::view {

/// What a `visible_if` says of a node's values: comparisons of parameters and selections with numbers or items
/// (`amount > 0`, `shape == circle`), a flag's name alone, joined by `&&` and `||` (which binds less), `!` in front.
///
/// Range    an empty text, and one that cannot be understood, is "visible": better to show too much.
bool is_visible(const std::string& visible_if, const GraphNode& node);

} // namespace passgraph::tool::view
