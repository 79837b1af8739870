// Scenes that lamps, cameras and meshes of every kind stand in, for passes that read them.
#pragma once

#include <passgraph/scene/scene.hpp>

namespace passgraph::tool::contract {

Scene unlit_scene();
/// A sun, and lamps near and far.
Scene lit_scene();
/// Lamps in a surface's own place, of radius 0, without a direction, and as bright as a radiance may be.
Scene hard_scene();
/// Triangles with normals of 0, of 1e-20 and 1e20, opposite ones that meet, without area, across the near plane and behind it.
Scene hard_meshes();

} // namespace passgraph::tool::contract
