// What a pass promises about its values. The contract suite checks it; the compiler never looks at it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/error.hpp>
#include <passgraph/core/formula.hpp>

namespace passgraph {

/// A relation between what goes in and what comes out. "Light" is an image of signal radiance, display or color.
///
/// A law is checked with values inside the contract's domain, parameters at their defaults and every choice and rung, and
/// allows 64 roundings of binary32 (64 * 2^-24 relative) unless it says "exactly".
enum class Law : std::uint8_t {
    constant, ///< light equal in every texel of every input comes back with that value in every texel
    black,    ///< where every light input is 0 everywhere, every light output is exactly 0
    energy,   ///< of one light input at most c, all other light 0 and no lamps, no light output makes more than c
    monotone, ///< more light in some texel of one input makes no light output smaller anywhere
    mirror,   ///< inputs turned left to right, or upside down, turn the outputs likewise
    scale,    ///< twice the light in every input makes exactly twice the light in every output
};
inline constexpr std::size_t kLawCount = 6;
std::string_view name(Law law);
std::string_view meaning(Law law); ///< one sentence, as above

struct Contract {
    /// Values of a port, per component; the signal's own domain where the header names none.
    struct Span {
        std::string port;
        double lowest = 0.0;
        double highest = 0.0;
        bool is_saturated = false; ///< a range whose upper end the inputs may lift beyond the signal's: the store cuts there
        Location where{};
    };
    enum class NonFinite : std::uint8_t {
        replaced,  ///< whatever comes in, what goes out is finite and in range
        contained, ///< what goes out may be anything within `within` texels of the bad one, and beyond is as if it were not there
    };

    bool is_stated = false; ///< the header has a contract; else the suite checks what the signals say
    std::vector<Span> domain;
    std::vector<Span> range;
    NonFinite non_finite = NonFinite::contained;
    std::optional<Formula> within; ///< texels of the input, by parameters; none: as far as the pass reads
    std::vector<std::string> anywhere; ///< inputs that are looked up at computed places: a bad texel of theirs may reach any
    std::vector<Law> laws;
    Location where{};
};

} // namespace passgraph
