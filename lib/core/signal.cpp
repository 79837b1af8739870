// The table of signals: meaning, unit, domain.
#include "passgraph/core/signal.hpp"

#include <array>
#include <cassert>

namespace passgraph {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr float kLargestFloat = 3.4e38f;

const std::vector<SignalInfo>& table()
{
    using enum Signal;
    using enum Guard;
    static const std::vector<SignalInfo> rows = {
        {radiance, "radiance", "scene-linear RGB, Rec. 709 primaries", "W/(sr m2), relative", 3, zero_to_cap,
         kLargestHalf, true, false},
        {radiance_alpha, "radiance_alpha", "scene-linear RGB, premultiplied alpha", "W/(sr m2), relative", 4,
         zero_to_cap, kLargestHalf, true, true},
        {display, "display", "sRGB-encoded RGB", "code / largest code", 3, zero_to_cap, 1.0f, true, false},
        {display_alpha, "display_alpha", "sRGB-encoded RGB, premultiplied alpha", "code / largest code", 4, zero_to_cap,
         1.0f, true, true},
        {albedo, "albedo", "linear reflectance RGB", "1", 3, zero_to_cap, 1.0f, false, false},
        {material, "material", "specular, roughness, metallic", "1", 3, zero_to_cap, 1.0f, false, false},
        {normal, "normal", "unit vector, view space", "1", 3, unit_vector, 1.0f, false, false},
        {position, "position", "place in view space", "m", 3, finite, kLargestFloat, false, false},
        {depth, "depth", "reversed device depth, 1 near, 0 far", "1", 1, zero_to_cap, 1.0f, false, false},
        {atlas_uv, "atlas_uv", "place in the texture atlas", "1", 2, zero_to_cap, 1.0f, false, false},
        {mask, "mask", "coverage or occlusion", "1", 1, zero_to_cap, 1.0f, false, false},
        {velocity, "velocity", "movement since the last frame", "texels", 2, finite, kLargestHalf, false, false},
        {exposure, "exposure", "a multiplier of radiance", "1", 1, positive, kLargestHalf, false, false},
        {reflectance, "reflectance", "of uniform light: f0 * x + y", "1", 2, zero_to_cap, 1.0f, false, false},
        {color, "color", "generic: radiance or display, with or without alpha", "as given", 3, zero_to_cap,
         kLargestHalf, false, false},
    };
    return rows;
}

} // namespace

const SignalInfo& info(Signal signal)
{
    const SignalInfo& row = table()[static_cast<size_t>(signal)];
    assert(row.signal == signal);
    return row;
}

const std::vector<SignalInfo>& all_signals() { return table(); }

std::optional<Signal> find_signal(std::string_view name)
{
    for (const SignalInfo& row : table())
        if (row.name == name)
            return row.signal;
    return std::nullopt;
}

std::string_view glsl_type(int components)
{
    static constexpr std::array<std::string_view, 4> kTypes = {"float", "vec2", "vec3", "vec4"};
    assert(components >= 1 && components <= 4);
    return kTypes[static_cast<size_t>(components) - 1];
}

bool accepts(Signal port, Signal image)
{
    return port == image || (port == Signal::color && info(image).is_generic_color);
}

Domain domain_of(Signal signal)
{
    const SignalInfo& row = info(signal);
    const bool is_signed = row.guard == Guard::finite || row.guard == Guard::unit_vector;
    return {is_signed ? -static_cast<double>(row.cap) : 0.0, static_cast<double>(row.cap)};
}

} // namespace passgraph
