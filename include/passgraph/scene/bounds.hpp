// The box around a scene.
#pragma once

#include <limits>

#include <glm/glm.hpp>

#include <passgraph/scene/scene.hpp>

namespace passgraph {

/// An axis-aligned box in world space, metres; empty while `low` is above `high`.
struct Bounds {
    glm::vec3 low{std::numeric_limits<float>::infinity()};
    glm::vec3 high{-std::numeric_limits<float>::infinity()};

    bool is_empty() const { return low.x > high.x; }
};

/// The smallest box around every vertex that some element's triangles use.
///
/// Units    metres, world space.
/// Range    empty when no element has a triangle; otherwise contains each vertex as rounded to float.
/// Errors   none
/// Cost     O(indices of all elements).
/// Source   own derivation: the minimum and maximum of the transformed vertices.
Bounds bounds(const Scene& scene);

/// The same of one element.
/// Cost     O(its indices).
Bounds bounds(const Scene& scene, const Element& element);

/// The camera of a scene file that names none: looks along -Z at the box's center, 45 degrees high, the sphere around
/// the box just inside the vertical field of view, the planes a tenth further out than that sphere.
///
/// Units    metres, radians.
/// Range    an empty box, or one of a single point, is taken as the cube of side 2 around the origin, or that point.
/// Errors   none
/// Cost     constant.
/// Source   own derivation: a sphere of radius r touches a cone of half angle a at the distance r / sin(a).
Camera framing_camera(const Bounds& box);

} // namespace passgraph
