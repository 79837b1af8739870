// A scene file and everything it names, loaded into one scene.
#include "passgraph/scene/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>
#include <passgraph/scene/bounds.hpp>

#include "gltf.hpp"
#include "ready_atlas.hpp"
#include "scene_fields.hpp"

namespace passgraph {
namespace {

using scene_file::ElementEntry;
using scene_file::SkyEntry;

/// Reads each model once, however many elements show it; once more for each cell that it shows, because a mesh has one
/// material wherever it stands.
class Models {
public:
    Models(Scene& scene, const scene_file::ReadyAtlas& atlas, Errors& errors)
        : scene_(scene), atlas_(atlas), errors_(errors)
    {
    }

    void place(const ElementEntry& entry)
    {
        if (entry.model.path.empty())
            return; // its mistake is reported already
        std::string key = std::filesystem::path(entry.model.path).lexically_normal().string();
        if (const auto& cell = entry.cell)
            key += fmt::format(" [{}, {}] {}", cell->column, cell->row, static_cast<int>(cell->wrap));
        const auto [known, is_new] = models_.try_emplace(key);
        if (is_new)
            known->second = load(entry);
        const Loaded& loaded = known->second;
        const size_t first = scene_.elements.size();
        Errors errors = gltf::place_elements(scene_, loaded.model, loaded.first_mesh, entry.world_from_model,
                                             entry.name, entry.where.file);
        for (size_t i = first; i < scene_.elements.size(); ++i)
            check_reach(scene_.elements[i], errors);
        for (Error& error : errors)
            error.where = entry.where;
        append(errors_, errors);
    }

private:
    struct Loaded {
        gltf::Model model; ///< only what is needed to place it once more
        int first_mesh = 0;
    };

    /// Lighting squares distances, so places end where a float's squares do.
    void check_reach(const Element& element, Errors& errors) const
    {
        constexpr float kFarthest = 1e18f;
        const Bounds box = bounds(scene_, element);
        const glm::vec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
        if (!box.is_empty() && !(std::max({reach.x, reach.y, reach.z}) <= kFarthest))
            errors.push_back({"value_out_of_range", fmt::format("`{}` reaches further than {} metres", element.name, kFarthest),
                              "scale it down, or move it nearer", {}});
    }

    Loaded load(const ElementEntry& entry)
    {
        std::error_code code;
        if (!std::filesystem::exists(entry.model.path, code)) {
            errors_.push_back({"file_missing", fmt::format("there is no model {}", entry.model.path),
                               "models are looked for from the scene file's folder", entry.model.where});
            return {};
        }
        Result<gltf::Model> model = gltf::read_model(entry.model.path);
        if (!model) {
            append(errors_, model.error());
            return {};
        }
        if (entry.cell)
            scene_file::show_cell(atlas_, *entry.cell, *model);
        const int first_mesh = gltf::add_resources(scene_, *model);
        return {{{}, {}, {}, std::move(model->placements)}, first_mesh};
    }

    Scene& scene_;
    const scene_file::ReadyAtlas& atlas_;
    Errors& errors_;
    std::map<std::string, Loaded> models_;
};

void load_sky(Scene& scene, const SkyEntry& entry, Errors& errors)
{
    if (entry.faces.path.empty())
        return;
    std::error_code code;
    if (!std::filesystem::is_directory(entry.faces.path, code)) {
        errors.push_back({"file_missing", fmt::format("there is no folder {}", entry.faces.path),
                          "\"faces\" is a folder with the pictures px nx py ny pz nz", entry.faces.where});
        return;
    }
    auto faces = read_cube(entry.faces.path);
    if (!faces) {
        for (Error error : faces.error()) {
            error.where = entry.faces.where; // a picture has no lines: the scene file says which folder is meant
            errors.push_back(std::move(error));
        }
        return;
    }
    scene.sky.faces = std::move(*faces);
    if (entry.intensity == 1.0f)
        return; // as it was stored, not-a-numbers included
    for (Picture& face : scene.sky.faces)
        for (float& texel : face.texels)
            texel *= entry.intensity;
}

/// The camera for a scene file without one; a scene beyond a float's reach has none.
Camera default_camera(const Scene& scene, const Location& where, Errors& errors)
{
    const Camera camera = framing_camera(bounds(scene));
    const double sum = camera.position.x + camera.position.y + camera.position.z + camera.far_plane;
    if (!std::isfinite(sum) || !std::isnormal(camera.near_plane)) {
        errors.push_back({"value_out_of_range", "the scene is too large or too small to be framed",
                          "scale its elements, or give a \"camera\"", where});
    }
    return camera;
}

} // namespace

Result<Scene> load_scene(const std::string& path)
{
    const Result<std::string> text = read_text_file(path);
    if (!text)
        return tl::unexpected(text.error());
    const Result<Json> json = parse_json(*text, path);
    if (!json)
        return tl::unexpected(json.error());

    Errors errors;
    scene_file::Entries entries = scene_file::read_entries(*json, errors);
    Scene scene;
    scene.name = std::move(entries.name);
    scene.lights = std::move(entries.lights);
    const auto atlas = entries.atlas ? scene_file::load_ready_atlas(*entries.atlas, errors) : scene_file::ReadyAtlas{};
    Models models(scene, atlas, errors);
    for (const ElementEntry& element : entries.elements)
        models.place(element);
    if (entries.sky)
        load_sky(scene, *entries.sky, errors);
    if (scene.materials.empty())
        scene.materials.push_back({.name = "default"});
    if (errors.empty())
        scene.camera = entries.camera ? *entries.camera : default_camera(scene, json->where, errors);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return scene;
}

} // namespace passgraph
