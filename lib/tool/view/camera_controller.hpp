// A camera that a person flies: keys push it, the mouse turns it.
#pragma once

#include <glm/glm.hpp>

#include <passgraph/scene/scene.hpp>

namespace passgraph::tool::view {

/// Speeds up and slows down softly: the velocity goes towards the wished one exponentially, and place and velocity are
/// integrated in closed form, so that one step of a second and sixty of 1/60 s end at the same place up to rounding.
class CameraController {
public:
    /// Seconds after which 1 - 1/e of a wished change of velocity is done.
    static constexpr double kSoftness = 0.09;

    /// Units    `speed` in metres per second.
    CameraController(const Camera& camera, double speed);

    /// Goes on by some seconds. `wish` points to the right, up and back in the camera's own axes, of length up to 1; a
    /// longer one (a diagonal of keys) is shortened to 1.
    void advance(double seconds, const glm::dvec3& wish);

    /// Turns by a way of the pointer: a picture's height turns by the field of view, so that what is grabbed stays below
    /// the pointer. Never looks closer than a degree to straight up or down.
    void turn(double pixels_right, double pixels_down, int picture_height);

    bool is_moving() const { return velocity_ != glm::dvec3(0.0); }
    Camera camera() const;
    void set_speed(double speed) { speed_ = speed; }

private:
    glm::dvec3 right() const;

    Camera camera_; ///< field of view and planes; place and direction are kept in double
    glm::dvec3 up_;
    glm::dvec3 position_;
    glm::dvec3 direction_;
    glm::dvec3 velocity_{0.0};
    double speed_;
};

} // namespace passgraph::tool::view
