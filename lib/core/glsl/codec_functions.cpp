// GLSL of the guards, encoders and decoders: what stands between a value and a texel.
#include "passgraph/core/codec.hpp"

#include <fmt/format.h>

namespace passgraph {

std::string_view glsl_codec_functions()
{
    // Guards are ordered selects: a comparison with NaN is false, so NaN takes the other branch on every driver.
    return R"(float passgraph_guard_zero_to_cap(float x, float cap) { return x > 0.0 ? min(x, cap) : 0.0; }
vec2 passgraph_guard_zero_to_cap(vec2 v, float cap) { return vec2(passgraph_guard_zero_to_cap(v.x, cap), passgraph_guard_zero_to_cap(v.y, cap)); }
vec3 passgraph_guard_zero_to_cap(vec3 v, float cap) { return vec3(passgraph_guard_zero_to_cap(v.xy, cap), passgraph_guard_zero_to_cap(v.z, cap)); }
vec4 passgraph_guard_zero_to_cap(vec4 v, float cap) { return vec4(passgraph_guard_zero_to_cap(v.xyz, cap), passgraph_guard_zero_to_cap(v.w, cap)); }
float passgraph_guard_finite(float x, float cap) { return abs(x) <= cap ? x : 0.0; }
vec2 passgraph_guard_finite(vec2 v, float cap) { return vec2(passgraph_guard_finite(v.x, cap), passgraph_guard_finite(v.y, cap)); }
vec3 passgraph_guard_finite(vec3 v, float cap) { return vec3(passgraph_guard_finite(v.xy, cap), passgraph_guard_finite(v.z, cap)); }
float passgraph_guard_positive(float x, float cap) { return x > 0.0 ? min(x, cap) : 1.0; }
vec3 passgraph_guard_unit_vector(vec3 v)
{
    float squared = dot(v, v);
    return squared > 0.0 && squared <= 3.4e38 ? v * inversesqrt(squared) : vec3(0.0, 0.0, 1.0);
}
// For values of which nothing but octahedral codes is kept: those divide by a length of their own.
vec3 passgraph_guard_direction(vec3 v)
{
    float squared = dot(v, v);
    return squared > 0.0 && squared <= 3.4e38 ? v : vec3(0.0, 0.0, 1.0);
}

// Cigolle et al. 2014, "A Survey of Efficient Representations for Independent Unit Vectors": the sphere projected onto
// an octahedron, its lower half folded outwards. `codes` is the format's largest code; one code is exactly 0.
vec2 passgraph_octahedral_sign(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }
vec2 passgraph_octahedral_encode(vec3 n, float codes)
{
    vec2 p = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    p = n.z >= 0.0 ? p : (1.0 - abs(p.yx)) * passgraph_octahedral_sign(p);
    float middle = (codes - 1.0) * 0.5;
    return (p * middle + (middle + 1.0)) / codes;
}
vec3 passgraph_octahedral_decode(vec2 texel, float codes)
{
    float middle = (codes - 1.0) * 0.5;
    vec2 p = (texel * codes - (middle + 1.0)) / middle;
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    n.xy = n.z >= 0.0 ? n.xy : (1.0 - abs(n.yx)) * passgraph_octahedral_sign(n.xy);
    return normalize(n);
}
// Lambert's azimuthal projection (aras-p, "Compact Normal Storage for Small G-Buffers", method 4): +Z in the middle, -Z
// the whole rim. The lower half's radius is taken from z and its direction apart, so that -Z itself lands on the rim.
vec2 passgraph_sphere_map_encode(vec3 n)
{
    float across = length(n.xy);
    vec2 direction = across > 0.0 ? n.xy / across : vec2(1.0, 0.0);
    float radius = n.z > 0.0 ? across * inversesqrt(8.0 * n.z + 8.0) : sqrt(max(1.0 - n.z, 0.0) * 0.125);
    return direction * radius + 0.5;
}
vec3 passgraph_sphere_map_decode(vec2 texel)
{
    vec2 f = texel * 4.0 - 2.0;
    float squared = dot(f, f);
    return normalize(vec3(f * sqrt(max(1.0 - 0.25 * squared, 0.0)), 1.0 - 0.5 * squared));
}
// Whole codes are safe from stores of 10 bits that take floor(1024 x) for the nearest of 1023 x, as llvmpipe does.
vec2 passgraph_octahedral_encode_10(vec3 n) { return floor(passgraph_octahedral_encode(n, 1023.0) * 1023.0 + 0.5) / 1023.0; }
vec3 passgraph_signed_10_encode(vec3 n) { return floor(n * 511.0 + 512.5) / 1023.0; }
vec3 passgraph_signed_10_decode(vec3 texel) { return normalize((texel * 1023.0 - 512.0) / 511.0); }
)";
}

std::string glsl_guard_call(Signal signal, std::string_view value)
{
    const SignalInfo& row = info(signal);
    switch (row.guard) {
    case Guard::zero_to_cap:
        return fmt::format("passgraph_guard_zero_to_cap({}, {:#})", value, row.cap);
    case Guard::finite:
        return fmt::format("passgraph_guard_finite({}, {:#})", value, row.cap);
    case Guard::positive:
        return fmt::format("passgraph_guard_positive({}, {:#})", value, row.cap);
    case Guard::unit_vector:
        return fmt::format("passgraph_guard_unit_vector({})", value);
    }
    return std::string(value);
}

std::string glsl_encode_call(Signal signal, const Codec& codec, std::string_view value)
{
    switch (codec.packing) {
    case Packing::octahedral:
        if (channel_kind(codec.format) == ChannelKind::unorm10)
            return fmt::format("vec4(passgraph_octahedral_encode_10({}), 0.0, 1.0)", value);
        return fmt::format("vec4(passgraph_octahedral_encode({}, {}.0), 0.0, 1.0)", value, largest_code(codec.format));
    case Packing::signed_10:
        return fmt::format("vec4(passgraph_signed_10_encode({}), 1.0)", value);
    case Packing::sphere_map:
        return fmt::format("vec4(passgraph_sphere_map_encode({}), 0.0, 1.0)", value);
    case Packing::linear:
        return fmt::format("vec4(passgraph_distance_of({}), 0.0, 0.0, 1.0)", value);
    case Packing::plain:
        break;
    }
    switch (info(signal).components) {
    case 1:
        return fmt::format("vec4({}, 0.0, 0.0, 1.0)", value);
    case 2:
        return fmt::format("vec4({}, 0.0, 1.0)", value);
    case 3:
        return fmt::format("vec4({}, 1.0)", value);
    default:
        return std::string(value);
    }
}

std::string glsl_decode_call(Signal signal, const Codec& codec, std::string_view texel)
{
    switch (codec.packing) {
    case Packing::octahedral:
        return fmt::format("passgraph_octahedral_decode({}.rg, {}.0)", texel, largest_code(codec.format));
    case Packing::signed_10:
        return fmt::format("passgraph_signed_10_decode({}.rgb)", texel);
    case Packing::sphere_map:
        return fmt::format("passgraph_sphere_map_decode({}.rg)", texel);
    case Packing::linear:
        return fmt::format("passgraph_depth_of({}.r)", texel);
    case Packing::plain:
        break;
    }
    static constexpr const char* kSwizzles[] = {".r", ".rg", ".rgb", ""};
    return fmt::format("{}{}", texel, kSwizzles[info(signal).components - 1]);
}

} // namespace passgraph
