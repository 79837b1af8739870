// Where the atlas's rectangles lie: inside it, apart from each other, in little room, and what is said when they do not fit.
#include <algorithm>

#include <fmt/format.h>

#include "scene/atlas_scenes.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Material textured(int texture)
{
    return {.base_color_texture = texture};
}

/// A scene with a material for each extent, no two of them alike.
Scene scene_of(const std::vector<Extent>& extents)
{
    Scene scene;
    std::mt19937 random(7);
    for (const Extent extent : extents) {
        Material material = textured(add_noise(scene, {extent}, random));
        material.roughness = static_cast<float>(scene.materials.size() + 1) / 1024.0f;
        add_material(scene, material);
    }
    return scene;
}

/// Marks each texel with the rectangle that owns it, gutters included; "" when none has two and all are inside.
std::string overlaps(const Atlas& atlas)
{
    std::vector<bool> is_taken(texel_count(atlas.extent), false);
    for (size_t i = 0; i < atlas.cells.size(); ++i) {
        for (const AtlasRect& rect : atlas.cells[i].levels) {
            if (rect.x < 1 || rect.y < 1 || rect.x + rect.width >= atlas.extent.width ||
                rect.y + rect.height >= atlas.extent.height)
                return fmt::format("cell {}: {} x {} at ({}, {}) leaves the atlas", i, rect.width, rect.height, rect.x, rect.y);
            for (int y = rect.y - 1; y <= rect.y + rect.height; ++y) {
                for (int x = rect.x - 1; x <= rect.x + rect.width; ++x) {
                    const size_t at = static_cast<size_t>(y) * static_cast<size_t>(atlas.extent.width) + static_cast<size_t>(x);
                    if (is_taken[at])
                        return fmt::format("cell {}: ({}, {}) is taken twice", i, x, y);
                    is_taken[at] = true;
                }
            }
        }
    }
    return "";
}

size_t used_texels(const Atlas& atlas)
{
    size_t used = 0;
    for (const AtlasCell& cell : atlas.cells)
        for (const AtlasRect& rect : cell.levels)
            used += texel_count({rect.width + 2, rect.height + 2});
    return used;
}

} // namespace

TEST_CASE("rectangles and their gutters lie inside the atlas and never overlap", "[scene][atlas]")
{
    std::mt19937 random(20170620);
    for (int round = 0; round < 60; ++round) {
        const int count = 1 + static_cast<int>(random() % 40);
        const unsigned most = 1u << (random() % 8);
        std::vector<Extent> extents;
        for (int i = 0; i < count; ++i)
            extents.push_back({1 + static_cast<int>(random() % most), 1 + static_cast<int>(random() % (2 * most))});
        const Atlas atlas = atlas_of(scene_of(extents));
        CAPTURE(round, count, most);
        REQUIRE(overlaps(atlas) == "");
        CHECK(atlas.extent.width % 4 == 0);
        CHECK(atlas.extent.height % 4 == 0);
        CHECK(atlas.albedo.size() == 4 * texel_count(atlas.extent));
        CHECK(atlas.material.size() == 4 * texel_count(atlas.extent));
    }
}

TEST_CASE("a level has half the texels of the one before, rounded down, and the last has one", "[scene][atlas]")
{
    const Atlas atlas = atlas_of(scene_of({{1, 1}, {1, 4090}, {13, 5}, {1024, 3}, {6, 6}}), 8192);
    CHECK(overlaps(atlas) == "");
    const std::vector<size_t> counts{1, 12, 4, 11, 3};
    for (size_t i = 0; i < counts.size(); ++i) {
        const auto& levels = atlas.cells[i].levels;
        REQUIRE(levels.size() == counts[i]);
        for (size_t k = 1; k < levels.size(); ++k) {
            CHECK(levels[k].width == std::max(1, levels[0].width >> k));
            CHECK(levels[k].height == std::max(1, levels[0].height >> k));
        }
        CHECK((levels.back().width == 1 && levels.back().height == 1));
    }
}

TEST_CASE("the atlas is little larger than what is in it, and about square", "[scene][atlas]")
{
    std::mt19937 random(5);
    for (const int count : {1, 4, 30, 200}) {
        std::vector<Extent> extents;
        for (int i = 0; i < count; ++i)
            extents.push_back({16 << (random() % 4), 16 << (random() % 4)});
        const Atlas atlas = atlas_of(scene_of(extents));
        const double fill = static_cast<double>(used_texels(atlas)) / static_cast<double>(texel_count(atlas.extent));
        CAPTURE(count, fill, atlas.extent.width, atlas.extent.height);
        CHECK(fill > (count == 1 ? 0.6 : 0.85)); // one square and its levels leave a third of an L empty
        CHECK(std::max(atlas.extent.width, atlas.extent.height) < 3 * std::min(atlas.extent.width, atlas.extent.height));
    }
}

TEST_CASE("long strips make a long atlas, not a square of their length", "[scene][atlas]")
{
    const Atlas atlas = atlas_of(scene_of({{1, 4000}, {2, 3000}}), 4096);
    CHECK(overlaps(atlas) == "");
    CHECK(atlas.extent.height <= 4004);
    CHECK(atlas.extent.width <= 16);
}

TEST_CASE("a scene without elements has an atlas that can be uploaded", "[scene][atlas]")
{
    Scene scene;
    scene.materials.push_back({.name = "default"});
    const Atlas atlas = atlas_of(scene, 4);
    CHECK(atlas.extent == Extent{4, 4});
    CHECK(atlas.albedo.size() == 64);
    CHECK(atlas.emissive.empty());
    REQUIRE(atlas.cells.size() == 1);
    CHECK(atlas.cells[0].levels.empty());
}

TEST_CASE("equal scenes give equal atlases", "[scene][atlas]")
{
    const std::vector<Extent> extents{{8, 8}, {8, 8}, {8, 8}, {16, 4}, {4, 16}, {16, 4}, {1, 1}, {1, 1}, {33, 17}};
    const Atlas one = atlas_of(scene_of(extents));
    const Atlas other = atlas_of(scene_of(extents));
    CHECK(one.extent == other.extent);
    CHECK(one.cells == other.cells);
    CHECK(one.albedo == other.albedo);
    CHECK(one.material == other.material);
}

TEST_CASE("a texture larger than the device's is named, and every such one", "[scene][atlas][errors]")
{
    Scene scene = scene_of({{64, 8}, {8, 8}, {8, 63}});
    scene.materials[0].name = "wood";
    scene.textures[2].name = "";
    const auto atlas = make_atlas(scene, 64);
    REQUIRE_FALSE(atlas);
    INFO(to_text(atlas.error()));
    REQUIRE(atlas.error().size() == 2);
    for (const Error& error : atlas.error()) {
        CHECK(error.code == "atlas_full");
        CHECK(error.fault == Fault::machine);
        CHECK_THAT(error.hint, Catch::Contains("62 texels or less"));
    }
    CHECK_THAT(atlas.error()[0].message, Catch::Contains("material `wood`") && Catch::Contains("64 x 8 texels") &&
                                             Catch::Contains("64 x 64 here") && Catch::Contains("texture `texture_0.png`"));
    CHECK_THAT(atlas.error()[1].message, Catch::Contains("8 x 63 texels") && Catch::Contains("textures[2]"));
    SECTION("and one that just fits with its gutter is not") { CHECK(make_atlas(scene_of({{62, 8}}), 64)); }
}

TEST_CASE("textures that together exceed the device's are an error that names one and both sizes", "[scene][atlas][errors]")
{
    const auto atlas = make_atlas(scene_of({{40, 40}, {40, 40}, {8, 8}}), 64);
    REQUIRE_FALSE(atlas);
    INFO(to_text(atlas.error()));
    REQUIRE(atlas.error().size() == 1);
    const Error& error = atlas.error()[0];
    CHECK(error.code == "atlas_full");
    CHECK(error.fault == Fault::machine);
    CHECK_THAT(error.message, Catch::Contains("no room is left") && Catch::Contains("40 x 40 texels of texture `texture_"));
    CHECK_THAT(error.hint, Catch::Contains("all 3 materials") && Catch::Contains("64 x 64"));
}

TEST_CASE("an atlas grows up to the limit before it is full", "[scene][atlas]")
{
    // With their levels and gutters these take 8^2 + 5^2 + 3^2 texels each, 98.7 % of the limit in all.
    const std::vector<Extent> extents(165, Extent{6, 6});
    CHECK(atlas_of(scene_of(extents), 128).extent == Extent{128, 128});
    CHECK_FALSE(make_atlas(scene_of(extents), 124));
    SECTION("and to whole multiples of four of a limit that is none")
    {
        CHECK(atlas_of(scene_of(extents), 131).extent == Extent{128, 128});
    }
}
