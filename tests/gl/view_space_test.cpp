// The camera's block and the matrices of elements, without a context.
#include "gl/view_space.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::gl;

namespace {

bool is_finite(const glm::dmat3& m)
{
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (!std::isfinite(static_cast<float>(m[c][r])))
                return false;
    return true;
}

} // namespace

TEST_CASE("the normal matrix is the inverse transpose up to a positive factor", "[gl][view_space]")
{
    for (const double mirror : {1.0, -1.0}) {
        const glm::dmat3 m(2.0 * mirror, 0.5, 0.1, -0.3, 1.0, 0.7, 0.2, -0.4, 3.0);
        const glm::dmat3 ratio = normal_matrix(m) * glm::transpose(m); // factor * identity
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r)
                CHECK(ratio[c][r] == Approx(c == r ? ratio[0][0] : 0.0).margin(1e-14));
        CHECK(ratio[0][0] > 0.0);
    }
}

TEST_CASE("singular, huge and tiny transforms have finite normal matrices", "[gl][view_space]")
{
    const glm::dmat3 flat(1, 0, 0, 0, 1, 0, 0, 0, 0);
    CHECK((normal_matrix(flat) * glm::dvec3(0, 0, 1)).z == 1.0); // the normal of what is left
    for (const double scale : {1e-200, 1e-30, 1e30, 1e200}) {
        const glm::dmat3 scaled = glm::dmat3(1.0) * scale;
        CHECK(normal_matrix(scaled)[1][1] == Approx(1.0));
        CHECK(is_finite(normal_matrix(scaled)));
        CHECK(is_mirrored(-scaled));
        CHECK_FALSE(is_mirrored(scaled));
    }
    for (const glm::dmat3& degenerate : {glm::dmat3(0.0), glm::dmat3(1, 0, 0, 0, 0, 0, 0, 0, 0)}) {
        CHECK(normal_matrix(degenerate) == glm::dmat3(1.0));
        CHECK_FALSE(is_mirrored(degenerate));
    }
}

TEST_CASE("the camera's ray leads to the place that clip_from_view puts at uv", "[gl][view_space]")
{
    Camera camera;
    camera.vertical_fov = 1.0f;
    const View view = view_of(camera, {160, 90}, true);
    const auto& clip = view.block.clip_from_view;
    for (const glm::vec2 uv : {glm::vec2(0.1f, 0.2f), glm::vec2(0.9f, 0.6f)}) {
        const float x = (uv.x * 2 - 1) * view.block.ray[0] + view.block.ray[2];
        const float y = (uv.y * 2 - 1) * view.block.ray[1] + view.block.ray[3];
        CHECK(clip[0] * x + clip[8] * -1.0f == Approx(uv.x * 2 - 1)); // clip.w is 1 at z = -1
        CHECK(clip[5] * y + clip[9] * -1.0f == Approx(uv.y * 2 - 1));
    }
}

TEST_CASE("without clip control depth is stretched to -1..1 and still reversed", "[gl][view_space]")
{
    Camera camera;
    camera.near_plane = 1.0f;
    camera.far_plane = 10.0f;
    const auto ndc_depth = [&](bool has_clip_control, float z) {
        const auto clip = view_of(camera, {4, 4}, has_clip_control).block.clip_from_view;
        return (clip[10] * z + clip[14]) / -z;
    };
    CHECK(ndc_depth(true, -1.0f) == Approx(1.0f));
    CHECK(ndc_depth(true, -10.0f) == Approx(0.0f).margin(1e-6));
    CHECK(ndc_depth(false, -1.0f) == Approx(1.0f));
    CHECK(ndc_depth(false, -10.0f) == Approx(-1.0f));
}

TEST_CASE("world_from_view undoes view_from_world", "[gl][view_space]")
{
    Camera camera;
    camera.position = {3, 4, 5};
    camera.direction = glm::normalize(glm::vec3(1, -0.5f, 2));
    const View view = view_of(camera, {4, 3}, true);
    glm::mat4 there, back;
    for (int i = 0; i < 16; ++i) {
        there[i / 4][i % 4] = view.block.view_from_world[static_cast<size_t>(i)];
        back[i / 4][i % 4] = view.block.world_from_view[static_cast<size_t>(i)];
    }
    const glm::mat4 both = back * there;
    for (int i = 0; i < 16; ++i)
        CHECK(both[i / 4][i % 4] == Approx(i % 5 == 0 ? 1.0f : 0.0f).margin(1e-5));
    CHECK(back[3][0] == 3.0f);
}
