// The state no step changes, as tables that the baseline sets and the guard saves.
#pragma once

#include "gl/functions.hpp"

namespace passgraph::gl {

// Uniform blocks are bound at fixed places.
inline constexpr int kCameraBinding = 0;
inline constexpr int kFrameBinding = 1;
inline constexpr int kUniformBufferCount = 2;

/// Whatever would change a value on its way into a target, or keep it from getting there. Dithering is among it: the
/// same plan gives the same bits.
inline constexpr GLenum kAlwaysOff[] = {
    GL_BLEND,
    GL_SCISSOR_TEST,
    GL_STENCIL_TEST,
    GL_DITHER,
    GL_COLOR_LOGIC_OP,
    GL_DEPTH_CLAMP,
    GL_POLYGON_OFFSET_FILL,
    GL_RASTERIZER_DISCARD,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_COVERAGE,
    GL_SAMPLE_MASK,
    GL_PRIMITIVE_RESTART,
    GL_CLIP_DISTANCE0,
    GL_CLIP_DISTANCE1,
    GL_CLIP_DISTANCE2,
    GL_CLIP_DISTANCE3,
    GL_CLIP_DISTANCE4,
    GL_CLIP_DISTANCE5,
    GL_CLIP_DISTANCE6,
    GL_CLIP_DISTANCE7,
};

struct PixelStore {
    GLenum name;
    GLint value;
};

/// How rows lie in memory: close together, from the first texel on.
inline constexpr PixelStore kPixelStores[] = {
    {GL_PACK_ALIGNMENT, 1},   {GL_PACK_ROW_LENGTH, 0},    {GL_PACK_SKIP_ROWS, 0},    {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SWAP_BYTES, 0},  {GL_PACK_LSB_FIRST, 0},     {GL_UNPACK_ALIGNMENT, 1},  {GL_UNPACK_ROW_LENGTH, 0},
    {GL_UNPACK_SKIP_ROWS, 0}, {GL_UNPACK_SKIP_PIXELS, 0}, {GL_UNPACK_SWAP_BYTES, 0}, {GL_UNPACK_LSB_FIRST, 0},
};

} // namespace passgraph::gl
