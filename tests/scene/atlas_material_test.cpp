// What becomes of materials in the atlas: their factors, who shares a cell, how cells wrap.
#include <cmath>

#include <glm/gtc/packing.hpp>

#include "scene/atlas_scenes.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

double srgb_decoded(double code)
{
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

double srgb_encoded(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// Half a code, and what factors and numbers in binary32 may move a value that lies between two codes.
constexpr double kCode = 0.5 + 1e-3;

AtlasRect level(const Atlas& atlas, int material, size_t index = 0)
{
    return atlas.cells.at(static_cast<size_t>(material)).levels.at(index);
}

/// Every one of the 256 codes once, in each channel in another order.
std::vector<std::uint8_t> all_codes()
{
    std::vector<std::uint8_t> rgba;
    for (unsigned i = 0; i < 256; ++i)
        for (const unsigned step : {1u, 3u, 5u, 7u})
            rgba.push_back(static_cast<std::uint8_t>(i * step));
    return rgba;
}

} // namespace

TEST_CASE("a texture under factors of 1 is in the atlas code by code", "[scene][atlas]")
{
    Scene scene;
    const TextureLook color{{16, 16}};
    const int codes = add_texture(scene, color, all_codes());
    const int data = add_texture(scene, {{16, 16}, Wrap::repeat, Wrap::repeat, false}, all_codes());
    add_material(scene, {.metallic = 1.0f, .roughness = 1.0f, .specular = 1.0f, .base_color_texture = codes,
                         .metallic_roughness_texture = data, .specular_texture = data});
    const Atlas atlas = atlas_of(scene);
    const AtlasRect rect = level(atlas, 0);
    REQUIRE((rect.width == 16 && rect.height == 16));
    for (int i = 0; i < 256; ++i) {
        for (int c = 0; c < 4; ++c) {
            const std::uint8_t code = scene.textures[0].rgba[static_cast<size_t>(4 * i + c)];
            CHECK(texel(atlas, atlas.albedo, rect.x + i % 16, rect.y + i / 16, c) == code);
            CHECK(texel(atlas, atlas.material, rect.x + i % 16, rect.y + i / 16, c) == (c == 3 ? 255 : code));
        }
    }
}

TEST_CASE("factors are multiplied in before codes are rounded", "[scene][atlas]")
{
    Scene scene;
    const int color = add_texture(scene, {{16, 16}}, all_codes());
    const int data = add_texture(scene, {{16, 16}, Wrap::repeat, Wrap::repeat, false}, all_codes());
    const Material material{.base_color = {0.7f, 0.33f, 0.05f, 0.6f}, .metallic = 0.25f, .roughness = 0.9f, .specular = 0.4f,
                            .emissive = {5.0f, 0.01f, 300.0f}, .base_color_texture = color,
                            .metallic_roughness_texture = data, .emissive_texture = color, .specular_texture = data};
    add_material(scene, material);
    const Atlas atlas = atlas_of(scene);
    const AtlasRect rect = level(atlas, 0);
    const std::array<float, 3> data_factors{material.specular, material.roughness, material.metallic};
    for (int i = 0; i < 256; ++i) {
        const int x = rect.x + i % 16;
        const int y = rect.y + i / 16;
        for (int c = 0; c < 3; ++c) {
            CAPTURE(i, c);
            const double code = scene.textures[0].rgba[static_cast<size_t>(4 * i + c)] / 255.0;
            const double linear = srgb_decoded(code);
            CHECK(std::abs(texel(atlas, atlas.albedo, x, y, c) - 255.0 * srgb_encoded(linear * material.base_color[c])) <= kCode);
            CHECK(std::abs(texel(atlas, atlas.material, x, y, c) - 255.0 * code * data_factors[static_cast<size_t>(c)]) <= kCode);
            const double emitted = linear * material.emissive[c];
            const auto half = static_cast<std::uint16_t>(texel(atlas, atlas.emissive, x, y, c));
            // A half has 11 digits, and a step of 2^-24 near 0; rounding takes half of a step.
            CHECK(std::abs(glm::unpackHalf1x16(half) - emitted) <= emitted * 0x1p-11 * 1.001 + 0x1p-25);
        }
        const double alpha = scene.textures[0].rgba[static_cast<size_t>(4 * i + 3)];
        CHECK(std::abs(texel(atlas, atlas.albedo, x, y, 3) - alpha * material.base_color.a) <= kCode);
    }
}

TEST_CASE("a material without textures is one texel of its factors", "[scene][atlas]")
{
    Scene scene;
    add_material(scene, {.base_color = {0.5f, 0.0f, 1.0f, 1.0f}, .metallic = 0.2f, .roughness = 0.4f, .specular = 0.6f,
                         .emissive = {70000.0f, 0.0f, 1.0f}});
    const Atlas atlas = atlas_of(scene);
    REQUIRE(atlas.cells[0].levels.size() == 1);
    const AtlasRect rect = level(atlas, 0);
    CHECK((rect.width == 1 && rect.height == 1));
    const std::array<double, 4> albedo{188, 0, 255, 255}; // 0.5 of light is code 188
    const std::array<double, 4> material{153, 102, 51, 255};
    const std::array<float, 4> emissive{65504.0f, 0.0f, 1.0f, 0.0f}; // the largest half
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            for (int c = 0; c < 4; ++c) {
                const auto at = static_cast<size_t>(c);
                CHECK(texel(atlas, atlas.albedo, rect.x + x, rect.y + y, c) == albedo[at]);
                CHECK(texel(atlas, atlas.material, rect.x + x, rect.y + y, c) == material[at]);
                const auto half = static_cast<std::uint16_t>(texel(atlas, atlas.emissive, rect.x + x, rect.y + y, c));
                CHECK(glm::unpackHalf1x16(half) == emissive[at]);
            }
        }
    }
}

TEST_CASE("factors that are negative or not numbers count as 0", "[scene][atlas]")
{
    Scene scene;
    add_material(scene, {.base_color = {NAN, -1.0f, INFINITY, 1.0f}, .emissive = {NAN, INFINITY, -3.0f}});
    const Atlas atlas = atlas_of(scene);
    const AtlasRect rect = level(atlas, 0);
    CHECK(texel(atlas, atlas.albedo, rect.x, rect.y, 0) == 0);
    CHECK(texel(atlas, atlas.albedo, rect.x, rect.y, 1) == 0);
    CHECK(texel(atlas, atlas.albedo, rect.x, rect.y, 2) == 255);
    CHECK(texel(atlas, atlas.emissive, rect.x, rect.y, 0) == 0);
    CHECK(texel(atlas, atlas.emissive, rect.x, rect.y, 1) == 0x7bff); // 65504
    CHECK(texel(atlas, atlas.emissive, rect.x, rect.y, 2) == 0);
}

TEST_CASE("materials that look alike share a cell, and others do not", "[scene][atlas]")
{
    Scene scene;
    std::mt19937 random(3);
    const int color = add_noise(scene, {{8, 8}}, random);
    const int copy = add_texture(scene, {{8, 8}}, scene.textures[0].rgba); // as when two models name one file
    const int clamped = add_texture(scene, {{8, 8}, Wrap::clamp}, scene.textures[0].rgba);
    const int data = add_texture(scene, {{8, 8}, Wrap::repeat, Wrap::repeat, false}, scene.textures[0].rgba);
    const int first = add_material(scene, {.base_color_texture = color});
    const int twin = add_material(scene, {.base_color_texture = copy, .is_double_sided = true});
    const int wrapped = add_material(scene, {.base_color_texture = clamped});
    const int linear = add_material(scene, {.base_color_texture = data});
    const int rougher = add_material(scene, {.roughness = 0.5f, .base_color_texture = color});
    const int plain = add_material(scene, {});
    const Atlas atlas = atlas_of(scene);
    const auto cell = [&](int material) { return atlas.cells[static_cast<size_t>(material)]; };
    CHECK(cell(first) == cell(twin));
    for (const int other : {wrapped, linear, rougher, plain})
        CHECK_FALSE(cell(first).levels == cell(other).levels);
    CHECK_FALSE(cell(wrapped).levels == cell(rougher).levels);
    SECTION("and the shared one has room once")
    {
        scene.elements.erase(scene.elements.begin() + twin);
        CHECK(atlas_of(scene).extent == atlas.extent);
    }
}

TEST_CASE("a material that no element shows takes no room", "[scene][atlas]")
{
    Scene scene;
    std::mt19937 random(3);
    add_material(scene, {.base_color_texture = add_noise(scene, {{64, 64}}, random)});
    add_material(scene, {.base_color_texture = add_noise(scene, {{8, 8}}, random)});
    scene.elements.erase(scene.elements.begin());
    const Atlas atlas = atlas_of(scene);
    CHECK(atlas.cells[0].levels.empty());
    CHECK(atlas.cells[1].levels.size() == 4);
    CHECK(atlas.extent.width < 64);
}

TEST_CASE("a texture that a factor of 0 makes invisible takes no room", "[scene][atlas]")
{
    Scene scene;
    std::mt19937 random(3);
    const int texture = add_noise(scene, {{64, 64}}, random);
    add_material(scene, {.base_color = glm::vec4(0), .metallic = 0.0f, .roughness = 0.0f, .emissive = glm::vec3(0),
                         .base_color_texture = texture, .metallic_roughness_texture = texture, .emissive_texture = texture});
    const Atlas atlas = atlas_of(scene);
    CHECK(atlas.cells[0].levels.size() == 1);
    CHECK(atlas.emissive.empty());
}

TEST_CASE("a cell wraps as its textures do", "[scene][atlas]")
{
    Scene scene;
    std::mt19937 random(3);
    add_material(scene, {.base_color_texture = add_noise(scene, {{4, 4}, Wrap::mirror, Wrap::clamp}, random)}, 5.0f);
    add_material(scene, {});
    const int column = add_noise(scene, {{1, 9}, Wrap::clamp, Wrap::mirror}, random);
    const int both = add_noise(scene, {{4, 4}, Wrap::repeat, Wrap::mirror}, random);
    add_material(scene, {.emissive = glm::vec3(1), .base_color_texture = column, .emissive_texture = both}, 5.0f);
    const Atlas atlas = atlas_of(scene);
    CHECK(atlas.cells[0].wrap_u == Wrap::mirror);
    CHECK(atlas.cells[0].wrap_v == Wrap::clamp);
    CHECK(atlas.cells[1].wrap_u == Wrap::repeat);
    CHECK(atlas.cells[2].wrap_u == Wrap::repeat); // the column's one texel wraps into itself
    CHECK(atlas.cells[2].wrap_v == Wrap::mirror);
}

TEST_CASE("textures of a material that wrap differently are an error only where uv leave [0, 1]", "[scene][atlas][errors]")
{
    Scene scene;
    std::mt19937 random(3);
    const int color = add_noise(scene, {{8, 8}, Wrap::repeat, Wrap::repeat}, random);
    const int glow = add_noise(scene, {{8, 8}, Wrap::clamp, Wrap::repeat}, random);
    const Material material{.name = "lamp", .emissive = glm::vec3(1), .base_color_texture = color, .emissive_texture = glow};
    SECTION("inside, the cell clamps, and each image continues as its own texture does")
    {
        add_material(scene, material, 1.0f + 0.4f / 8.0f);
        const Atlas atlas = atlas_of(scene);
        CHECK(atlas.cells[0].wrap_u == Wrap::clamp);
        CHECK(atlas.cells[0].wrap_v == Wrap::repeat);
        const AtlasRect rect = level(atlas, 0);
        for (int c = 0; c < 3; ++c) {
            CHECK(texel(atlas, atlas.albedo, rect.x - 1, rect.y, c) == texel(atlas, atlas.albedo, rect.x + 7, rect.y, c));
            CHECK(texel(atlas, atlas.emissive, rect.x - 1, rect.y, c) == texel(atlas, atlas.emissive, rect.x, rect.y, c));
        }
    }
    SECTION("outside, the message names the material, the textures and the mesh")
    {
        add_material(scene, material, 1.1f);
        const auto atlas = make_atlas(scene, 4096);
        REQUIRE_FALSE(atlas);
        INFO(to_text(atlas.error()));
        REQUIRE(atlas.error().size() == 1);
        CHECK(atlas.error()[0].code == "texture_wraps_differ");
        CHECK_THAT(atlas.error()[0].message,
                   Catch::Contains("`lamp`") && Catch::Contains("along u texture `texture_0.png` repeats and texture "
                                                                "`texture_1.png` clamps") && Catch::Contains("`mesh_0`"));
        CHECK_FALSE(atlas.error()[0].hint.empty());
    }
}
