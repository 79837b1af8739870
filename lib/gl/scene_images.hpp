// What of a scene is computed before it is uploaded: no GL, so on any thread.
#pragma once

#include <optional>

#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/atlas.hpp>
#include <passgraph/scene/facts.hpp>

#include "gl/objects.hpp"
#include "gl/textures.hpp"

namespace passgraph {

class SceneImages::Impl {
public:
    std::optional<gl::CubeLevels> sky;
    Atlas atlas;
    Facts facts;
    std::vector<int> lights; ///< all, those that reach a surface first: programs for few take no others
};

namespace gl {

/// Errors   scene_malformed, texture_too_large, scene_too_large, those of make_atlas and of cube_faces.
Result<SceneImages::Impl> make_scene_images(const Scene& scene, const Limits& limits);

} // namespace gl
} // namespace passgraph
