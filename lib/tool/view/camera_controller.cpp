// Flight of the camera, integrated exactly.
#include "tool/view/camera_controller.hpp"

#include <algorithm>
#include <cmath>

namespace passgraph::tool::view {
namespace {

constexpr double kRest = 1e-3;                 // of the speed: slower is standing
constexpr double kClosestToUp = 0.0174532925;  // a degree

/// Rodrigues 1840: `v` turned about the unit vector `axis`.
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle)
{
    return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) + axis * (glm::dot(axis, v) * (1.0 - std::cos(angle)));
}

} // namespace

CameraController::CameraController(const Camera& camera, double speed)
    : camera_(camera), up_(glm::normalize(glm::dvec3(camera.up))), position_(camera.position),
      direction_(glm::normalize(glm::dvec3(camera.direction))), speed_(speed)
{
}

glm::dvec3 CameraController::right() const
{
    const glm::dvec3 across = glm::cross(direction_, up_);
    if (glm::dot(across, across) > 1e-18)
        return glm::normalize(across);
    // A file's camera may look straight up: any level axis will do.
    return glm::normalize(glm::cross(direction_, std::abs(up_.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1)));
}

void CameraController::advance(double seconds, const glm::dvec3& wish)
{
    const glm::dvec3 across = right();
    const glm::dvec3 above = glm::cross(across, direction_);
    const double length = glm::length(wish);
    const glm::dvec3 way = length > 1.0 ? wish / length : wish;
    const glm::dvec3 wished = speed_ * (across * way.x + above * way.y - direction_ * way.z);
    // dv/dt = (wished - v) / softness, solved; its integral is the way.
    const double rest = std::exp(-seconds / kSoftness);
    position_ += wished * seconds + (velocity_ - wished) * (kSoftness * (1.0 - rest));
    velocity_ = wished + (velocity_ - wished) * rest;
    if (length == 0.0 && glm::length(velocity_) < kRest * speed_) {
        position_ += velocity_ * kSoftness; // all that it would still have gone
        velocity_ = glm::dvec3(0.0);
    }
}

void CameraController::turn(double pixels_right, double pixels_down, int picture_height)
{
    const double per_pixel = static_cast<double>(camera_.vertical_fov) / std::max(picture_height, 1);
    direction_ = glm::normalize(turned(direction_, up_, pixels_right * per_pixel));
    const double from_up = std::acos(std::clamp(glm::dot(direction_, up_), -1.0, 1.0));
    const double wanted = std::clamp(from_up - pixels_down * per_pixel, kClosestToUp, 3.14159265358979 - kClosestToUp);
    direction_ = glm::normalize(turned(direction_, right(), from_up - wanted));
}

Camera CameraController::camera() const
{
    Camera camera = camera_;
    camera.position = position_;
    camera.direction = glm::vec3(direction_);
    return camera;
}

} // namespace passgraph::tool::view
