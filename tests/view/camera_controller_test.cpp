// The camera's flight: the same way at every frame rate, soft, and never upside down.
#include <cmath>

#include "support/catch.hpp"
#include "tool/view/camera_controller.hpp"

using namespace passgraph;
using passgraph::tool::view::CameraController;

namespace {

CameraController still(double speed = 60.0)
{
    Camera camera;
    camera.position = {3.0f, 2.0f, 1.0f};
    camera.direction = {0.3f, -0.4f, -1.0f};
    return CameraController(camera, speed);
}

double distance(const Camera& a, const Camera& b)
{
    return static_cast<double>(glm::length(glm::dvec3(a.position) - glm::dvec3(b.position)));
}

} // namespace

TEST_CASE("many small steps end where a few large ones do", "[view][camera]")
{
    const glm::dvec3 wish(1.0, 0.5, -1.0);
    CameraController large = still();
    large.advance(0.5, wish);
    large.advance(0.25, {});
    for (const int steps : {2, 7, 60, 1000}) {
        CameraController small = still();
        for (int i = 0; i < steps; ++i)
            small.advance(0.5 / steps, wish);
        for (int i = 0; i < steps; ++i)
            small.advance(0.25 / steps, {});
        CAPTURE(steps);
        // The closed form is exact, so that only roundings differ: two of a double in each step, of numbers below 64; and the
        // camera's place is rounded to a float at the end, 2 * 2^-24 * 64. Coming to rest early skips less than 1e-3 of the
        // speed for a kSoftness, and adds what it skips.
        const double bound = 2.0 * steps * 64.0 * 0x1p-52 + 2.0 * 64.0 * 0x1p-24;
        CHECK(distance(small.camera(), large.camera()) <= bound);
    }
}

TEST_CASE("a flight speeds up to its speed and slows down to a stop", "[view][camera]")
{
    CameraController flight = still(10.0);
    flight.advance(0.01, {0, 0, -1});
    const double first = distance(flight.camera(), still().camera());
    CHECK(first < 0.1 * 0.2); // full speed would have gone 0.1; after 0.11 of the softness it is at 1/18 of that
    CHECK(first > 0.0);
    flight.advance(1.0, {0, 0, -1});
    const Camera before = flight.camera();
    flight.advance(1.0, {0, 0, -1});
    CHECK(distance(flight.camera(), before) == Approx(10.0).epsilon(1e-4)); // exp(-1 / 0.09) = 1.5e-5 is missing, and float roundings
    CHECK(flight.is_moving());
    const Camera released = flight.camera();
    for (int i = 0; i < 200 && flight.is_moving(); ++i)
        flight.advance(0.01, {});
    CHECK_FALSE(flight.is_moving());
    CHECK(distance(flight.camera(), released) == Approx(10.0 * CameraController::kSoftness).epsilon(1e-3)); // the integral of the decay
}

TEST_CASE("a diagonal is no faster than a straight way", "[view][camera]")
{
    CameraController straight = still();
    CameraController diagonal = still();
    straight.advance(2.0, {0, 0, -1});
    diagonal.advance(2.0, {1, 1, -1});
    CHECK(distance(diagonal.camera(), still().camera()) == Approx(distance(straight.camera(), still().camera())).epsilon(1e-5));
}

TEST_CASE("what is grabbed stays below the pointer", "[view][camera]")
{
    CameraController flight = still();
    const float fov = still().camera().vertical_fov;
    flight.turn(0.0, 100.0, 400); // a quarter of the height, downwards: the view goes up by a quarter of its field
    const Camera before = still().camera();
    const double angle = std::asin(static_cast<double>(flight.camera().direction.y)) -
                         std::asin(static_cast<double>(glm::normalize(before.direction).y));
    CHECK(angle == Approx(static_cast<double>(fov) / 4.0).epsilon(1e-5));
}

TEST_CASE("looking straight up or down is a degree away", "[view][camera]")
{
    for (const double way : {1e5, -1e5}) {
        CameraController flight = still();
        flight.turn(0.0, way, 400);
        const double up = static_cast<double>(flight.camera().direction.y);
        CHECK(std::abs(up) == Approx(std::cos(3.14159265358979 / 180.0)).epsilon(1e-6));
        CHECK((up > 0.0) == (way > 0.0));
        flight.advance(1.0, {1, 0, 0}); // to the right is still somewhere
        CHECK(distance(flight.camera(), still().camera()) > 1.0);
    }
}

TEST_CASE("a camera that looks along its own up can fly all the same", "[view][camera]")
{
    Camera camera;
    camera.direction = {0.0f, 1.0f, 0.0f};
    CameraController flight(camera, 1.0);
    flight.advance(1.0, {1, 1, 1});
    flight.turn(10, 10, 100);
    const Camera now = flight.camera();
    CHECK(std::isfinite(now.position.x + now.position.y + now.position.z + now.direction.x + now.direction.y + now.direction.z));
}
