// The box around a scene and the camera that sees all of it.
#include "passgraph/scene/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace passgraph {

Bounds bounds(const Scene& scene, const Element& element)
{
    Bounds box;
    const Mesh& mesh = scene.meshes[static_cast<size_t>(element.mesh)];
    std::vector<bool> is_done(mesh.vertices.size(), false);
    for (const std::uint32_t index : mesh.indices) {
        if (is_done[index])
            continue;
        is_done[index] = true;
        const glm::vec3 place(element.world_from_model * glm::dvec4(mesh.vertices[index].position, 1.0f));
        box.low = glm::min(box.low, place);
        box.high = glm::max(box.high, place);
    }
    return box;
}

Bounds bounds(const Scene& scene)
{
    Bounds whole;
    for (const Element& element : scene.elements) {
        const Bounds box = bounds(scene, element);
        whole.low = glm::min(whole.low, box.low);
        whole.high = glm::max(whole.high, box.high);
    }
    return whole;
}

Camera framing_camera(const Bounds& box)
{
    const glm::dvec3 center = box.is_empty() ? glm::dvec3(0.0) : (glm::dvec3(box.low) + glm::dvec3(box.high)) * 0.5;
    const double half_diagonal = box.is_empty() ? 0.0 : glm::length(glm::dvec3(box.high) - glm::dvec3(box.low)) * 0.5;
    const double radius = half_diagonal > 0.0 ? half_diagonal : std::sqrt(3.0);
    Camera camera;
    const double distance = radius / std::sin(static_cast<double>(camera.vertical_fov) * 0.5);
    camera.position = center + glm::dvec3(0.0, 0.0, distance);
    camera.near_plane = static_cast<float>(distance - 1.1 * radius);
    camera.far_plane = static_cast<float>(distance + 1.1 * radius);
    return camera;
}

} // namespace passgraph
