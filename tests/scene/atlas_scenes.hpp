// Scenes for the tests of the atlas: textures of noise, a mesh and an element for each material, and fetches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <passgraph/scene/atlas.hpp>

#include "support/catch.hpp"

namespace passgraph::test {

struct TextureLook {
    Extent extent{1, 1};
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    bool is_srgb = true;
};

inline int add_texture(Scene& scene, const TextureLook& look, std::vector<std::uint8_t> rgba)
{
    const int index = static_cast<int>(scene.textures.size());
    scene.textures.push_back({fmt::format("texture_{}.png", index), look.extent, std::move(rgba), look.wrap_u,
                              look.wrap_v, look.is_srgb});
    return index;
}

inline size_t texel_count(Extent extent)
{
    return static_cast<size_t>(extent.width) * static_cast<size_t>(extent.height);
}

/// Every texel of one color.
inline int add_plain(Scene& scene, const TextureLook& look, std::array<std::uint8_t, 4> color)
{
    std::vector<std::uint8_t> rgba;
    for (size_t i = 0; i < texel_count(look.extent); ++i)
        rgba.insert(rgba.end(), color.begin(), color.end());
    return add_texture(scene, look, std::move(rgba));
}

/// Every code as likely as every other, so that neighbors differ as much as they can.
inline int add_noise(Scene& scene, const TextureLook& look, std::mt19937& random)
{
    std::vector<std::uint8_t> rgba(4 * texel_count(look.extent));
    for (std::uint8_t& code : rgba)
        code = static_cast<std::uint8_t>(random() >> 24);
    return add_texture(scene, look, std::move(rgba));
}

/// Adds the material, a triangle of it and an element that shows it; `reach` is the largest of the triangle's uv.
inline int add_material(Scene& scene, Material material, float reach = 1.0f)
{
    const int index = static_cast<int>(scene.materials.size());
    if (material.name.empty())
        material.name = fmt::format("material_{}", index);
    scene.materials.push_back(material);
    Mesh mesh{fmt::format("mesh_{}", index), {}, {0, 1, 2}, index};
    for (const glm::vec2 uv : {glm::vec2(0), glm::vec2(reach, 0), glm::vec2(0, reach)})
        mesh.vertices.push_back({glm::vec3(uv, 0), {0, 0, 1}, uv});
    scene.meshes.push_back(mesh);
    scene.elements.push_back({fmt::format("element_{}", index), static_cast<int>(scene.meshes.size()) - 1});
    return index;
}

inline Atlas atlas_of(const Scene& scene, int max_extent = 4096)
{
    const Result<Atlas> atlas = make_atlas(scene, max_extent);
    INFO((atlas ? std::string() : to_text(atlas.error())));
    REQUIRE(atlas);
    return *atlas;
}

template <class Code> double texel(const Atlas& atlas, const std::vector<Code>& image, int x, int y, int channel)
{
    REQUIRE((x >= 0 && y >= 0 && x < atlas.extent.width && y < atlas.extent.height));
    return image[4 * (static_cast<size_t>(y) * static_cast<size_t>(atlas.extent.width) + static_cast<size_t>(x)) +
                 static_cast<size_t>(channel)];
}

/// The line between four texels around a place in texels, 0.5 being the first one's center. `at(x, y)` gives a texel.
template <class At> double linear(const At& at, double x, double y)
{
    const double left = std::floor(x - 0.5);
    const double low = std::floor(y - 0.5);
    const double across = x - 0.5 - left;
    const double up = y - 0.5 - low;
    const auto i = static_cast<int>(left);
    const auto j = static_cast<int>(low);
    return (1 - up) * ((1 - across) * at(i, j) + across * at(i + 1, j)) +
           up * ((1 - across) * at(i, j + 1) + across * at(i + 1, j + 1));
}

/// OpenGL 4.6, table 8.20: which texel of `count` an index means.
inline int gl_texel(int index, int count, Wrap wrap)
{
    const auto modulo = [](int a, int b) { return ((a % b) + b) % b; };
    if (wrap == Wrap::repeat)
        return modulo(index, count);
    if (wrap == Wrap::clamp)
        return std::min(std::max(index, 0), count - 1);
    const int turned = modulo(index, 2 * count) - count;
    return count - 1 - (turned >= 0 ? turned : -(1 + turned));
}

} // namespace passgraph::test
