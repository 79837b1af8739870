// The files a scene is made of.
#pragma once

#include <string>
#include <vector>

namespace passgraph::tool::view {

/// The scene file, the models it names with what lies beside a .gltf, and the faces of its sky. What cannot be read names
/// nothing; no errors.
std::vector<std::string> files_of_scene(const std::string& scene);

} // namespace passgraph::tool::view
