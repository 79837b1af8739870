// Directions in the G-buffer: vectors that have none, or that binary32 cannot square, become usable ones.
#include <cmath>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph::test;

namespace {

std::vector<std::vector<float>> directions(const std::vector<std::vector<float>>& vectors)
{
    return evaluate("unit_vector_or(vec3(x, y, z), vec3(0.0, 0.6, 0.8))", {"unit_vector.glsl"}, {"x", "y", "z"}, vectors);
}

const std::vector<float> kFallback = {0.0f, 0.6f, 0.8f};

} // namespace

TEST_CASE("a vector becomes its direction, however long it is", "[passes][gbuffer]")
{
    for (const float length : {1e-30f, 1e-20f, 1e-3f, 1.0f, 1e3f, 1e20f, 1e30f}) {
        const auto got = directions({{2.0f * length, -3.0f * length, 6.0f * length}});
        // Scaling 1, squares and their sum 3, inverse root 1.4 ulp, product 1.
        CHECK(got[0][0] == Approx(2.0 / 7.0).epsilon(8.0 * kRounding));
        CHECK(got[0][1] == Approx(-3.0 / 7.0).epsilon(8.0 * kRounding));
        CHECK(got[0][2] == Approx(6.0 / 7.0).epsilon(8.0 * kRounding));
    }
}

TEST_CASE("a vector without a direction becomes the fallback", "[passes][gbuffer]")
{
    for (const auto& value : directions({{0.0f, 0.0f, 0.0f}, {-0.0f, 0.0f, -0.0f}, {NAN, 0.0f, 1.0f}, {1.0f, NAN, NAN}, {NAN, NAN, NAN},
                                         {INFINITY, 0.0f, 0.0f}, {1.0f, -INFINITY, 2.0f}, {1e-40f, 0.0f, 0.0f}}))
        CHECK(value == kFallback);
}

TEST_CASE("a normal along the view axis is itself, where the original divides 0 by 0", "[passes][gbuffer][defect 3]")
{
    CHECK(directions({{0.0f, 0.0f, 1.0f}})[0] == std::vector<float>{0.0f, 0.0f, 1.0f});
    CHECK(directions({{0.0f, 0.0f, -1.0f}})[0] == std::vector<float>{0.0f, 0.0f, -1.0f});
}
