// Settings by name: parameters, choices, rungs and codecs of a node, checked against its declaration.
#pragma once

#include "passgraph/core/graph.hpp"

namespace passgraph {

/// The names of a pass's parameters, choices and ladders.
std::vector<std::string> setting_names(const PassDeclaration& pass);

/// A node of a pass with everything at its default and nothing wired.
GraphNode node_of(PassPtr pass, std::string name, const Location& where);

/// Sets a parameter, choice or rung of the node.
/// Errors   unknown_param, wrong_type, param_out_of_range, unknown_item; the node then keeps what it had.
void apply_setting(GraphNode& node, const PassArguments::Setting& setting, Errors& errors);

/// Chooses the codec `setting.item` for the output `setting.name`. Errors: unknown_image, unknown_codec.
void apply_codec(GraphNode& node, const PassArguments::Setting& setting, Errors& errors);

} // namespace passgraph
