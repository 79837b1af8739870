// The matrices of a camera: depth, aspect and a camera far from home.
#include <passgraph/scene/camera_matrices.hpp>

#include "support/catch.hpp"

using namespace passgraph;

namespace {

constexpr double kTwoRoundings = 2.0 / 8388608.0; // the products' entries are each rounded to 24 bits

glm::dvec4 projected(const CameraMatrices& m, const glm::dvec3& point)
{
    const glm::dvec4 clip = glm::dmat4(m.clip_from_view) * glm::dmat4(m.view_from_world) * glm::dvec4(point, 1.0);
    return glm::dvec4(glm::dvec3(clip) / clip.w, clip.w);
}

} // namespace

TEST_CASE("depth is 1 at the near plane and 0 at the far plane", "[scene][camera]")
{
    Camera camera;
    camera.near_plane = GENERATE(0.01f, 1.0f, 10.0f);
    camera.far_plane = GENERATE(11.0f, 2001.0f);
    const CameraMatrices m = matrices(camera, {16, 9});
    CHECK(projected(m, {0, 0, -camera.near_plane}).z == Approx(1.0).epsilon(kTwoRoundings));
    CHECK(std::abs(projected(m, {0, 0, -camera.far_plane}).z) <= kTwoRoundings);
    CHECK(projected(m, {0, 0, -(camera.near_plane + camera.far_plane) / 2}).z < 0.5);
}

TEST_CASE("a point on the axis is the middle of the picture, in front means positive w", "[scene][camera]")
{
    Camera camera;
    camera.position = {1, 2, 3};
    camera.direction = {0, 0, 5};
    const glm::dvec4 place = projected(matrices(camera, {17, 13}), {1, 2, 13});
    CHECK(place.x == 0.0);
    CHECK(place.y == 0.0);
    CHECK(place.w == Approx(10.0));
}

TEST_CASE("right is right and up is up when looking along -Z", "[scene][camera]")
{
    const glm::dvec4 place = projected(matrices(Camera{}, {4, 4}), {1, 2, -10});
    CHECK(place.x > 0.0);
    CHECK(place.y > place.x);
}

TEST_CASE("the field of view is vertical, and width follows the aspect", "[scene][camera]")
{
    Camera camera;
    camera.vertical_fov = 1.57079633f;
    const CameraMatrices m = matrices(camera, {200, 100});
    CHECK(projected(m, {0, 7, -7}).y == Approx(1.0).epsilon(kTwoRoundings));
    CHECK(projected(m, {14, 0, -7}).x == Approx(1.0).epsilon(kTwoRoundings));
}

TEST_CASE("a camera a thousand kilometres away has the matrix computed in double", "[scene][camera]")
{
    Camera camera;
    camera.position = {1e6f, 1000001.0f, -1e6f};
    camera.direction = {1, 2, -3};
    const glm::mat4 view = matrices(camera, {1, 1}).view_from_world;
    const glm::dvec3 forward = glm::normalize(glm::dvec3(1, 2, -3));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 place(camera.position);
    CHECK(view[3][0] == static_cast<float>(-glm::dot(right, place)));
    CHECK(view[3][1] == static_cast<float>(-glm::dot(up, place)));
    CHECK(view[3][2] == static_cast<float>(glm::dot(forward, place)));
    for (int axis = 0; axis < 3; ++axis) {
        CHECK(view[axis][0] == static_cast<float>(right[axis]));
        CHECK(view[axis][2] == static_cast<float>(-forward[axis]));
    }
}

TEST_CASE("an up along the direction is replaced, whichever axis it is", "[scene][camera]")
{
    Camera camera;
    camera.direction = GENERATE(glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, 1), glm::vec3(1, 1, 1));
    camera.up = camera.direction;
    const glm::dmat3 turn(matrices(camera, {1, 1}).view_from_world);
    CHECK(glm::determinant(turn) == Approx(1.0).epsilon(1e-6));
}
