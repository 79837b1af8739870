// Checks a pass's body with glslang and derives how it reads its inputs.
#pragma once

#include "passgraph/core/declaration.hpp"
#include "passgraph/core/error.hpp"

namespace passgraph::shader {

/// Fills `access` of every input.
/// Errors   glsl_error, undeclared_input, entry_missing, entry_signature, input_unused, output_unwritten.
Result<void> check_and_derive(PassDeclaration& pass);

} // namespace passgraph::shader
