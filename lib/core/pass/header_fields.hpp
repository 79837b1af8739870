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

/// "contract": what the pass promises of its values; after its ports, parameters and selections.
void read_contract(const Json& contract, PassDeclaration& pass, Errors& errors);
/// "identity": under which parameters the pass is which of its inputs; after its ports.
void read_identity(const Json& identity, PassDeclaration& pass, Errors& errors);
/// "black": which inputs being 0 everywhere make an output 0 everywhere; after its ports.
void read_black(const Json& black, PassDeclaration& pass, Errors& errors);
/// "skip": a condition under which a pixel of the only output is 0; after its ports.
void read_skip(const Json& skip, PassDeclaration& pass, Errors& errors);

/// The pass can be the input that `named` names: one output, of its signal and extent. Else unknown_input, identity_mismatch.
void check_is_input(const Json& named, const PassDeclaration& pass, Errors& errors);

/// Reports a name that GLSL or generated code keeps for itself (reserved_name).
void check_name(const std::string& name, std::string_view what, const Location& where, Errors& errors);

} // namespace passgraph::header
