// Scene files (JSON) and the glTF models they name.
#pragma once

#include <string>

#include <glm/glm.hpp>

#include <passgraph/core/error.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph {

/// Loads a scene file and every model and sky face it names (paths relative to the file).
///
/// Errors   every mistake of the scene file with line and column (json_syntax, json_duplicate_key, unknown_field,
///          field_missing, wrong_type, value_out_of_range), and of each model (those of `append_gltf`) and the sky.
/// Cost     dominated by decoding textures.
Result<Scene> load_scene(const std::string& path);

/// Adds a .gltf or .glb model to the scene: its default scene's nodes become elements, placed by `world_from_model`.
///
/// Range    normals of length 1 (computed flat from the triangles where missing or zero); uv 0 where missing.
/// Errors   file_missing, gltf_malformed (not glTF, truncated, an index, accessor, buffer view, texture or node pointing
///          outside, a cycle of nodes, non-finite positions), each naming what points where.
/// Source   glTF 2.0 specification; KHR_materials_specular, KHR_materials_emissive_strength.
Result<void> append_gltf(Scene& scene, const std::string& path, const glm::dmat4& world_from_model,
                         const std::string& element_name);

} // namespace passgraph
