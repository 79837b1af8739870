// From a camera to the matrices that put world space on the screen.
#pragma once

#include <glm/glm.hpp>

#include <passgraph/core/picture.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph {

/// Columns are images of axes: clip = clip_from_view * view_from_world * world.
struct CameraMatrices {
    glm::mat4 view_from_world{1.0f};
    glm::mat4 clip_from_view{1.0f};
};

/// The camera's matrices for a picture of this extent.
///
/// Shape    right-handed view space: +X right, +Y up, -Z forward.
/// Units    metres; `vertical_fov` in radians.
/// Range    depth after division is 1 at the near plane and 0 at the far plane: reversed, for
///          glClipControl(…, GL_ZERO_TO_ONE). An `up` along `direction` is replaced by the axis furthest from it.
///          Each entry is the double result rounded once, so a far-away camera is as exact as its position.
/// Errors   none; asserts 0 < near < far, 0 < vertical_fov < pi, a direction of some length, an extent of some texels.
/// Cost     constant.
/// Source   Upchurch and Desbrun 2012, "Tightening the precision of perspective rendering" (reversed depth).
CameraMatrices matrices(const Camera& camera, Extent extent);

} // namespace passgraph
