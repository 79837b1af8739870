// Lighting as a picture: emission, the sky's light, and pixels without geometry. Lamps are tested as functions.
#include <algorithm>
#include <array>
#include <cmath>

#include <passgraph/scene/scene.hpp>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Neither lamps nor elements; a camera at the origin that looks along -Z.
const Scene kEmptyScene;

/// One material all over, its normal turned straight to the viewer at every pixel.
PassRun surfaces(Extent extent, std::initializer_list<float> albedo, std::initializer_list<float> material)
{
    Picture position(extent, 3);
    Picture normal(extent, 3);
    for (int y = 0; y < extent.height; ++y) {
        for (int x = 0; x < extent.width; ++x) {
            const double place[] = {0.1 * (x - extent.width / 2), 0.1 * (y - extent.height / 2), -2.0};
            const double length = std::hypot(place[0], place[1], place[2]);
            for (int c = 0; c < 3; ++c) {
                position.at(x, y, c) = static_cast<float>(place[c]);
                normal.at(x, y, c) = static_cast<float>(-place[c] / length);
            }
        }
    }
    return {.pass = "pbr",
            .inputs = {{"albedo", constant(extent, albedo)}, {"material", constant(extent, material)}, {"normal", normal}, {"position", position}},
            .scene = &kEmptyScene};
}

std::array<Picture, 6> uniform_sky(std::initializer_list<float> radiance)
{
    std::array<Picture, 6> faces;
    faces.fill(constant({4, 4}, radiance));
    return faces;
}

Light lamp_along(glm::vec3 direction)
{
    Light lamp;
    lamp.direction = direction;
    return lamp;
}

/// The split-sum table of the defaults for a surface seen along its normal, where Schlick's edge is 0.
std::array<double, 2> reflectance(double r)
{
    static const Picture table = run_for_output({.pass = "split_sum", .extent = {1, 1}});
    return {bilinear(table, 63.5, r * 63.0 + 0.5, 0), bilinear(table, 63.5, r * 63.0 + 0.5, 1)};
}

} // namespace

TEST_CASE("without lamps and sky a surface shows what it emits, bit by bit", "[passes][pbr][identity]")
{
    unsigned seed = 120;
    for (const Extent extent : kExtents) {
        PassRun run = surfaces(extent, {0.8f, 0.5f, 0.2f}, {0.5f, 0.4f, 0.0f});
        const Picture emissive = noise(extent, 3, 0.0f, 4.0f, seed++);
        run.inputs.emplace_back("emissive", emissive);
        require_same(run_for_output(run), emissive);
    }
}

TEST_CASE("without lamps, sky and emission a surface is black", "[passes][pbr]")
{
    const Picture got = run_for_output(surfaces({17, 13}, {0.8f, 0.5f, 0.2f}, {0.5f, 0.0f, 1.0f}));
    require_same(got, constant({17, 13}, {0.0f, 0.0f, 0.0f}));
}

TEST_CASE("a pixel without geometry shows its emission under any sky", "[passes][pbr][identity]")
{
    const Extent extent{17, 13};
    const Picture nothing = constant(extent, {0.0f, 0.0f, 0.0f});
    const Picture emissive = noise(extent, 3, 0.0f, 4.0f, 125);
    const PassRun run = {.pass = "pbr",
                         .inputs = {{"albedo", constant(extent, {1.0f, 1.0f, 1.0f})}, {"material", nothing}, {"normal", nothing},
                                    {"position", nothing}, {"emissive", emissive}},
                         .cubes = {{"sky", uniform_sky({3.0f, 3.0f, 3.0f})}},
                         .scene = &kEmptyScene};
    require_same(run_for_output(run), emissive);
}

TEST_CASE("a sky of one color is reflected by the surface's share of it", "[passes][pbr]")
{
    constexpr double kSky[] = {0.5, 1.0, 2.0};
    constexpr double kAlbedo[] = {0.8, 0.5, 0.2};
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        for (const float metallic : {0.0f, 0.5f, 1.0f}) {
            PassRun run = surfaces({5, 3}, {0.8f, 0.5f, 0.2f}, {0.5f, roughness, metallic});
            run.cubes = {{"sky", uniform_sky({0.5f, 1.0f, 2.0f})}};
            const auto [scale, bias] = reflectance(roughness);
            const auto expected = [&, scale = scale, bias = bias](int, int, int c) {
                const double f0 = 0.04 * (1.0 - metallic) + kAlbedo[c] * metallic;
                const double diffuse = kAlbedo[c] * (1.0 - metallic) * (1.0 - (0.04 * scale + bias));
                return kSky[c] * (f0 * scale + bias + diffuse);
            };
            CAPTURE(roughness, metallic);
            // About 40 roundings of sums up to 1 times a sky of 2. The table is stored in 16 bits, two numbers of it, and its
            // last texels in n.v are 1e-2 apart at most where n.v is 1 within 2 roundings, 63 texels of sqrt(n.v).
            require_texels(run_for_output(run), expected, 2.0 * (40.0 * kRounding + 2.0 / 65535.0 + 63.0 * 2.0 * kRounding * 1e-2));
        }
    }
}

TEST_CASE("a white metal under a white sky is never brighter than the sky", "[passes][pbr]")
{
    PassRun run = surfaces({17, 13}, {1.0f, 1.0f, 1.0f}, {1.0f, 0.3f, 0.5f});
    run.inputs[2].second = noise({17, 13}, 3, -1.0f, 1.0f, 126); // normals any way, also away from the viewer
    run.cubes = {{"sky", uniform_sky({1.0f, 1.0f, 1.0f})}};
    require_texels(run_for_output(run), [](int, int, int) { return 0.5; }, 0.501);
}

TEST_CASE("a mirror facing the viewer reflects what is behind the viewer, not what is behind the mirror", "[passes][pbr][defect 4]")
{
    // A mirror's reflection along its normal and a matt surface's light along its normal come from the same place. With
    // the arguments of the reflection swapped, as in the original, they come from opposite ones.
    std::array<Picture, 6> faces;
    for (size_t face = 0; face < 6; ++face)
        faces[face] = constant({8, 8}, {face == 0 || face == 3 || face == 4 ? 4.0f : 0.0f, 1.0f, 1.0f});
    PassRun mirror = surfaces({1, 1}, {1.0f, 1.0f, 1.0f}, {0.0f, 0.045f, 1.0f});
    mirror.cubes = {{"sky", faces}};
    PassRun matt = surfaces({1, 1}, {1.0f, 1.0f, 1.0f}, {0.0f, 1.0f, 0.0f});
    matt.cubes = {{"sky", faces}};
    const Picture reflected = run_for_output(mirror);
    const Picture scattered = run_for_output(matt);
    CHECK((reflected.at(0, 0, 0) > reflected.at(0, 0, 1)) == (scattered.at(0, 0, 0) > scattered.at(0, 0, 1)));
    CHECK(std::abs(reflected.at(0, 0, 0) - reflected.at(0, 0, 1)) > 0.1f);
}

TEST_CASE("the environment's brightness scales the sky's light", "[passes][pbr]")
{
    PassRun run = surfaces({5, 3}, {0.8f, 0.5f, 0.2f}, {0.5f, 0.4f, 0.2f});
    run.cubes = {{"sky", uniform_sky({0.5f, 1.0f, 2.0f})}};
    const Picture once = run_for_output(run);
    run.settings = {{"environment", "2"}};
    require_texels(run_for_output(run), [&](int x, int y, int c) { return 2.0 * once.at(x, y, c); }, 4.0 * kRounding);
    run.settings = {{"environment", "0"}};
    require_same(run_for_output(run), constant({5, 3}, {0.0f, 0.0f, 0.0f}));
}

TEST_CASE("no material is brighter than a white sky, for any model", "[passes][pbr][furnace]")
{
    const Extent extent{32, 32};
    const Picture unit = noise(extent, 3, 0.0f, 1.0f, 127);
    PassRun run = surfaces(extent, {1.0f, 1.0f, 1.0f}, {0.0f, 0.0f, 0.0f});
    run.inputs[1].second = unit;
    run.inputs[2].second = noise(extent, 3, -1.0f, 1.0f, 128);
    run.cubes = {{"sky", uniform_sky({1.0f, 1.0f, 1.0f})}};
    for (const char* distribution : {"ggx", "beckmann"})
        for (const char* fresnel : {"schlick", "exact"})
            for (const char* geometry : {"smith_correlated", "smith_separable", "cook_torrance", "neumann", "implicit"}) {
                run.settings = {{"distribution", distribution}, {"fresnel", fresnel}, {"geometry", geometry}};
                CAPTURE(distribution, fresnel, geometry);
                require_texels(run_for_output(run), [](int, int, int) { return 0.5; }, 0.501);
            }
}

TEST_CASE("every rung of a ladder lights the same surface nearly alike", "[passes][pbr]")
{
    Scene scene;
    scene.lights = {lamp_along({0.2f, 0.1f, -0.9746794f})};
    PassRun run = surfaces({17, 13}, {0.8f, 0.5f, 0.2f}, {0.5f, 0.4f, 0.5f});
    run.scene = &scene;
    const Picture reference = run_for_output(run);
    REQUIRE(largest(reference) > 0.1);
    for (const auto& [ladder, rung] : std::vector<std::pair<std::string, std::string>>{
             {"ggx_form", "textbook"}, {"ggx_form", "difference_of_squares"}, {"fresnel_power", "pow"}}) {
        run.settings = {{ladder, rung}};
        CAPTURE(ladder, rung);
        // The textbook's form magnifies the cosine's few roundings by at most 4 / alpha^2 = 156; pow is 31 ulp off.
        require_texels(run_for_output(run), [&](int x, int y, int c) { return double(reference.at(x, y, c)); },
                       [&](int x, int y, int c) { return (4.0 * 156.0 + 60.0) * kRounding * reference.at(x, y, c); });
    }
    run.settings = {{"distribution", "beckmann"}};
    const Picture erf = run_for_output(run);
    run.settings.push_back({"beckmann_masking", "rational"});
    require_texels(run_for_output(run), [&](int x, int y, int c) { return double(erf.at(x, y, c)); }, // Walter's fit: 0.32 %
                   [&](int x, int y, int c) { return 2.0 * 0.0032 * erf.at(x, y, c); });
}

TEST_CASE("each model is another picture", "[passes][pbr]")
{
    Scene scene;
    scene.lights = {lamp_along({0.6f, 0.0f, -0.8f})};
    PassRun run = surfaces({1, 1}, {0.9f, 0.9f, 0.9f}, {1.0f, 0.7f, 0.5f});
    run.inputs[2].second = constant({1, 1}, {0.0f, 0.48f, 0.87726762f}); // seen along its normal, some models are alike
    run.scene = &scene;
    std::vector<float> values;
    for (const auto& [choice, item] : std::vector<std::pair<std::string, std::string>>{
             {"distribution", "ggx"}, {"distribution", "beckmann"}, {"fresnel", "exact"}, {"geometry", "smith_separable"},
             {"geometry", "cook_torrance"}, {"geometry", "neumann"}, {"geometry", "implicit"}}) {
        run.settings = {{choice, item}};
        values.push_back(run_for_output(run).at(0, 0, 0));
    }
    std::sort(values.begin(), values.end());
    CAPTURE(values);
    CHECK(std::adjacent_find(values.begin(), values.end(), [](float a, float b) { return b - a < 1e-4f * a; }) == values.end());
}
