// GLSL of what the frame offers a pass, where some of it is flat.
#pragma once

#include <string>
#include <string_view>

#include "core/glsl/flat.hpp"
#include "passgraph/core/glsl_interface.hpp"

namespace passgraph::glsl {

/// The camera's block; its members are global where the instance has no name.
std::string camera_block(std::string_view instance);

/// How many rows of lights are uniforms.
int light_rows(const Reads& reads, const Facts& facts);

std::string accessors(const Reads& reads, PassKind kind, const Facts& facts, const Flats& flats);

} // namespace passgraph::glsl
