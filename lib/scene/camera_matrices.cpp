// View and projection, computed in double and rounded once.
#include "passgraph/scene/camera_matrices.hpp"

#include <cassert>
#include <cmath>

namespace passgraph {
namespace {

/// The coordinate axis with the largest angle to `direction`.
glm::dvec3 axis_across(const glm::dvec3& direction)
{
    const glm::dvec3 size = glm::abs(direction);
    if (size.y <= size.x && size.y <= size.z)
        return {0.0, 1.0, 0.0};
    return size.z <= size.x ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
}

glm::dmat4 view_from_world(const Camera& camera)
{
    const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.direction));
    glm::dvec3 right = glm::cross(forward, glm::dvec3(camera.up));
    if (glm::length(right) == 0.0)
        right = glm::cross(forward, axis_across(forward));
    right = glm::normalize(right);
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3& position = camera.position;
    glm::dmat4 view(1.0);
    for (int column = 0; column < 3; ++column)
        view[column] = {right[column], up[column], -forward[column], 0.0};
    view[3] = {-glm::dot(right, position), -glm::dot(up, position), glm::dot(forward, position), 1.0};
    return view;
}

/// depth(z) = (A z + B) / -z with depth(-near) = 1 and depth(-far) = 0.
glm::dmat4 clip_from_view(const Camera& camera, Extent extent)
{
    const double near = camera.near_plane;
    const double far = camera.far_plane;
    const double scale = 1.0 / std::tan(static_cast<double>(camera.vertical_fov) * 0.5);
    glm::dmat4 clip(0.0);
    clip[0][0] = scale * extent.height / extent.width;
    clip[1][1] = scale;
    clip[2][2] = near / (far - near);
    clip[2][3] = -1.0;
    clip[3][2] = near * far / (far - near);
    return clip;
}

} // namespace

CameraMatrices matrices(const Camera& camera, Extent extent)
{
    assert(extent.width > 0 && extent.height > 0);
    assert(glm::length(glm::dvec3(camera.direction)) > 0.0);
    assert(camera.near_plane > 0.0f && camera.near_plane < camera.far_plane);
    assert(camera.vertical_fov > 0.0f && camera.vertical_fov < 3.14159274f);
    return {glm::mat4(view_from_world(camera)), glm::mat4(clip_from_view(camera, extent))};
}

} // namespace passgraph
