// The texels of the atlas's levels: means, wrap modes, and that no fetch sees a neighbor.
#include <cmath>
#include <functional>

#include "scene/atlas_scenes.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr std::array<Wrap, 3> kWraps{Wrap::repeat, Wrap::mirror, Wrap::clamp};
const std::vector<Extent> kExtents{{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 3}, {17, 13}, {5, 64}, {32, 32}, {1, 1000}, {100, 7}};

using Numbers = std::vector<double>;

/// One channel of a level in double, by what each texel covers of the one before: the sum of overlaps, over the area.
Numbers averaged(const Numbers& from, Extent extent, Extent to)
{
    Numbers result(texel_count(to), 0.0);
    const auto overlap = [](int i, int count, int j, int result_count) {
        const double scale = static_cast<double>(count) / result_count;
        return std::max(0.0, std::min<double>(i + 1, (j + 1) * scale) - std::max<double>(i, j * scale)) / scale;
    };
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x)
            for (int j = 0; j < extent.height; ++j)
                for (int i = 0; i < extent.width; ++i)
                    result[static_cast<size_t>(y * to.width + x)] += overlap(i, extent.width, x, to.width) *
                                                                     overlap(j, extent.height, y, to.height) *
                                                                     from[static_cast<size_t>(j * extent.width + i)];
    return result;
}

double decoded(double code)
{
    const double value = code / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double encoded(double linear)
{
    return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

/// A scene whose materials wrap in every pair of modes, in noise of many extents.
Scene wrapped_scene()
{
    Scene scene;
    std::mt19937 random(11);
    for (const Extent extent : kExtents) {
        for (const Wrap u : kWraps) {
            for (const Wrap v : kWraps) {
                const int color = add_noise(scene, {extent, u, v}, random);
                const int data = add_noise(scene, {extent, u, v, false}, random);
                add_material(scene, {.specular = 1.0f, .base_color_texture = color, .metallic_roughness_texture = data,
                                     .specular_texture = data}, 3.0f);
            }
        }
    }
    return scene;
}

} // namespace

TEST_CASE("a linear fetch anywhere in a cell is what the wrap mode gives on the level alone", "[scene][atlas]")
{
    const Scene scene = wrapped_scene();
    const Atlas atlas = atlas_of(scene);
    std::mt19937 random(13);
    std::uniform_real_distribution<float> anywhere(-3.0f, 3.0f);
    const std::array<float, 8> hard{0.0f, 1.0f, -1.0f, 2.0f, 1e-7f, -1e-7f, -1e-9f, 0.99999994f};
    double worst = 0.0;
    for (const AtlasCell& cell : atlas.cells) {
        for (const AtlasRect& rect : cell.levels) {
            for (int i = 0; i < 24; ++i) {
                const glm::vec2 uv(i < 8 ? hard[static_cast<size_t>(i)] : anywhere(random),
                                   i % 3 == 0 ? hard[static_cast<size_t>(i / 3)] : anywhere(random));
                const glm::vec2 inside(atlas_wrap(uv.x, cell.wrap_u), atlas_wrap(uv.y, cell.wrap_v));
                const glm::vec2 place = atlas_place(rect, inside);
                for (const auto* image : {&atlas.albedo, &atlas.material}) {
                    const int c = i % 3;
                    const double got = linear([&](int x, int y) { return texel(atlas, *image, x, y, c); }, place.x, place.y);
                    const double alone = linear(
                        [&](int x, int y) {
                            return texel(atlas, *image, rect.x + gl_texel(x, rect.width, cell.wrap_u),
                                         rect.y + gl_texel(y, rect.height, cell.wrap_v), c);
                        },
                        static_cast<double>(uv.x) * rect.width, static_cast<double>(uv.y) * rect.height);
                    worst = std::max(worst, std::abs(got - alone));
                }
            }
        }
    }
    // A place below 1024 texels is rounded to 2^-14; wrapping rounds to 2^-25 of up to 1000 texels. Codes differ by 255.
    CHECK(worst <= 2 * 255 * (0x1p-14 + 1000 * 0x1p-25));
    CHECK(atlas.extent.width < 1024);
}

TEST_CASE("a green cell among red ones stays green at every level and place", "[scene][atlas]")
{
    Scene scene;
    for (int i = 0; i < 40; ++i)
        add_material(scene, {.roughness = 0.1f + 0.01f * static_cast<float>(i),
                             .base_color_texture = add_plain(scene, {{12 + i % 5, 12}}, {255, 0, 0, 255})});
    std::vector<int> greens;
    for (const Extent extent : {Extent{16, 16}, Extent{7, 30}, Extent{1, 1}})
        greens.push_back(add_material(scene, {.base_color_texture = add_plain(scene, {extent}, {0, 255, 0, 255})}));
    const Atlas atlas = atlas_of(scene);
    std::mt19937 random(17);
    std::uniform_real_distribution<float> inside(0.0f, 1.0f);
    for (const int green : greens) {
        for (const AtlasRect& rect : atlas.cells[static_cast<size_t>(green)].levels) {
            for (int i = 0; i < 200; ++i) {
                const glm::vec2 corner(i & 1, (i >> 1) & 1);
                const glm::vec2 place = atlas_place(rect, i < 4 ? corner : glm::vec2(inside(random), inside(random)));
                const auto fetch = [&](int c) {
                    return linear([&](int x, int y) { return texel(atlas, atlas.albedo, x, y, c); }, place.x, place.y);
                };
                REQUIRE(fetch(0) == 0.0);
                REQUIRE(fetch(1) == Approx(255.0).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("each level is the average of the one before by area, of unrounded linear light", "[scene][atlas]")
{
    Scene scene;
    std::mt19937 random(19);
    for (const Extent extent : kExtents)
        add_material(scene, {.base_color_texture = add_noise(scene, {extent}, random),
                             .metallic_roughness_texture = add_noise(scene, {extent, Wrap::repeat, Wrap::repeat, false}, random)});
    const Atlas atlas = atlas_of(scene);
    for (size_t m = 0; m < atlas.cells.size(); ++m) {
        Extent extent = scene.textures[2 * m].extent;
        Numbers light;
        Numbers roughness;
        for (size_t i = 0; i < texel_count(extent); ++i) {
            light.push_back(decoded(scene.textures[2 * m].rgba[4 * i]));
            roughness.push_back(scene.textures[2 * m + 1].rgba[4 * i + 1]);
        }
        for (const AtlasRect& rect : atlas.cells[m].levels) {
            const Extent next{rect.width, rect.height};
            light = averaged(light, extent, next);
            roughness = averaged(roughness, extent, next);
            extent = next;
            for (int i = 0; i < rect.width * rect.height; ++i) {
                const int x = rect.x + i % rect.width;
                const int y = rect.y + i / rect.width;
                CAPTURE(m, rect.width, rect.height, i);
                // Half a code for the store; 1e-3 for ten levels of roundings of 2^-24 where the curve is steepest.
                REQUIRE(std::abs(texel(atlas, atlas.albedo, x, y, 0) - encoded(light[static_cast<size_t>(i)])) <= 0.501);
                REQUIRE(std::abs(texel(atlas, atlas.material, x, y, 1) - roughness[static_cast<size_t>(i)]) <= 0.501);
            }
        }
    }
}

TEST_CASE("every level has the mean of the texture, at odd sizes too", "[scene][atlas]")
{
    Scene scene;
    // A 5 x 5 corner impulse of mean 1 is 0.39 in the last level of a chain of 2 x 2 averages.
    std::vector<std::uint8_t> impulse(100, 0);
    impulse[1] = 250;
    add_material(scene, {.metallic_roughness_texture = add_texture(scene, {{5, 5}, Wrap::clamp, Wrap::clamp, false}, impulse)});
    std::mt19937 random(23);
    for (const Extent extent : {Extent{17, 13}, Extent{31, 63}, Extent{64, 64}})
        add_material(scene, {.metallic_roughness_texture = add_noise(scene, {extent, Wrap::repeat, Wrap::repeat, false}, random)});
    const Atlas atlas = atlas_of(scene);
    for (size_t m = 0; m < atlas.cells.size(); ++m) {
        double mean = 0.0;
        const Texture& texture = scene.textures[m];
        for (size_t i = 1; i < texture.rgba.size(); i += 4)
            mean += texture.rgba[i] / static_cast<double>(texel_count(texture.extent));
        for (const AtlasRect& rect : atlas.cells[m].levels) {
            double level_mean = 0.0;
            for (int i = 0; i < rect.width * rect.height; ++i)
                level_mean += texel(atlas, atlas.material, rect.x + i % rect.width, rect.y + i / rect.width, 1) /
                              (rect.width * rect.height);
            CAPTURE(m, rect.width, rect.height, mean);
            CHECK(std::abs(level_mean - mean) <= 0.501); // each texel is rounded by half a code at most
        }
    }
}

TEST_CASE("a smaller texture of a material is enlarged along lines between its texels, as it wraps", "[scene][atlas]")
{
    for (const Wrap wrap : kWraps) {
        Scene scene;
        std::mt19937 random(29);
        const Extent small{5, 3};
        const Extent large{16, 21};
        const int color = add_noise(scene, {large, wrap, wrap}, random);
        const int data = add_noise(scene, {small, wrap, wrap, false}, random);
        add_material(scene, {.base_color_texture = color, .metallic_roughness_texture = data});
        const Atlas atlas = atlas_of(scene);
        const AtlasRect rect = atlas.cells[0].levels[0];
        REQUIRE((rect.width == large.width && rect.height == large.height));
        for (int y = 0; y < large.height; ++y) {
            for (int x = 0; x < large.width; ++x) {
                const double expected = linear(
                    [&](int i, int j) {
                        const int at = gl_texel(j, small.height, wrap) * small.width + gl_texel(i, small.width, wrap);
                        return static_cast<double>(scene.textures[1].rgba[static_cast<size_t>(4 * at + 2)]);
                    },
                    (x + 0.5) * small.width / large.width, (y + 0.5) * small.height / large.height);
                CAPTURE(x, y, static_cast<int>(wrap));
                CHECK(std::abs(texel(atlas, atlas.material, rect.x + x, rect.y + y, 2) - expected) <= 0.501);
            }
        }
    }
}

TEST_CASE("a cell is as wide as its widest texture and as high as its highest", "[scene][atlas]")
{
    Scene scene;
    std::mt19937 random(31);
    const int wide = add_noise(scene, {{40, 2}}, random);
    const int high = add_noise(scene, {{3, 50}}, random);
    const int glow = add_noise(scene, {{1, 60}}, random);
    add_material(scene, {.emissive = glm::vec3(1), .base_color_texture = wide, .metallic_roughness_texture = high,
                         .emissive_texture = glow});
    const AtlasRect rect = atlas_of(scene).cells[0].levels[0];
    CHECK(rect.width == 40);
    CHECK(rect.height == 60);
}
