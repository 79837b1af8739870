// What generated GLSL expects of the program that runs it: block layouts, buffer layouts, attribute locations, names.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/declaration.hpp>
#include <passgraph/core/facts.hpp>

namespace passgraph::glsl {

// Names in generated programs.
inline constexpr const char* kCameraBlock = "passgraph_camera_block";
inline constexpr const char* kFrameBlock = "passgraph_frame_block";
inline constexpr const char* kLightsBuffer = "passgraph_lights"; ///< samplerBuffer, kLightTexels RGBA32F each
inline constexpr const char* kElement =
    "passgraph_element"; ///< vec4[kElementRows] uniform, per draw of a geometry step
inline constexpr const char* kAtlasLevels =
    "passgraph_atlas_levels"; ///< vec4[kAtlasLevelCount] uniform, per draw of a geometry step
inline constexpr const char* kAtlasAlbedo = "passgraph_atlas_albedo";
inline constexpr const char* kAtlasMaterial = "passgraph_atlas_material";
inline constexpr const char* kAtlasEmissive = "passgraph_atlas_emissive";

// Vertex attributes of geometry steps: vec3 position, vec3 normal, vec2 uv.
inline constexpr unsigned kPositionLocation = 0;
inline constexpr unsigned kNormalLocation = 1;
inline constexpr unsigned kUvLocation = 2;

/// std140 block of the camera. Matrices are column-major.
struct CameraBlock {
    std::array<float, 16> clip_from_view;
    std::array<float, 16> view_from_world; ///< rotation and translation
    std::array<float, 16> world_from_view;
    std::array<float, 4>
        ray; ///< view_ray(uv) = vec3((uv * 2 - 1) * ray.xy + ray.zw, -1): the view-space place at z = -1
    std::array<float, 4> range; ///< near, far, 0, 0
};
static_assert(sizeof(CameraBlock) == 224);

/// std140 block of the frame.
struct FrameBlock {
    float time = 0.0f;       ///< seconds, wrapped at 3600
    float delta = 0.0f;      ///< seconds since the last frame
    std::int32_t index = 0;  ///< frame number
    std::int32_t is_cut = 1; ///< 1 when nothing of the last frame is to be trusted
    std::int32_t light_count = 0;
    std::int32_t padding[3] = {0, 0, 0};
};
static_assert(sizeof(FrameBlock) == 32);

/// A light in the lights buffer, in view space. One form for every kind, so that a loop over lights has no branches:
///   0  (color, 1 / radius^2 rounded up so that radius^2 times it is at least 1; 0: without an end)
///   1  (position, 1), or (unit vector against the light's direction, 0) of a directional light
///   2  (axis * scale, offset): inside the cone share = clamp(offset - dot(to the light, axis * scale), 0, 1)^2; (0, 0, 0, 1)
///      shines all around
inline constexpr int kLightTexels = 3;

/// So few lights, if the scene is known to have no more, are no buffer but the uniform vec4[count * kLightTexels] of this name:
/// software rasterisers fetch a buffer's texel per pixel. A scene with fewer fills up with black ones.
inline constexpr int kFewLights = 4;
inline constexpr const char* kLightRows = "passgraph_light_rows";

/// The uniform vec3[kHarmonics] beside a cube's sampler: coefficients of the sky's irradiance, see irradiance.hpp of gl.
inline constexpr int kHarmonics = 9;
std::string harmonics_name(std::string_view sampler);

/// What a draw is told of its element, row by row. Uniforms, not a buffer: software rasterisers fetch a texel per pixel.
///   0 1 2  rows of view_from_model: view.x = dot(row 0, vec4(place, 1))
///   3 4 5  rows of its normal matrix in xyz: the cofactors (adjugate's transpose) of view_from_model's 3x3 times the
///          sign of its determinant, largest element 1 in size, so singular and mirrored transforms stay finite and
///          normals point outwards, of any length; w of row 3 is 1 when the transform mirrors, of 4 and 5 it is 0
///   6      its cell of the atlas: texels of level 0 in x and y, the last level, wrap_u + 4 wrap_v (0 repeat, 1 mirror,
///          2 clamp)
inline constexpr int kElementRows = 7;

/// Rectangles (x, y, width, height in uv) of an element's levels in the atlas: as many as a texture of 16384 has.
inline constexpr int kAtlasLevelCount = 15;

/// GLSL of the accessors for what a step reads: view_ray(uv), light(i), random(pixel, n), ...
std::string accessors(const Reads& reads, PassKind kind, const Facts& facts = {});
/// GLSL of the element accessors in the vertex stage of a geometry step.
std::string vertex_accessors(const Reads& reads);
/// Names those accessors define, for messages and reserved-name checks.
const std::vector<std::string>& accessor_names(const std::string& read);

} // namespace passgraph::glsl
