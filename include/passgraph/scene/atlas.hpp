// The texture atlas: all materials of a scene in one texture, each level of each a rectangle of its own.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include <passgraph/core/error.hpp>
#include <passgraph/core/picture.hpp>
#include <passgraph/scene/scene.hpp>

namespace passgraph {

/// A level's rectangle in texels of the atlas, without the gutter of one texel around it.
struct AtlasRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    friend bool operator==(const AtlasRect&, const AtlasRect&) = default;
};

/// A material's place in the atlas. Level 0 has the largest extent of its textures; the last level is one texel.
struct AtlasCell {
    std::vector<AtlasRect> levels; ///< empty for a material that no element uses
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;

    friend bool operator==(const AtlasCell&, const AtlasCell&) = default;
};

/// Three images in step, to be uploaded as they are: one place holds a surface's color, material and emission.
///
/// Shape    `extent` texels each, rows in the order of Texture: row 0 is v = 0, so the first row of each file is the
///          first row of its rectangles. Sides are multiples of 4, and 4 x 4 where nothing is drawn.
/// Units    `albedo` sRGB codes (alpha linear); `material` linear codes; `emissive` scene-linear radiance.
struct Atlas {
    Extent extent;
    std::vector<std::uint8_t> albedo;    ///< RGBA8: base color texture times factor
    std::vector<std::uint8_t> material;  ///< RGBA8: specular, roughness, metallic times their factors, then 255
    std::vector<std::uint16_t> emissive; ///< RGBA halves, alpha 0; empty when nothing emits
    std::vector<AtlasCell> cells;        ///< by index of Scene::materials; equal materials share their rectangles
};

/// Puts the materials of a scene's elements into one atlas, all factors multiplied in.
///
/// Shape    level k has max(1, floor(n / 2^k)) texels a side: the sizes of an OpenGL mip chain, whose texels are never
///          smaller than the footprint for which `atlas_level` chooses them. A material without textures has one texel.
///          A gutter of one texel surrounds each level and holds what the texture's wrap mode gives there, so a linear
///          fetch anywhere in the rectangle, its border included, never sees a neighbor. Anisotropic filtering reaches
///          further: do not use it here.
/// Units    levels are averaged as linear light, by area (also at odd sizes), from unrounded values: a level has the
///          mean of the one before.
/// Range    a texture smaller than its material's largest is enlarged linearly, under its own wrap mode. Textures of
///          one material that wrap differently are fine while its uv stay in [0, 1]; the cell then clamps.
/// Errors   atlas_full (the machine's): one material's texture, or all together, exceed `max_extent`, which is the
///          device's largest texture side; names the texture. texture_wraps_differ: wrap modes differ within a material
///          whose uv leave [0, 1] by more than half a texel. Every such material is named. Asserts a well-formed scene:
///          every index inside its array, every texture of its extent; factors below 0 or NaN count as 0.
/// Cost     O(texels), some 30 ns each; packing tries about 30 widths and keeps the smallest, most square result.
///          Deterministic: equal scenes give equal atlases, byte for byte.
/// Source   own derivation; packing by stb_rect_pack (skyline, bottom left).
Result<Atlas> make_atlas(const Scene& scene, int max_extent);

/// Where a coordinate lands in [0, 1] under a wrap mode. passes/common/atlas.glsl mirrors this and the next two.
///
/// Range    repeat stays below 1, also just below a whole number (-1e-9 gives the float before 1); mirror and clamp
///          reach 1. 0 for NaN; an infinite coordinate gives 0, or for clamp its end.
/// Errors   none
/// Cost     constant.
/// Source   OpenGL 4.6 specification, table 8.20, for coordinates instead of texels.
float atlas_wrap(float x, Wrap mode);

/// The level whose texels match a pixel: the rounded binary logarithm of the longer of two gradients.
///
/// Units    `dx_texels`, `dy_texels`: how far the unwrapped uv move from a pixel to the next, in texels of level 0.
/// Range    0 to `last`; an infinite gradient gives `last`, and one that is NaN counts as none.
/// Errors   none; asserts 0 <= last.
/// Cost     constant.
/// Source   OpenGL 4.6 specification, equations 8.7 and 8.8 and section 8.14.3, NEAREST between levels; Williams 1983.
int atlas_level(glm::vec2 dx_texels, glm::vec2 dy_texels, int last);

/// The place of `inside`, wrapped coordinates in [0, 1], in texels of the atlas. Divide by its extent for uv.
///
/// Range    from the rectangle's lower border to its upper one, both included: a linear fetch there reads the gutter.
/// Errors   none
/// Cost     constant.
/// Source   own derivation.
glm::vec2 atlas_place(const AtlasRect& rect, glm::vec2 inside);

} // namespace passgraph
