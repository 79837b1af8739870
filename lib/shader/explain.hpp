// What an author forgot in the header, from what glslang says of the body.
#pragma once

#include "passgraph/core/declaration.hpp"
#include "passgraph/core/error.hpp"

namespace passgraph::shader {

/// Turns glslang's "'glow' : no matching overloaded function found" into what the author forgot in the header.
void explain(Error& error, const PassDeclaration& pass);

} // namespace passgraph::shader
