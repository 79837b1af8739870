// The "camera" of a scene file.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "scene_fields.hpp"

namespace passgraph::scene_file {
namespace {

constexpr double kLargest = std::numeric_limits<float>::max();
// Sine of the least angle between up and direction: below it, float rounding turns the picture.
constexpr double kLeastAngle = 1e-4;
// Reversed depth at the distance d is near (far - d) / ((far - near) d). At a larger ratio of far to near it falls
// below the least normal binary32, which GPUs take for 0, and 0 is the sky; so does the square of a smaller distance.
constexpr double kNearest = 1e-15;
constexpr double kLargestRatio = 1e30;
// Radians; a smaller field of view magnifies more than a float can place.
constexpr double kLeastView = 1e-6;

/// Either "direction", or "target" seen from `position`. Nothing when neither can be used.
bool read_direction(JsonFields& fields, const Json& json, const Camera& camera, glm::dvec3& direction, Errors& errors)
{
    glm::dvec3 given(0.0);
    const Json* target = fields.find("target");
    if (fields.find("direction")) {
        if (target) {
            errors.push_back({"value_out_of_range", "the camera has both a \"direction\" and a \"target\"",
                              "keep one of them", target->where});
        }
        if (!vector_of(fields, "direction", given, false) || !has_length(fields, "direction", given, errors))
            return false;
        direction = glm::normalize(given);
        return true;
    }
    if (!target) {
        errors.push_back({"field_missing", "camera lacks \"direction\"", "or give a \"target\" to look at", json.where});
        return false;
    }
    if (!vector_of(fields, "target", given, false))
        return false;
    if (given == camera.position) {
        out_of_range(*target, "the camera's \"target\" is its \"position\", so it looks nowhere", errors);
        return false;
    }
    direction = glm::normalize(given - camera.position);
    return true;
}

void read_planes(JsonFields& fields, Camera& camera, Errors& errors)
{
    const size_t before = errors.size();
    camera.near_plane = number_in(fields, "near", camera.near_plane, {kNearest, kLargest}, errors);
    camera.far_plane = number_in(fields, "far", camera.far_plane, {0.0, kLargest, true}, errors);
    if (errors.size() != before)
        return;
    const Json* blamed = fields.find("near") ? fields.find("near") : fields.find("far");
    if (!(camera.near_plane < camera.far_plane)) {
        out_of_range(*blamed,
                     fmt::format("the camera's \"near\" plane, {}, is not before its \"far\" plane, {}",
                                 camera.near_plane, camera.far_plane),
                     errors);
    } else if (static_cast<double>(camera.far_plane) / static_cast<double>(camera.near_plane) > kLargestRatio) {
        out_of_range(*blamed,
                     fmt::format("the camera's \"far\" plane, {}, is more than {} times its \"near\" plane, {}",
                                 camera.far_plane, kLargestRatio, camera.near_plane),
                     errors, "no depth buffer tells places so far apart from the sky");
    }
}

} // namespace

Camera read_camera(const Json& json, Errors& errors)
{
    JsonFields fields(json, "camera", errors);
    Camera camera;
    const bool is_placed = vector_of(fields, "position", camera.position, true);
    glm::dvec3 direction(0.0, 0.0, -1.0);
    const bool has_direction = read_direction(fields, json, camera, direction, errors) && is_placed;
    const bool has_up = !vector_of(fields, "up", camera.up, false) || has_length(fields, "up", camera.up, errors);
    if (has_up && has_direction) {
        glm::dvec3 up = glm::normalize(glm::dvec3(camera.up));
        if (glm::length(glm::cross(up, direction)) < kLeastAngle) {
            // Straight down like a map, -Z on top; straight up the same way round.
            const Json* blamed = fields.find("up");
            up = glm::dvec3(0.0, 0.0, direction.y < 0.0 ? -1.0 : 1.0);
            if (blamed)
                out_of_range(*blamed, "the camera's \"up\" is parallel to where it looks", errors,
                             "an up across the direction says which way the picture is turned; without one, straight down has -Z on top");
        }
        camera.up = glm::vec3(up);
    }
    camera.direction = glm::vec3(direction);
    const float degrees = number_in(fields, "vertical_fov_degrees", 45.0f, {0.0, 180.0, true}, errors);
    camera.vertical_fov = static_cast<float>(std::max(glm::radians(static_cast<double>(degrees)), kLeastView));
    read_planes(fields, camera, errors);
    fields.finish();
    return camera;
}

} // namespace passgraph::scene_file
