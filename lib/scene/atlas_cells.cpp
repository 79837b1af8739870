// Which cells an atlas has: one for each different material that is used.
#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "atlas_parts.hpp"

namespace passgraph::atlas {
namespace {

constexpr int kNone = -1;
constexpr float kBrightest = 65504.0f; // the largest half

std::vector<bool> used_materials(const Scene& scene)
{
    std::vector<bool> is_used(scene.materials.size(), false);
    for (const Element& element : scene.elements) {
        const int material = scene.meshes.at(static_cast<size_t>(element.mesh)).material;
        assert(material >= 0 && static_cast<size_t>(material) < is_used.size());
        is_used[static_cast<size_t>(material)] = true;
    }
    return is_used;
}

bool are_same(const Texture& a, const Texture& b)
{
    return a.extent == b.extent && a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v && a.is_srgb == b.is_srgb &&
           a.rgba == b.rgba;
}

/// For each texture the first one like it: models that share a file have each read it for themselves.
/// Texels are compared only between textures of one extent, and differ early if they do.
std::vector<int> first_alike(const std::vector<Texture>& textures)
{
    std::map<std::pair<int, int>, std::vector<int>> by_extent;
    std::vector<int> first(textures.size());
    for (size_t i = 0; i < textures.size(); ++i) {
        assert(textures[i].rgba.size() == 4 * static_cast<size_t>(textures[i].extent.width) *
                                              static_cast<size_t>(textures[i].extent.height));
        std::vector<int>& known = by_extent[{textures[i].extent.width, textures[i].extent.height}];
        const auto twin = std::find_if(known.begin(), known.end(), [&](int other) {
            return are_same(textures[static_cast<size_t>(other)], textures[i]);
        });
        first[i] = twin == known.end() ? static_cast<int>(i) : *twin;
        if (twin == known.end())
            known.push_back(static_cast<int>(i));
    }
    return first;
}

/// A factor of 0 makes the texture behind it invisible, and one below 0 or NaN counts as 0.
Channel channel(int texture, size_t component, float factor)
{
    if (!(factor > 0.0f))
        return {};
    const float limited = std::min(factor, kBrightest);
    return texture == kNone ? Channel{kNone, 0, limited} : Channel{texture, component, limited};
}

Recipe recipe_of(const Material& material, const std::vector<int>& first)
{
    const auto alike = [&](int texture) { return texture == kNone ? kNone : first.at(static_cast<size_t>(texture)); };
    const int color = alike(material.base_color_texture);
    const int metallic_roughness = alike(material.metallic_roughness_texture);
    const int emissive = alike(material.emissive_texture);
    Recipe recipe;
    for (size_t c = 0; c < 4; ++c)
        recipe.albedo[c] = channel(color, c, material.base_color[static_cast<int>(c)]);
    for (size_t c = 0; c < 3; ++c)
        recipe.emissive[c] = channel(emissive, c, material.emissive[static_cast<int>(c)]);
    recipe.material = {channel(alike(material.specular_texture), 0, material.specular),
                       channel(metallic_roughness, 1, material.roughness),
                       channel(metallic_roughness, 2, material.metallic)};
    return recipe;
}

Extent largest(const Scene& scene, const Recipe& recipe)
{
    Extent extent{1, 1};
    for (const int texture : textures_of(recipe)) {
        const auto [width, height] = scene.textures[static_cast<size_t>(texture)].extent;
        extent = {std::max(extent.width, width), std::max(extent.height, height)};
    }
    return extent;
}

} // namespace

std::vector<int> textures_of(const Recipe& recipe)
{
    std::vector<int> textures;
    const auto add = [&](const auto& image) {
        for (const Channel& channel : image)
            if (channel.texture != kNone &&
                std::find(textures.begin(), textures.end(), channel.texture) == textures.end())
                textures.push_back(channel.texture);
    };
    add(recipe.albedo);
    add(recipe.material);
    add(recipe.emissive);
    return textures;
}

std::string texture_name(const Scene& scene, int texture)
{
    const std::string& name = scene.textures[static_cast<size_t>(texture)].name;
    return name.empty() ? fmt::format("textures[{}]", texture) : fmt::format("texture `{}`", name);
}

Cells find_cells(const Scene& scene)
{
    const std::vector<bool> is_used = used_materials(scene);
    const std::vector<int> first = first_alike(scene.textures);
    Cells found;
    found.of_material.assign(scene.materials.size(), kNone);
    std::map<Recipe, int> known;
    for (size_t i = 0; i < is_used.size(); ++i) {
        if (!is_used[i])
            continue;
        const Recipe recipe = recipe_of(scene.materials[i], first);
        const auto [entry, is_new] = known.try_emplace(recipe, static_cast<int>(found.cells.size()));
        if (is_new)
            found.cells.push_back({static_cast<int>(i), recipe, largest(scene, recipe)});
        found.of_material[i] = entry->second;
    }
    return found;
}

} // namespace passgraph::atlas
