// The parts of a pass header, each read by one function into the declaration.
#pragma once

#include "passgraph/core/declaration.hpp"
#include "passgraph/core/json.hpp"

namespace passgraph::header {

/// "inputs": ports by name, in short ("radiance") or long form.
void read_inputs(const Json& inputs, PassDeclaration& pass, Errors& errors);
/// "outputs": ports by name, with their size rules.
void read_outputs(const Json& outputs, PassDeclaration& pass, Errors& errors);
/// "params": parameters by name, in short (0.5) or long form.
void read_params(const Json& params, PassDeclaration& pass, Errors& errors);
/// "choices" or "ladders": static selections by name.
void read_selections(const Json& selections, Selection::Kind kind, PassDeclaration& pass, Errors& errors);
/// A port's "filter" by the items of a selection must name one of the pass's, and items it has.
void check_filters(const PassDeclaration& pass, Errors& errors);
/// "layouts" of a geometry pass: targets, and places or a derivation per output; adds the selection "layout".
void read_layouts(const Json& layouts, PassDeclaration& pass, Errors& errors);

/// Reports a name that GLSL or generated code keeps for itself (reserved_name).
void check_name(const std::string& name, std::string_view what, const Location& where, Errors& errors);

} // namespace passgraph::header
