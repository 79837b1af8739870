// Writes the C++ struct of a pass: its parameters as members, its ports as typed images.
#pragma once

#include <string>

#include "passgraph/core/declaration.hpp"

namespace passgraph::bake {

/// The definition of one pass's struct, for the generated header passgraph/passes.hpp.
std::string cpp_struct(const PassDeclaration& pass);

} // namespace passgraph::bake
