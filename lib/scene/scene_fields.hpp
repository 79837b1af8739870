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

struct ElementEntry {
    std::string name;
    NamedFile model;
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
    std::vector<ElementEntry> elements;
    std::vector<Light> lights;
};

Entries read_entries(const Json& root, Errors& errors);

Camera read_camera(const Json& camera, Errors& errors);                         // scene_camera.cpp
Light read_light(const Json& light, std::string fallback_name, Errors& errors); // scene_lights.cpp

/// A number that a float holds and that lies in a range; anything else is reported and gives the fallback.
struct Range {
    double low;
    double high;
    bool is_open = false; ///< the ends themselves are excluded
};
float number_in(JsonFields& fields, std::string_view key, float fallback, Range range, Errors& errors);
/// Three finite numbers; reports field_missing when `is_required`. False: absent or wrong.
bool vector_of(JsonFields& fields, std::string_view key, glm::vec3& out, bool is_required);
/// Reports a vector without length.
bool has_length(JsonFields& fields, std::string_view key, const glm::vec3& vector, Errors& errors);
void out_of_range(const Json& value, std::string message, Errors& errors, std::string hint = "");

inline constexpr float kLargestColor = 65504.0f; ///< the largest half: radiance's domain

} // namespace passgraph::scene_file
