// A ready atlas's pictures, and the materials that are cut out of them.
#pragma once

#include <passgraph/core/error.hpp>
#include <passgraph/scene/scene.hpp>

#include "gltf.hpp"
#include "scene_fields.hpp"

namespace passgraph::scene_file {

/// The pictures of an atlas, whole; without texels where there is none.
struct ReadyAtlas {
    Texture albedo;
    Texture material;
    Texture emissive;
    Extent cells;
    float emissive_strength = 1.0f;
};

/// Reads the pictures.
///
/// Errors   file_missing and those of read_picture; picture_format for one that holds no codes (.exr, .hdr, .pfm);
///          value_out_of_range where columns or rows do not divide a picture's texels. All at the scene file's fields.
ReadyAtlas load_ready_atlas(const AtlasEntry& entry, Errors& errors);

/// Gives all materials of a model what a cell shows: for each picture of the atlas, the cutout replaces texture and
/// factor; what the atlas has no picture for stays as the model has it.
void show_cell(const ReadyAtlas& atlas, const CellEntry& cell, gltf::Model& model);

} // namespace passgraph::scene_file
