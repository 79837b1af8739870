// The camera's block, and elements and lights as the camera sees them, in double precision until the last step.
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <passgraph/core/glsl_interface.hpp>
#include <passgraph/scene/atlas.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph::gl {

/// A camera taken apart so that nothing large is added to anything small in single precision.
struct View {
    glm::dmat3 rotation{1.0}; ///< view from world, directions
    glm::dvec3 position{0.0}; ///< of the camera, world space, metres
    glsl::CameraBlock block{};
};

/// `has_clip_control`: clip space depth runs 0..1 as it is; without, it is stretched to -1..1, reversed all the same.
View view_of(const Camera& camera, Extent extent, bool has_clip_control);

bool same_camera(const Camera& a, const Camera& b);

/// The cofactors of a 3x3 matrix (its adjugate's transpose) times the sign of its determinant: what takes a normal
/// along.
///
/// Range    any finite matrix, singular, mirrored, huge or tiny; the result is finite, its largest element is 1 in
/// size.
///          A matrix of rank 1 or 0, which leaves no surface, gives the identity.
/// Source   own derivation: for invertible M, cof(M) = det(M) M^-T, so sign(det) cof(M) is M^-T up to a positive
/// factor.
glm::dmat3 normal_matrix(const glm::dmat3& matrix);

/// True when the transform turns a left hand into a right one.
bool is_mirrored(const glm::dmat3& matrix);

/// Shape    glsl::kElementRows rows per element of the scene.
std::vector<glm::vec4> element_rows(const Scene& scene, const Atlas& atlas, const View& view);

/// Shape    glsl::kAtlasLevelCount rectangles per element, the last level repeated.
std::vector<glm::vec4> element_levels(const Scene& scene, const Atlas& atlas);

/// 1 / radius^2, rounded up so that the product with any square of binary32 that reaches radius^2 reaches 1.
/// Range    radius > 0; infinite where the square underflows, which leaves the light without reach.
float per_radius_squared(float radius);

/// What the cone of a light leaves of it: glsl::kLightTexels' third texel.
glm::vec4 cone_texel(const Light& light, const glm::dmat3& rotation);

/// Shape    glsl::kLightTexels RGBA texels per light of `order`, which names the scene's.
std::vector<glm::vec4> light_texels(const Scene& scene, const std::vector<int>& order, const View& view);

} // namespace passgraph::gl
