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
/// What a formula may not know of `names` (unknown_name), of which `what` says what they are. True: it knows all.
bool check_names(const Formula& formula, const std::vector<std::string>& names, std::string_view what, Errors& errors);
/// A formula of these names, of which `what` says what they are. Errors: wrong_type, formula_syntax, unknown_name.
std::optional<Formula> read_formula(const Json& text, const std::vector<std::string>& names, std::string_view what, Errors& errors);

// What follows is read after ports, parameters and selections.

/// "needs": facts of the scene without which the pass is not worth running. Errors: unknown_fact.
void read_needs(const Json& needs, PassDeclaration& pass, Errors& errors);
/// "bound": a formula per output, or one for the only output: its largest component. Errors: bound_without_black.
void read_bounds(const Json& bounds, PassDeclaration& pass, Errors& errors);
/// "ignores": a condition per input under which what is wired to it makes no difference.
void read_ignores(const Json& ignores, PassDeclaration& pass, Errors& errors);
/// "identity": when the pass is which of its inputs; one, or an array.
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
