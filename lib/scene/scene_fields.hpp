// The parts of a scene file, read field by field; mistakes are collected with their place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <passgraph/core/error.hpp>
#include <passgraph/core/json.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph::scene_file {

/// A path of the file and where it stands, for complaints about what is behind it.
struct NamedFile {
    std::string path;
    Location where;
};

/// The cell of the scene's ready atlas that an element shows; counted from the file's top left.
struct CellEntry {
    int column = 0;
    int row = 0;
    Wrap wrap = Wrap::repeat;
    Location where;
};

/// A ready atlas: pictures of whole materials in rows and columns. A path is empty where there is no such picture.
struct AtlasEntry {
    NamedFile albedo;
    NamedFile material;
    NamedFile emissive;
    float emissive_strength = 1.0f;
    int columns = 0; ///< 0: not known, because "cells" is wrong
    int rows = 0;
    Location cells_where;
};

struct ElementEntry {
    std::string name;
    NamedFile model;
    std::optional<CellEntry> cell;
    glm::dmat4 world_from_model{1.0};
    Location where;
};

struct SkyEntry {
    NamedFile faces;
    float intensity = 1.0f;
};

/// A scene file as written: nothing it names is loaded yet.
struct Entries {
    std::string name;
    std::optional<Camera> camera;
    std::optional<SkyEntry> sky;
    std::optional<AtlasEntry> atlas;
    std::vector<ElementEntry> elements;
    std::vector<Light> lights;
};

Entries read_entries(const Json& root, Errors& errors);

Camera read_camera(const Json& camera, Errors& errors);                         // scene_camera.cpp
Light read_light(const Json& light, std::string fallback_name, Errors& errors); // scene_lights.cpp
AtlasEntry read_atlas(const Json& atlas, Errors& errors);                       // scene_atlas.cpp
/// An element's "cell" and "wrap".
std::optional<CellEntry> read_cell(JsonFields& fields, Errors& errors); // scene_atlas.cpp
/// Reports each cell that the atlas does not have, and takes it from its element.
void check_cells(Entries& entries, Errors& errors); // scene_atlas.cpp

/// A file that must be named; its path is relative to the scene file.
NamedFile read_file_name(JsonFields& fields, std::string_view key, Errors& errors);

/// A number that a float holds and that lies in a range; anything else is reported and gives the fallback.
struct Range {
    double low;
    double high;
    bool is_open = false; ///< the ends themselves are excluded
};
float number_in(JsonFields& fields, std::string_view key, float fallback, Range range, Errors& errors);
/// Three finite numbers; reports field_missing when `is_required`. False: absent or wrong.
bool vector_of(JsonFields& fields, std::string_view key, glm::vec3& out, bool is_required);
bool vector_of(JsonFields& fields, std::string_view key, glm::dvec3& out, bool is_required);
/// Reports a vector without length.
bool has_length(JsonFields& fields, std::string_view key, const glm::dvec3& vector, Errors& errors);
void out_of_range(const Json& value, std::string message, Errors& errors, std::string hint = "");

inline constexpr float kLargestColor = 65504.0f; ///< the largest half: radiance's domain

} // namespace passgraph::scene_file
