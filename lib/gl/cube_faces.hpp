// Checks and converts the six pictures of a cube map.
#pragma once

#include <array>
#include <string_view>

#include <passgraph/core/error.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/core/signal.hpp>

#include "gl/objects.hpp"

namespace passgraph::gl {

/// Six faces of 4 channels; guarded, unless that is left out.
/// Errors   cube_face_not_square, cube_face_size, texture_too_large, each naming `subject` and the face.
Result<std::array<Picture, 6>> cube_faces(const std::array<Picture, 6>& faces, Signal signal, std::string_view subject,
                                          const Limits& limits, bool is_guarded = true);

} // namespace passgraph::gl
