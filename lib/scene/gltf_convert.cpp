// What a parsed glTF file draws: each used primitive once, and where each node puts it.
#include <utility>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

/// Reads meshes when a node first draws them and keeps count of what they cost.
class Meshes {
public:
    Meshes(const File& file, Model& into, Errors& errors)
        : file_(file), into_(into), errors_(errors), materials_(file, into, errors)
    {
    }

    /// The model's meshes that make up one glTF mesh: one per primitive with triangles.
    const std::vector<int>& of(int mesh)
    {
        const auto [known, is_new] = meshes_.try_emplace(mesh);
        if (is_new)
            known->second = read(mesh);
        return known->second;
    }

private:
    std::vector<int> read(int mesh)
    {
        std::vector<int> made;
        const tinygltf::Mesh& from = file_.model.meshes[static_cast<size_t>(mesh)];
        for (size_t i = 0; i < from.primitives.size() && is_affordable(); ++i) {
            const int material = from.primitives[i].material;
            std::optional<Mesh> read = read_primitive(file_, mesh, i, materials_.uv_set_of(material), errors_);
            if (!read)
                continue;
            vertices_ += read->vertices.size();
            indices_ += read->indices.size();
            read->material = materials_.index_of(material);
            made.push_back(static_cast<int>(into_.meshes.size()));
            into_.meshes.push_back(std::move(*read));
        }
        return made;
    }

    bool is_affordable()
    {
        const bool fits = vertices_ <= Limits::kVertices && indices_ <= Limits::kIndices;
        if (!fits && !is_reported_) {
            errors_.push_back(malformed({file_.path}, fmt::format("the model has more than {} vertices or {} indices",
                                                                  Limits::kVertices, Limits::kIndices)));
            is_reported_ = true;
        }
        return fits;
    }

    const File& file_;
    Model& into_;
    Errors& errors_;
    Materials materials_;
    std::map<int, std::vector<int>> meshes_;
    size_t vertices_ = 0;
    size_t indices_ = 0;
    bool is_reported_ = false;
};

} // namespace

Result<Model> convert(const File& file)
{
    Errors errors;
    Model model;
    Meshes meshes(file, model, errors);
    for (const DrawnNode& node : drawn_nodes(file, errors)) {
        for (const int mesh : meshes.of(file.model.nodes[static_cast<size_t>(node.node)].mesh))
            model.placements.push_back({mesh, node.root_from_node});
        if (model.placements.size() > Limits::kElements) {
            errors.push_back(malformed({file.path}, fmt::format("the model has more than {} elements",
                                                                Limits::kElements)));
            break;
        }
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return model;
}

} // namespace passgraph::gltf
