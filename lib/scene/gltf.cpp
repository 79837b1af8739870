// From a .gltf or .glb file to elements of a scene.
#include "gltf.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <passgraph/scene/scene_file.hpp>

namespace passgraph {
namespace gltf {
namespace {

constexpr const char* kMalformed = "gltf_malformed";
constexpr const char* kUnsupported = "gltf_unsupported";

/// A place inside a .glb's JSON chunk helps nobody: the file has no lines.
Errors without_lines(Errors errors)
{
    for (Error& error : errors)
        error.where = {error.where.file};
    return errors;
}

Result<Model> read_opened(File& file)
{
    if (Errors errors = check_rules(file.json); !errors.empty())
        return tl::unexpected(std::move(errors));
    Errors errors = check_layout(file);
    for (Errors more : {check_uris(file), check_nodes(file.json)})
        errors.insert(errors.end(), more.begin(), more.end());
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    if (errors = parse(file); !errors.empty())
        return tl::unexpected(std::move(errors));
    return convert(file);
}

/// As it is drawn: in single precision.
bool is_finite(const glm::dmat4& matrix)
{
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(static_cast<float>(glm::value_ptr(matrix)[i])))
            return false;
    return true;
}

} // namespace

Error malformed(Location where, std::string message, std::string hint)
{
    return {kMalformed, std::move(message), std::move(hint), std::move(where)};
}

Error unsupported(Location where, std::string message, std::string hint)
{
    return {kUnsupported, std::move(message), std::move(hint), std::move(where)};
}

Location place_of(const File& file, std::string_view section, int index)
{
    const auto& entries = entries_of(file.json, section);
    const auto at = static_cast<size_t>(index);
    return at < entries.size() ? entries[at].where : Location{file.path};
}

size_t size_or(const Json& object, std::string_view key, size_t fallback)
{
    const Json* value = object.find(key);
    return value ? static_cast<size_t>(value->number) : fallback;
}

const std::vector<Json>& entries_of(const Json& root, std::string_view section)
{
    static const std::vector<Json> none;
    const Json* array = root.find(section);
    return array ? array->array : none;
}

Result<Model> read_model(const std::string& path)
{
    File file;
    file.path = path;
    if (Errors errors = open_file(file); !errors.empty())
        return tl::unexpected(file.is_binary ? without_lines(std::move(errors)) : std::move(errors));
    Result<Model> model = read_opened(file);
    if (!model && file.is_binary)
        return tl::unexpected(without_lines(std::move(model.error())));
    return model;
}

int add_resources(Scene& scene, const Model& model)
{
    const int first_texture = static_cast<int>(scene.textures.size());
    const int first_material = static_cast<int>(scene.materials.size());
    const int first_mesh = static_cast<int>(scene.meshes.size());
    scene.textures.insert(scene.textures.end(), model.textures.begin(), model.textures.end());
    for (Material material : model.materials) {
        for (int* texture : {&material.base_color_texture, &material.metallic_roughness_texture,
                             &material.emissive_texture}) {
            if (*texture >= 0)
                *texture += first_texture;
        }
        scene.materials.push_back(std::move(material));
    }
    for (Mesh mesh : model.meshes) {
        mesh.material += first_material;
        scene.meshes.push_back(std::move(mesh));
    }
    return first_mesh;
}

Errors place_elements(Scene& scene, const Model& model, int first_mesh, const glm::dmat4& world_from_model,
                      const std::string& name, const std::string& path)
{
    Errors errors;
    std::vector<Element> elements;
    for (const Placement& placement : model.placements) {
        const bool is_only = model.placements.size() == 1;
        Element element{is_only ? name : fmt::format("{}.{}", name, elements.size()), first_mesh + placement.mesh,
                        world_from_model * placement.root_from_mesh};
        if (!is_finite(element.world_from_model)) {
            errors.push_back({"value_out_of_range", fmt::format("`{}` is placed at no finite place", element.name),
                              "its position, scale and nodes multiply to more than a float holds", {path}});
        }
        elements.push_back(std::move(element));
    }
    if (errors.empty())
        scene.elements.insert(scene.elements.end(), elements.begin(), elements.end());
    return errors;
}

} // namespace gltf

Result<void> append_gltf(Scene& scene, const std::string& path, const glm::dmat4& world_from_model,
                         const std::string& element_name)
{
    const Result<gltf::Model> model = gltf::read_model(path);
    if (!model)
        return tl::unexpected(model.error());
    const int first_mesh = static_cast<int>(scene.meshes.size());
    const std::string name = element_name.empty() ? std::filesystem::path(path).stem().string() : element_name;
    Errors errors = gltf::place_elements(scene, *model, first_mesh, world_from_model, name, path);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    gltf::add_resources(scene, *model);
    return {};
}

} // namespace passgraph
