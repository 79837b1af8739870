// Defects 4, 6 and 7 of the original: the cube map with albedo, the unwritten output, attenuation and the specular term.
#include <cmath>

#include <passgraph/shader/pass_file.hpp>

#include "defects/defect_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Faces of one color each: +X red, -X cyan, +Y green, -Y magenta, +Z blue, -Z yellow.
std::array<Picture, 6> colored_sky()
{
    return {constant({4, 4}, {1, 0, 0}), constant({4, 4}, {0, 1, 1}), constant({4, 4}, {0, 1, 0}),
            constant({4, 4}, {1, 0, 1}), constant({4, 4}, {0, 0, 1}), constant({4, 4}, {1, 1, 0})};
}

std::array<Picture, 6> even_sky(float value)
{
    const Picture face = constant({4, 4}, {value, value, value});
    return {face, face, face, face, face, face};
}

/// One texel on the view's axis, a metre away.
struct Place {
    std::initializer_list<float> albedo = {1, 1, 1};
    std::initializer_list<float> material = {0.5f, 1, 0}; ///< specular, roughness, metallic
    std::initializer_list<float> normal = {0, 0, 1};
    std::initializer_list<float> position = {0, 0, -1};
};

Picture lit(const std::string& pass, const Place& place, const std::array<Picture, 6>* sky, std::vector<Light> lights = {})
{
    Scene scene;
    scene.lights = std::move(lights);
    PassRun run{.pass = pass, .folders = {original_folder()}, .scene = &scene};
    if (pass != "original_mirror")
        run.inputs = {{"albedo", constant({1, 1}, place.albedo)}, {"material", constant({1, 1}, place.material)}};
    run.inputs.emplace_back("normal", constant({1, 1}, place.normal));
    run.inputs.emplace_back("position", constant({1, 1}, place.position));
    if (sky)
        run.cubes = {{"sky", *sky}};
    return run_for_output(run);
}

const float kHalf = std::sqrt(0.5f);

} // namespace

TEST_CASE("defect 4: a cube map and 2D textures are read in one draw, and albedo colors what the sky lights", "[defects]")
{
    const auto sky = even_sky(1.0f);
    // Any GL error, such as two kinds of sampler on one unit, fails the run.
    const Picture red = lit("pbr", {.albedo = {0.8f, 0.1f, 0.1f}}, &sky);
    CHECK(red.at(0, 0, 0) > 2.0f * red.at(0, 0, 1)); // the reflection is white, the ground red
    CHECK(red.at(0, 0, 1) > 0.0f);
    // The original had the one or the other: its mirror does not know the albedo.
    const Picture mirror = lit("original_mirror", {}, &sky);
    CHECK(mirror.at(0, 0, 0) == mirror.at(0, 0, 1));
}

TEST_CASE("defect 4: the sky is mirrored about the normal", "[defects]")
{
    // Seen along -Z, a mirror turned by 45 degrees towards +X shows what is at +X: the red face.
    const auto sky = colored_sky();
    const Place turned{.albedo = {1, 1, 1}, .material = {0.5f, 0.05f, 1}, .normal = {kHalf, 0, kHalf}};
    const auto is_red = [](const Picture& p) { return p.at(0, 0, 0) > 0.8f && p.at(0, 0, 1) < 0.2f && p.at(0, 0, 2) < 0.2f; };
    CHECK(is_red(lit("pbr", turned, &sky)));
    CHECK_FALSE(is_red(lit("original_mirror", turned, &sky))); // the arguments of reflect swapped
}

TEST_CASE("defect 6: below the threshold the bright image is black, and a pass that leaves an output open is refused", "[defects]")
{
    const Picture dull = run_for_output({.pass = "bright", .inputs = {{"image", constant({3, 2}, {0.1f, 0.2f, 0.3f})}},
                                         .settings = {{"knee", "0"}}});
    for (const float value : dull.texels)
        CHECK(value == 0.0f);
    const auto open = read_pass(R"(/*{ "pass": "lit_and_bright", "summary": "The original's two outputs.",
  "inputs": { "image": "radiance" }, "outputs": { "lit": "radiance", "glow": "radiance" } }*/
void lit_and_bright(vec2 uv, out vec3 lit, out vec3 glow)
{
    lit = image(uv);
    if (dot(lit, vec3(0.2126, 0.7152, 0.0722)) > 0.8)
        glow = lit;
}
)", "lit_and_bright.glsl", "own", {});
    REQUIRE_FALSE(open);
    CHECK(open.error()[0].code == "output_unwritten");
    CHECK_THAT(open.error()[0].message, Catch::Contains("glow"));
    CHECK(open.error()[0].where.line > 0);
}

TEST_CASE("defect 7: a lamp's light is finite at its own place and ends at its radius", "[defects]")
{
    Light lamp;
    lamp.kind = Light::Kind::point;
    lamp.radius = 3.0f;
    const auto with_lamp = [&](const char* pass, glm::dvec3 position) {
        lamp.position = position;
        return lit(pass, {}, nullptr, {lamp}).at(0, 0);
    };
    // 10,000 is the irradiance at one centimetre, 1 / pi Lambert's share, 1.1 what the specular layer may add.
    const float on_it = with_lamp("pbr", {0, 0, -1});
    CHECK(on_it > 0.0f);
    CHECK(on_it <= 10000.0f * 1.1f / 3.14159f);
    CHECK(with_lamp("pbr", {0, 0, -0.9999}) <= 10000.0f * 1.1f / 3.14159f);
    CHECK(with_lamp("pbr", {0, 0, 2}) == 0.0f);
    // The original's: 1 / d^2 leaves every bound, is no number at the lamp itself, and never ends.
    CHECK(with_lamp("original_lighting", {0, 0, -0.9999}) >= 65504.0f); // where the store cuts it off
    CHECK(with_lamp("original_lighting", {0, 0, -1}) == 0.0f);          // NaN, which a store makes black
    CHECK(with_lamp("original_lighting", {0, 0, 2}) > 0.0f);
}

TEST_CASE("defect 7: a highlight grows towards the grazing view, as 1 / N.V, and V.H of 0 makes no NaN", "[defects]")
{
    // Light and viewer in mirror directions, seen at an angle: black albedo leaves the highlight alone.
    const auto highlight = [&](const char* pass, double degrees) {
        const double angle = glm::radians(degrees);
        Light sun;
        const glm::dvec3 normal(std::sin(angle), 0.0, std::cos(angle));
        const glm::dvec3 viewer(0.0, 0.0, 1.0);
        const glm::dvec3 to_light = 2.0 * glm::dot(normal, viewer) * normal - viewer;
        sun.direction = glm::vec3(-to_light);
        const Place place{.albedo = {0, 0, 0}, .material = {1, 0.3f, 0},
                          .normal = {static_cast<float>(normal.x), 0, static_cast<float>(normal.z)}};
        return lit(pass, place, nullptr, {sun}).at(0, 0);
    };
    CHECK(highlight("pbr", 80) > 2.0f * highlight("pbr", 20));
    CHECK_FALSE(highlight("original_lighting", 80) > 2.0f * highlight("original_lighting", 20));
    // Light from straight behind: v + l is 0, and V.H with it.
    Light behind;
    behind.direction = {0, 0, 1};
    const float ours = lit("pbr", {}, nullptr, {behind}).at(0, 0);
    CHECK(ours == 0.0f);
}
