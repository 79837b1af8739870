// Defects 1 to 3 of the original: alpha in the G-buffer, position from depth, sphere-map normals.
#include <algorithm>
#include <cmath>

#include "defects/defect_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// A G-buffer of a layout, and what blending into RGB16F would have left of it.
constexpr const char* kPacked = R"({
  "passgraph": 1, "inputs": { "scene": { "kind": "scene" } },
  "passes": {
    "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" }, "choices": { "layout": "packed_alpha" } },
    "blended": { "pass": "original_alpha", "inputs": { "albedo": "surface.albedo", "material": "surface.material",
                 "normal": "surface.normal", "position": "surface.position" } }
  },
  "outputs": { "albedo": "surface.albedo", "material": "surface.material", "position": "surface.position",
               "normal": "surface.normal", "diffuse": "blended.diffuse", "matter": "blended.matter",
               "place": "blended.place" } })";

struct Surface {
    std::array<float, 3> albedo{};
    std::array<float, 3> material{};
    std::array<float, 3> position{};
};

Surface center_of(const std::map<std::string, Picture>& pictures, const char* albedo, const char* material, const char* position)
{
    Surface surface;
    for (int c = 0; c < 3; ++c) {
        surface.albedo[static_cast<size_t>(c)] = pictures.at(albedo).at(8, 8, c);
        surface.material[static_cast<size_t>(c)] = pictures.at(material).at(8, 8, c);
        surface.position[static_cast<size_t>(c)] = pictures.at(position).at(8, 8, c);
    }
    return surface;
}

/// Each value as the material says, whatever stands in an alpha and whatever was drawn behind.
bool is_whole(const Surface& surface, const Square& square)
{
    // srgb8: a code is at most 0.0092 wide near white. The specular of 0.25 is in 8 bits, the two others in floats;
    // rgba32f holds the place up to the interpolation's rounding.
    bool is_right = std::abs(surface.material[0] - square.specular) <= 0.51f / 255.0f &&
                    std::abs(surface.material[1] - square.roughness) <= 0.51f / 255.0f &&
                    std::abs(surface.material[2] - square.metallic) <= 0.51f / 255.0f &&
                    std::abs(surface.position[2] + square.distance) <= 1e-5 * square.distance;
    for (int c = 0; c < 3; ++c)
        is_right = is_right && std::abs(surface.albedo[static_cast<size_t>(c)] - square.color[c]) <= 0.0093f;
    return is_right;
}

double largest_relative_distance(const Picture& a, const Picture& b)
{
    double largest = 0.0;
    for (int y = 0; y < a.extent.height; ++y) {
        for (int x = 0; x < a.extent.width; ++x) {
            const auto place = [&](const Picture& p) { return glm::dvec3(p.at(x, y, 0), p.at(x, y, 1), p.at(x, y, 2)); };
            if (place(a) != glm::dvec3(0.0))
                largest = std::max(largest, glm::distance(place(a), place(b)) / glm::length(place(a)));
        }
    }
    return largest;
}

} // namespace

TEST_CASE("defect 1: values in the alphas of a G-buffer blend with nothing and are all read back", "[defects]")
{
    const Square behind{6.0, {1.0f, 0.0f, 0.0f}, 0.5f, 0.9f, 1.0f};
    const Square front{4.0, {0.1f, 0.8f, 0.4f}, 0.25f, 0.5f, 0.0f};
    for (const bool is_behind_first : {true, false}) {
        const Scene scene = is_behind_first ? squares({behind, front}) : squares({front, behind});
        const auto pictures = run_scene(kPacked, scene, {16, 16});
        CHECK(is_whole(center_of(pictures, "albedo", "material", "position"), front));
        CHECK_FALSE(is_whole(center_of(pictures, "diffuse", "matter", "place"), front)); // the original's
        // Where metallic is 0, blending takes the whole place away: nothing there can be lit.
        CHECK(pictures.at("place").at(8, 8, 2) == 0.0f);
    }
}

TEST_CASE("defect 2: the place rebuilt from depth is the place that was drawn", "[defects]")
{
    const std::string graph = R"({
      "passgraph": 1, "inputs": { "scene": { "kind": "scene" } },
      "passes": {
        "stored":  { "pass": "gbuffer", "inputs": { "scene": "scene" }, "choices": { "layout": "four_target" } },
        "rebuilt": { "pass": "gbuffer", "inputs": { "scene": "scene" }, "choices": { "layout": "two_target" } },
        "theirs":  { "pass": "original_position", "inputs": { "position": "stored.position" } }
      },
      "outputs": { "stored": "stored.position", "rebuilt": "rebuilt.position", "theirs": "theirs.place" } })";
    const auto pictures = run_scene(graph, night_lamp(), {160, 90});
    // Distance is n f / (n + d (f - n)): a relative error of the depth is at most that of the distance. Rasterisers
    // interpolate depth with errors of some ulp of the nearest corner's; the floor reaches from 60 m to 1,000 m, so 17
    // times some ulp, taken as 16, of the depth at its far end: 17 * 16 * 2^-24.
    constexpr double kBound = 17.0 * 16.0 * 0x1p-24;
    CHECK(largest_relative_distance(pictures.at("stored"), pictures.at("rebuilt")) <= kBound);
    CHECK(largest_relative_distance(pictures.at("stored"), pictures.at("theirs")) > 0.5); // not even near
}

namespace {

/// The picture's directions: the poles and axes first, then a spiral over the sphere.
Picture directions()
{
    const Extent extent{64, 16};
    Picture all(extent, 3);
    const std::vector<glm::dvec3> special = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
                                             {1e-4, 0, 1}, {0, -1e-5, 1}, {1e-7, 1e-7, 1}, {0, 1e-3, -1}};
    for (int i = 0; i < extent.width * extent.height; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / (extent.width * extent.height);
        const double across = std::sqrt(1.0 - z * z);
        glm::dvec3 n(across * std::cos(2.4 * i), across * std::sin(2.4 * i), z);
        if (static_cast<size_t>(i) < special.size())
            n = glm::normalize(special[static_cast<size_t>(i)]);
        for (int c = 0; c < 3; ++c)
            all.at(i % extent.width, i / extent.width, c) = static_cast<float>(n[c]);
    }
    return all;
}

} // namespace

TEST_CASE("defect 3: every direction survives the sphere map, the poles too", "[defects]")
{
    const Picture given = directions();
    const Graph graph = graph_of(R"({
      "passgraph": 1, "inputs": { "given": "normal" },
      "passes": { "kept": { "pass": "keep_normal", "inputs": { "image": "given" }, "codecs": { "kept": "sphere_map_rg32f" } } },
      "outputs": { "kept": "kept" } })", with_original());
    GraphRun run;
    run.options.extent = given.extent;
    run.pictures = {{"given", given}};
    const Picture kept = run_graph(graph, run).at("kept");
    for (int y = 0; y < given.extent.height; ++y) {
        for (int x = 0; x < given.extent.width; ++x) {
            const auto at = [&](const Picture& p) { return glm::dvec3(p.at(x, y, 0), p.at(x, y, 1), p.at(x, y, 2)); };
            const double angle = 2.0 * std::asin(std::min(1.0, 0.5 * glm::distance(at(given), at(kept))));
            // The radius is sin(angle to +Z / 2) / 2, stored with some 8 roundings of 2^-24 around 0.5: the angle's error
            // is 4 of it over the cosine of the half angle, and 2 sqrt(4 of it) where that cosine is 0, at -Z.
            const double error = 8 * 0x1p-24;
            const double half_cosine = std::sqrt(std::max(0.0, 0.5 + 0.5 * at(given).z));
            INFO(at(given).x << ", " << at(given).y << ", " << at(given).z);
            CHECK(angle <= std::min(4.0 * error / std::max(half_cosine, 1e-9), 2.0 * std::sqrt(4.0 * error)) + 8 * 0x1p-24);
        }
    }
}

TEST_CASE("defect 3: the original's sphere map has no value for a normal along z", "[defects]")
{
    // A wall that faces the viewer along the world's z, lit head-on.
    Scene scene = squares({{}});
    scene.lights.push_back({});
    scene.lights[0].direction = {0, 0, -1};
    const std::string graph = R"({
      "passgraph": 1, "inputs": { "scene": { "kind": "scene" } },
      "passes": {
        "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" }, "choices": { "layout": "three_target" } },
        "ours": { "pass": "pbr", "inputs": { "albedo": "surface.albedo", "material": "surface.material",
                  "normal": "surface.normal", "position": "surface.position" } },
        "theirs": { "pass": "original_lighting", "inputs": { "albedo": "surface.albedo", "material": "surface.material",
                    "normal": "surface.normal", "position": "surface.position" }, "choices": { "normals": "sphere_map" } }
      },
      "outputs": { "ours": "ours", "theirs": "theirs" } })";
    const auto pictures = run_scene(graph, scene, {16, 16});
    CHECK(pictures.at("ours").at(8, 8) > 0.1f);
    CHECK(pictures.at("theirs").at(8, 8) == 0.0f); // NaN, which a store makes black
}
