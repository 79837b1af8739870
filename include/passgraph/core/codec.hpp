// How a signal is stored in texels.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/picture.hpp>
#include <passgraph/core/signal.hpp>

namespace passgraph {

/// Texel formats, by their OpenGL names in small letters.
enum class Format : std::uint8_t {
    r8,
    rg8,
    rgba8,
    srgb8_a8,
    rgb10_a2,
    rg16,
    rgba16,
    r16f,
    rg16f,
    rgba16f,
    r11f_g11f_b10f,
    r32f,
    rg32f,
    rgba32f,
    depth24,
    depth32f,
};

std::string_view name(Format format);
int bytes_per_texel(Format format);
bool is_depth(Format format);
int channel_count(Format format);

/// What a channel of a format holds; a packed code fits only channels of its own kind, a plain value any but depth.
enum class ChannelKind : std::uint8_t { unorm8, unorm10, unorm16, small_float, half, single, depth };
ChannelKind channel_kind(Format format);
/// The largest code of a fixed-point channel: 255, 1023 or 65535. Range: unorm8, unorm10 and unorm16 formats.
int largest_code(Format format);

/// The value in the texel: which GLSL functions `encode_X(value) -> vec4` and `decode_X(vec4) -> value` are used.
enum class Packing : std::uint8_t {
    plain,      ///< channels are the value; missing ones read 0, alpha 1
    octahedral, ///< unit vector folded onto a square, 0 exactly representable in 8 and 16 bits
    signed_10,  ///< unit vector, each component at 1 + 511 x of 1022 codes
    sphere_map, ///< unit vector by Lambert's azimuthal projection, +Z in the middle, -Z the whole rim
    linear,     ///< depth as the distance along -Z in metres, 0 where nothing is
};

/// One row of the table in which each signal lists its codecs, default first.
struct Codec {
    std::string_view name;
    Format format = Format::rgba32f;
    Packing packing = Packing::plain;

    friend bool operator==(const Codec&, const Codec&) = default;
};

/// The codecs that may store a signal, default first; binary32 is among them for every color and vector signal.
const std::vector<Codec>& codecs_of(Signal signal);

/// The named codec of a signal, or nullptr.
const Codec* find_codec(Signal signal, std::string_view codec);
std::vector<std::string> codec_names(Signal signal);

/// The camera's planes in metres, which turn distances into device depth.
struct DepthRange {
    float near_plane = 0.1f;
    float far_plane = 1000.0f;
};

/// Decodes raw texels read back from a texture into the signal's values.
///
/// Shape    keeps the extent; channels become the signal's components.
/// Source   Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors" (octahedral).
Picture decode_texels(const Picture& raw, Signal signal, const Codec& codec, DepthRange range = {});

/// Brings host values into the signal's domain, as the GLSL guard does: non-finite and negative values become 0.
void apply_guard(Picture& picture, Signal signal);

/// GLSL text of every guard, encode and decode function (`guard_NAME`, `encode_…`, `decode_…`) a step may call.
/// Linear depth asks for the camera's block: `passgraph_linear_…` are among its accessors.
std::string glsl_guard_call(Signal signal, std::string_view value);
std::string glsl_encode_call(Signal signal, const Codec& codec, std::string_view value);
std::string glsl_decode_call(Signal signal, const Codec& codec, std::string_view texel);
std::string_view glsl_codec_functions();

} // namespace passgraph
