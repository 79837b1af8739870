// What the values of an image mean. Ports connect only when their signals are equal.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace passgraph {

/// The meaning of an image's values. `color` is generic: on a port it accepts any of the first four and passes on what
/// it got; no image is ever of signal `color` once a graph is validated.
enum class Signal : std::uint8_t {
    radiance,
    radiance_alpha,
    display,
    display_alpha,
    albedo,
    material,
    normal,
    position,
    depth,
    atlas_uv,
    mask,
    velocity,
    exposure,
    reflectance,
    color,
};

/// How a value is kept inside its domain: an ordered select, because min, max and clamp of NaN are undefined in GLSL.
enum class Guard : std::uint8_t {
    zero_to_cap, ///< x > 0 ? min(x, cap) : 0, per channel
    unit_vector, ///< a finite vector of positive length is scaled to length 1, anything else is +Z
    finite,      ///< |x| <= cap ? x : 0, per channel
    positive,    ///< x > 0 ? min(x, cap) : 1
};

struct SignalInfo {
    Signal signal;
    std::string_view name;
    std::string_view meaning;
    std::string_view unit;
    int components; ///< of a value as a pass sees it
    Guard guard;
    float cap;             ///< largest value of the domain
    bool is_generic_color; ///< a port of signal `color` accepts it
    bool has_alpha;        ///< components counts the alpha
};

const SignalInfo& info(Signal signal);

/// The values that a component of the signal may have.
struct Domain {
    double lowest = 0.0;
    double highest = 0.0;
};
Domain domain_of(Signal signal);
const std::vector<SignalInfo>& all_signals();
std::optional<Signal> find_signal(std::string_view name);

/// The GLSL type of a value: float, vec2, vec3 or vec4.
std::string_view glsl_type(int components);

/// True when an image of signal `image` may be wired to a port of signal `port`.
bool accepts(Signal port, Signal image);

// Tags that make a wrong wire a compile error: Image<Radiance> does not convert to Image<Display>.
struct Radiance {
    static constexpr Signal signal = Signal::radiance;
};
struct RadianceAlpha {
    static constexpr Signal signal = Signal::radiance_alpha;
};
struct Display {
    static constexpr Signal signal = Signal::display;
};
struct DisplayAlpha {
    static constexpr Signal signal = Signal::display_alpha;
};
struct Albedo {
    static constexpr Signal signal = Signal::albedo;
};
struct MaterialSignal {
    static constexpr Signal signal = Signal::material;
};
struct Normal {
    static constexpr Signal signal = Signal::normal;
};
struct Position {
    static constexpr Signal signal = Signal::position;
};
struct Depth {
    static constexpr Signal signal = Signal::depth;
};
struct AtlasUv {
    static constexpr Signal signal = Signal::atlas_uv;
};
struct Mask {
    static constexpr Signal signal = Signal::mask;
};
struct Velocity {
    static constexpr Signal signal = Signal::velocity;
};
struct Exposure {
    static constexpr Signal signal = Signal::exposure;
};
struct Reflectance {
    static constexpr Signal signal = Signal::reflectance;
};

} // namespace passgraph
