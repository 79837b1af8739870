// A scene in OpenGL: meshes, the atlas of their materials, sky, and the lights.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <passgraph/scene/atlas.hpp>
#include <passgraph/scene/bounds.hpp>
#include <passgraph/scene/scene.hpp>

#include "gl/scene_images.hpp"
#include "gl/textures.hpp"
#include "gl/view_space.hpp"

namespace passgraph::gl {

/// A buffer read through a samplerBuffer of RGBA32F.
struct BufferTexture {
    BufferObject buffer;
    TextureObject texture;
};

struct MeshBuffers {
    VertexArrayObject vertex_array;
    BufferObject vertices;
    BufferObject indices;
    GLsizei index_count = 0;
};

/// The atlas as textures of one level, in step, read linearly.
struct AtlasTextures {
    TextureObject albedo;
    TextureObject material;
    TextureObject emissive; ///< one black texel when nothing emits
    GLuint sampler = 0;
};

/// One element, ready to draw.
struct ElementDraw {
    bool is_double_sided = false;
    bool is_mirrored = false;
    int mesh = 0;
    int element = 0;
    Bounds box;            ///< in the world
    double distance = 0.0; ///< from the viewer, squared
};

struct SceneBuffers {
    std::vector<MeshBuffers> meshes;
    AtlasTextures atlas;
    Atlas places;                          ///< without texels: where each material stands in the atlas
    std::vector<ElementDraw> draws;        ///< from front to back, so that what is hidden is not shaded
    Cube sky;                              ///< empty when the scene has none
    std::vector<glm::vec4> element_rows;   ///< glsl::kElementRows per element, as the camera sees them
    std::vector<glm::vec4> element_levels; ///< glsl::kAtlasLevelCount per element
    Facts facts;                           ///< of the scene
    std::vector<int> light_order;          ///< the scene's lights, those that reach a surface first
    std::vector<glm::vec4> light_rows;     ///< glsl::kLightTexels per light, as the camera sees them; at least kFewLights
    BufferTexture lights;               ///< the same, for programs that take any number
};

/// Uploads a scene, and the images that were made of it.
/// Errors   gl_error, out_of_memory.
Result<SceneBuffers> create_scene_buffers(Upload& upload, Samplers& samplers, const Scene& scene, SceneImages::Impl images);

/// Elements and lights as a camera sees them.
void upload_view(Upload& upload, SceneBuffers& buffers, const Scene& scene, const View& view);

/// Every index that points outside (scene_malformed), and everything beyond the device's limits (texture_too_large,
/// scene_too_large: more elements or lights than a buffer texture holds).
Errors find_scene_errors(const Scene& scene, const Limits& limits);

} // namespace passgraph::gl
