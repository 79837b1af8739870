// A glTF file on its way into a scene: the steps, from bytes to placed meshes.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <tiny_gltf.h>

#include <passgraph/core/error.hpp>
#include <passgraph/core/json.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph::gltf {

/// What a file may ask for before we call it absurd: enough for any model that a GPU of today draws.
struct Limits {
    static constexpr size_t kFileBytes = size_t{1} << 30;
    static constexpr size_t kBufferBytes = size_t{1} << 31;  ///< all buffers together
    static constexpr size_t kTextureBytes = size_t{1} << 30; ///< all images together: one of the largest side
    static constexpr int kTextureSide = 16384;
    static constexpr size_t kVertices = size_t{1} << 24; ///< of one accessor, and of all meshes together
    static constexpr size_t kIndices = size_t{1} << 26;
    static constexpr size_t kElements = size_t{1} << 20;
};

/// A file that was read: its bytes, its located JSON and what tinygltf made of it.
struct File {
    std::string path;
    std::string bytes;
    bool is_binary = false;
    std::string_view text;  ///< the JSON part of `bytes`
    size_t binary_size = 0; ///< of a .glb's BIN chunk
    Json json;
    tinygltf::Model model;
    std::map<int, std::string> broken_images; ///< by index: why the image could not be decoded
};

/// A mesh of a model and where its node puts it.
struct Placement {
    int mesh = 0;
    glm::dmat4 root_from_mesh{1.0};
};

/// A whole model, apart from any scene; indices point into its own arrays.
struct Model {
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Mesh> meshes;
    std::vector<Placement> placements;
};

Error malformed(Location where, std::string message, std::string hint = "");
Error unsupported(Location where, std::string message, std::string hint = "");

/// The place of entry `index` of a top-level array such as "accessors".
Location place_of(const File& file, std::string_view section, int index);

/// A member that the rules have already checked, as a size.
size_t size_or(const Json& object, std::string_view key, size_t fallback);
/// The entries of a top-level array; empty when absent.
const std::vector<Json>& entries_of(const Json& root, std::string_view section);

/// The bytes a component takes (0: no such type) and the components of "SCALAR", "VEC3", … (0: no such type).
size_t component_bytes(int component_type);
size_t components_of(std::string_view type);

// One step each, in the order in which `read_model` takes them.
Errors open_file(File& file);                           // gltf_file.cpp      bytes, .glb chunks, JSON
Errors check_rules(const Json& root);                   // gltf_rules.cpp     every field's type, every index
Errors check_layout(const File& file);                  // gltf_layout.cpp    accessors inside views inside buffers
Errors check_uris(const File& file);                    // gltf_uris.cpp      files beside the model, data: uris
Errors check_nodes(const Json& root);                   // gltf_nodes.cpp     a forest
Errors parse(File& file);                               // gltf_parse.cpp     tinygltf
Result<Model> convert(const File& file);                // gltf_convert.cpp   our meshes, materials, placements

/// All steps. Errors: file_missing, file_unreadable, gltf_malformed, gltf_unsupported; a .glb's without line.
Result<Model> read_model(const std::string& path);

/// Adds what the model draws with; gives the scene's index of the model's first mesh.
int add_resources(Scene& scene, const Model& model);
/// Adds an element per placement. Several are called name.0, name.1, …
Errors place_elements(Scene& scene, const Model& model, int first_mesh, const glm::dmat4& world_from_model,
                      const std::string& name, const std::string& path);

/// A drawn node and where it is, seen from the model's root.
struct DrawnNode {
    int node = 0;
    glm::dmat4 root_from_node{1.0};
};

/// The nodes with a mesh of the default scene (else of all roots), parents first.
std::vector<DrawnNode> drawn_nodes(const File& file, Errors& errors); // gltf_nodes.cpp

/// An accessor's elements as floats (normalized integers in [0, 1] or [-1, 1]); nothing when one is not finite.
std::optional<std::vector<float>> read_floats(const File& file, int accessor, Errors& errors); // gltf_accessor.cpp
/// An accessor's elements as indices.
std::vector<std::uint32_t> read_indices(const File& file, int accessor); // gltf_accessor.cpp

/// One primitive as triangles; nothing when it draws none. `uv_set` is the n of TEXCOORD_n.
std::optional<Mesh> read_primitive(const File& file, int mesh, size_t primitive, int uv_set,
                                   Errors& errors); // gltf_primitive.cpp

/// Collects the materials and textures that meshes use, each once.
class Materials {
public:
    Materials(const File& file, Model& into, Errors& errors) : file_(file), into_(into), errors_(errors) {}

    /// Index into the model's materials; -1 asks for glTF's default material.
    int index_of(int material);
    /// The texture coordinate set that the material's textures use.
    int uv_set_of(int material);

private:
    Material read(int material);
    int texture_of(int texture, bool is_srgb, const Location& where);

    const File& file_;
    Model& into_;
    Errors& errors_;
    std::map<int, int> materials_;
    std::map<std::array<int, 4>, int> textures_; ///< image, wraps, srgb
    size_t texture_bytes_ = 0;
};

} // namespace passgraph::gltf
