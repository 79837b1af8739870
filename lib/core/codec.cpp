// The table of codecs, and the host's half of decoding.
#include "passgraph/core/codec.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace passgraph {
namespace {

struct FormatRow {
    Format format;
    std::string_view name;
    int bytes;
    int channels;
    ChannelKind kind;
};

constexpr std::array<FormatRow, 16> kFormats = {{
    {Format::r8, "r8", 1, 1, ChannelKind::unorm8},
    {Format::rg8, "rg8", 2, 2, ChannelKind::unorm8},
    {Format::rgba8, "rgba8", 4, 4, ChannelKind::unorm8},
    {Format::srgb8_a8, "srgb8_a8", 4, 4, ChannelKind::unorm8},
    {Format::rgb10_a2, "rgb10_a2", 4, 4, ChannelKind::unorm10},
    {Format::rg16, "rg16", 4, 2, ChannelKind::unorm16},
    {Format::rgba16, "rgba16", 8, 4, ChannelKind::unorm16},
    {Format::r16f, "r16f", 2, 1, ChannelKind::half},
    {Format::rg16f, "rg16f", 4, 2, ChannelKind::half},
    {Format::rgba16f, "rgba16f", 8, 4, ChannelKind::half},
    {Format::r11f_g11f_b10f, "r11f_g11f_b10f", 4, 3, ChannelKind::small_float},
    {Format::r32f, "r32f", 4, 1, ChannelKind::single},
    {Format::rg32f, "rg32f", 8, 2, ChannelKind::single},
    {Format::rgba32f, "rgba32f", 16, 4, ChannelKind::single},
    {Format::depth24, "depth24", 4, 1, ChannelKind::depth},
    {Format::depth32f, "depth32f", 4, 1, ChannelKind::depth},
}};

std::array<float, 3> normalised(float x, float y, float z)
{
    const float length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0.0f) || !std::isfinite(length))
        return {0.0f, 0.0f, 1.0f};
    return {x / length, y / length, z / length};
}

/// `codes` is the largest code of the format; code (codes + 1) / 2 is exactly 0.
std::array<float, 3> octahedral_direction(float u, float v, float codes)
{
    const float half = (codes - 1.0f) * 0.5f;
    float x = std::max((u * codes - (half + 1.0f)) / half, -1.0f);
    float y = std::max((v * codes - (half + 1.0f)) / half, -1.0f);
    const float z = 1.0f - std::abs(x) - std::abs(y);
    if (z < 0.0f) {
        const float folded_x = (1.0f - std::abs(y)) * (x >= 0.0f ? 1.0f : -1.0f);
        y = (1.0f - std::abs(x)) * (y >= 0.0f ? 1.0f : -1.0f);
        x = folded_x;
    }
    return normalised(x, y, z);
}

std::array<float, 3> sphere_map_direction(float u, float v)
{
    const float x = 4.0f * u - 2.0f;
    const float y = 4.0f * v - 2.0f;
    const float squared = x * x + y * y;
    const float scale = std::sqrt(std::max(1.0f - 0.25f * squared, 0.0f));
    return normalised(x * scale, y * scale, 1.0f - 0.5f * squared);
}

/// Reversed depth d = n (f - z) / (z (f - n)); a distance of 0 says that nothing is there.
float device_depth(float distance, DepthRange range)
{
    if (!(distance > 0.0f))
        return 0.0f;
    return range.near_plane * (range.far_plane - distance) / (distance * (range.far_plane - range.near_plane));
}

std::array<float, 3> signed_10_direction(const float* texel)
{
    const auto component = [](float code) { return std::max((code * 1023.0f - 512.0f) / 511.0f, -1.0f); };
    return normalised(component(texel[0]), component(texel[1]), component(texel[2]));
}

float guarded(float value, Guard guard, float cap)
{
    switch (guard) {
    case Guard::zero_to_cap:
        return value > 0.0f ? std::min(value, cap) : 0.0f;
    case Guard::finite:
        return std::abs(value) <= cap ? value : 0.0f;
    case Guard::positive:
        return value > 0.0f ? std::min(value, cap) : 1.0f;
    case Guard::unit_vector:
        break;
    }
    return value;
}

} // namespace

std::string_view name(Format format) { return kFormats[static_cast<size_t>(format)].name; }

int bytes_per_texel(Format format) { return kFormats[static_cast<size_t>(format)].bytes; }

bool is_depth(Format format) { return channel_kind(format) == ChannelKind::depth; }

int channel_count(Format format) { return kFormats[static_cast<size_t>(format)].channels; }

ChannelKind channel_kind(Format format) { return kFormats[static_cast<size_t>(format)].kind; }

int largest_code(Format format)
{
    switch (channel_kind(format)) {
    case ChannelKind::unorm8:
        return 255;
    case ChannelKind::unorm10:
        return 1023;
    default:
        return 65535;
    }
}

const std::vector<Codec>& codecs_of(Signal signal)
{
    using enum Format;
    static const std::vector<Codec> radiance = {
        {"rgba16f", rgba16f}, {"r11f_g11f_b10f", r11f_g11f_b10f}, {"rgba32f", rgba32f}};
    static const std::vector<Codec> radiance_alpha = {{"rgba16f", rgba16f}, {"rgba32f", rgba32f}};
    static const std::vector<Codec> display = {
        {"rgba8", rgba8}, {"rgb10_a2", rgb10_a2}, {"rgba16f", rgba16f}, {"rgba32f", rgba32f}};
    static const std::vector<Codec> display_alpha = {{"rgba8", rgba8}, {"rgba16f", rgba16f}, {"rgba32f", rgba32f}};
    static const std::vector<Codec> albedo = {
        {"srgb8_a8", srgb8_a8}, {"rgba8", rgba8}, {"rgba16f", rgba16f}, {"rgba32f", rgba32f}};
    static const std::vector<Codec> material = {{"rgba8", rgba8}, {"rgba16f", rgba16f}, {"rgba32f", rgba32f}};
    static const std::vector<Codec> normal = {{"octahedral_rg16", rg16, Packing::octahedral},
                                              {"octahedral_rg8", rg8, Packing::octahedral},
                                              {"octahedral_rg10", rgb10_a2, Packing::octahedral},
                                              {"sphere_map_rg16", rg16, Packing::sphere_map},
                                              {"sphere_map_rg32f", rg32f, Packing::sphere_map},
                                              {"rgb10_a2", rgb10_a2, Packing::signed_10},
                                              {"rgba16f", rgba16f},
                                              {"rgba32f", rgba32f}};
    static const std::vector<Codec> position = {{"rgba32f", rgba32f}, {"rgba16f", rgba16f}};
    static const std::vector<Codec> depth = {{"depth32f", depth32f}, {"depth24", depth24}, {"r32f", r32f}, {"linear_r32f", r32f, Packing::linear}};
    static const std::vector<Codec> atlas_uv = {{"rg16", rg16}, {"rg16f", rg16f}, {"rg32f", rg32f}};
    static const std::vector<Codec> mask = {{"r8", r8}, {"r16f", r16f}, {"r32f", r32f}};
    static const std::vector<Codec> velocity = {{"rg16f", rg16f}, {"rg32f", rg32f}};
    static const std::vector<Codec> exposure = {{"r32f", r32f}};
    static const std::vector<Codec> reflectance = {{"rg16", rg16}, {"rg16f", rg16f}, {"rg32f", rg32f}};
    switch (signal) {
    case Signal::radiance:
    case Signal::color:
        return radiance;
    case Signal::radiance_alpha:
        return radiance_alpha;
    case Signal::display:
        return display;
    case Signal::display_alpha:
        return display_alpha;
    case Signal::albedo:
        return albedo;
    case Signal::material:
        return material;
    case Signal::normal:
        return normal;
    case Signal::position:
        return position;
    case Signal::depth:
        return depth;
    case Signal::atlas_uv:
        return atlas_uv;
    case Signal::mask:
        return mask;
    case Signal::velocity:
        return velocity;
    case Signal::exposure:
        return exposure;
    case Signal::reflectance:
        return reflectance;
    }
    return radiance;
}

const Codec* find_codec(Signal signal, std::string_view codec)
{
    for (const Codec& row : codecs_of(signal))
        if (row.name == codec)
            return &row;
    return nullptr;
}

std::vector<std::string> codec_names(Signal signal)
{
    std::vector<std::string> names;
    for (const Codec& row : codecs_of(signal))
        names.emplace_back(row.name);
    return names;
}

Picture decode_texels(const Picture& raw, Signal signal, const Codec& codec, DepthRange range)
{
    const int components = info(signal).components;
    Picture decoded(raw.extent, components);
    const auto codes = static_cast<float>(largest_code(codec.format));
    for (int y = 0; y < raw.extent.height; ++y) {
        for (int x = 0; x < raw.extent.width; ++x) {
            const float* texel = &raw.texels[raw.index(x, y)];
            float* value = &decoded.texels[decoded.index(x, y)];
            if (codec.packing == Packing::plain) {
                for (int c = 0; c < components; ++c)
                    value[c] = c < raw.channels ? texel[c] : c == 3 ? 1.0f : 0.0f;
                continue;
            }
            if (codec.packing == Packing::linear) {
                value[0] = device_depth(texel[0], range);
                continue;
            }
            const auto direction = codec.packing == Packing::octahedral ? octahedral_direction(texel[0], texel[1], codes)
                                   : codec.packing == Packing::sphere_map
                                       ? sphere_map_direction(texel[0], texel[1])
                                       : signed_10_direction(texel);
            std::copy(direction.begin(), direction.end(), value);
        }
    }
    return decoded;
}

void apply_guard(Picture& picture, Signal signal)
{
    const SignalInfo& row = info(signal);
    if (row.guard == Guard::unit_vector) {
        for (size_t i = 0; i + 2 < picture.texels.size(); i += static_cast<size_t>(picture.channels)) {
            const auto unit = normalised(picture.texels[i], picture.texels[i + 1], picture.texels[i + 2]);
            std::copy(unit.begin(), unit.end(), picture.texels.begin() + static_cast<std::ptrdiff_t>(i));
        }
        return;
    }
    for (float& value : picture.texels)
        value = guarded(value, row.guard, row.cap);
}

} // namespace passgraph
