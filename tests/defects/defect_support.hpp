// The 2017 demo's ways of doing things, as passes, beside our own.
#pragma once

#include <string>

#include <passgraph/scene/scene.hpp>

#include "graphs/graph_runner.hpp"
#include "support/pass_runner.hpp"

namespace passgraph::test {

/// Where the reconstructed passes of the original are: `original_blur`, `original_lighting`, …
std::string original_folder();
/// Our passes and those.
const PassLibrary& with_original();

/// The demo's scene.
const Scene& night_lamp();

/// A square of side 2 facing +Z, at a distance along -Z, with a plain material.
struct Square {
    double distance = 4.0;
    glm::vec3 color{1.0f};
    float specular = 0.5f;
    float roughness = 1.0f;
    float metallic = 0.0f;
};
Scene squares(const std::vector<Square>& all);

/// Runs a graph's text over a scene; `original_*` passes can be used.
std::map<std::string, Picture> run_scene(const std::string& graph, const Scene& scene, Extent extent);

} // namespace passgraph::test
