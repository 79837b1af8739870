// Reads a ready atlas and cuts cells out of it.
#include "ready_atlas.hpp"

#include <filesystem>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>

namespace passgraph::scene_file {
namespace {

constexpr int kNone = -1;

/// 8-bit RGBA, top row first. A 16-bit code becomes the nearest 8-bit one, grey all three colors.
std::vector<std::uint8_t> codes_of(const Picture& picture)
{
    std::vector<std::uint8_t> rgba;
    rgba.reserve(4 * picture.texels.size() / static_cast<size_t>(picture.channels));
    for (int y = picture.extent.height - 1; y >= 0; --y) {
        for (int x = 0; x < picture.extent.width; ++x) {
            for (int c = 0; c < 4; ++c) {
                const bool is_opaque = c == 3 && picture.channels < 4;
                const float value = is_opaque ? 1.0f : picture.at(x, y, picture.channels < 3 ? 0 : c);
                rgba.push_back(static_cast<std::uint8_t>(value * 255.0f + 0.5f));
            }
        }
    }
    return rgba;
}

Texture read(const NamedFile& file, const AtlasEntry& entry, bool is_srgb, Errors& errors)
{
    if (file.path.empty())
        return {};
    std::error_code code;
    if (!std::filesystem::is_regular_file(file.path, code)) {
        errors.push_back({"file_missing", fmt::format("there is no picture {}", file.path),
                          "an atlas's pictures are looked for from the scene file's folder", file.where});
        return {};
    }
    if (const auto holds_codes = holds_display_codes(file.path); holds_codes && !*holds_codes) {
        errors.push_back({"picture_format", fmt::format("{} holds no 8- or 16-bit codes", file.path),
                          "an atlas is made of .png or .jpg pictures; \"emissive_strength\" makes it shine beyond 1",
                          file.where});
        return {};
    }
    const Result<Picture> picture = read_picture(file.path, Transfer::as_is);
    if (!picture) {
        for (Error error : picture.error()) {
            error.where = file.where;
            errors.push_back(std::move(error));
        }
        return {};
    }
    const auto [width, height] = picture->extent;
    if (entry.columns > 0 && (width % entry.columns != 0 || height % entry.rows != 0)) {
        errors.push_back({"value_out_of_range",
                          fmt::format("{} has {} x {} texels, which {} columns and {} rows do not divide", file.path,
                                      width, height, entry.columns, entry.rows),
                          "\"cells\" is [columns, rows]; all cells have the same extent", entry.cells_where});
        return {};
    }
    return {std::filesystem::path(file.path).filename().string(), picture->extent, codes_of(*picture), Wrap::repeat,
            Wrap::repeat, is_srgb};
}

Texture cut(const Texture& whole, Extent cells, const CellEntry& cell)
{
    const Extent extent{whole.extent.width / cells.width, whole.extent.height / cells.height};
    Texture part{fmt::format("{} [{}, {}]", whole.name, cell.column, cell.row), extent, {}, cell.wrap, cell.wrap,
                 whole.is_srgb};
    const size_t row_bytes = 4 * static_cast<size_t>(extent.width);
    for (int y = 0; y < extent.height; ++y) {
        const auto row = static_cast<size_t>(cell.row * extent.height + y);
        const auto column = static_cast<size_t>(cell.column) * row_bytes;
        const std::uint8_t* first = whole.rgba.data() + row * 4 * static_cast<size_t>(whole.extent.width) + column;
        part.rgba.insert(part.rgba.end(), first, first + row_bytes);
    }
    return part;
}

/// The index of the cutout among the model's textures, or -1 without a picture.
int add_cutout(const Texture& whole, Extent cells, const CellEntry& cell, gltf::Model& model)
{
    if (whole.rgba.empty())
        return kNone;
    model.textures.push_back(cut(whole, cells, cell));
    return static_cast<int>(model.textures.size()) - 1;
}

} // namespace

ReadyAtlas load_ready_atlas(const AtlasEntry& entry, Errors& errors)
{
    return {read(entry.albedo, entry, true, errors), read(entry.material, entry, false, errors),
            read(entry.emissive, entry, true, errors), {entry.columns, entry.rows}, entry.emissive_strength};
}

void show_cell(const ReadyAtlas& atlas, const CellEntry& cell, gltf::Model& model)
{
    const int albedo = add_cutout(atlas.albedo, atlas.cells, cell, model);
    const int data = add_cutout(atlas.material, atlas.cells, cell, model);
    const int emissive = add_cutout(atlas.emissive, atlas.cells, cell, model);
    for (Material& material : model.materials) {
        if (albedo != kNone) {
            material.base_color = glm::vec4(1.0f);
            material.base_color_texture = albedo;
        }
        if (data != kNone) {
            material.specular = material.roughness = material.metallic = 1.0f;
            material.specular_texture = material.metallic_roughness_texture = data;
        }
        if (emissive != kNone) {
            material.emissive = glm::vec3(atlas.emissive_strength);
            material.emissive_texture = emissive;
        }
    }
}

} // namespace passgraph::scene_file
