// Values to feed passes with: inside a contract's domain, at its edges, and far outside of it.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include <passgraph/core/contract.hpp>
#include <passgraph/core/declaration.hpp>
#include <passgraph/core/picture.hpp>

namespace passgraph::tool::contract {

/// 64 roundings of binary32: what a law and a range leave to arithmetic.
inline constexpr double kRounding = 64.0 / 16777216.0;

/// Which values a port's components may hold: the contract's, else the signal's own domain.
Contract::Span span_of(const std::vector<Contract::Span>& stated, const std::string& port, Signal signal);
/// Whether the signal's values are light, of which the laws speak.
bool is_light(Signal signal);

enum class Filling {
    random, ///< any value of the domain, small ones as often as large ones
    edges,  ///< each component at one end of the domain, at 0 or at 1, chosen anew for each texel
    lowest,
    highest,
    alike, ///< random, but the same for inputs of one signal, whose differences then are 0
};
std::string_view name(Filling filling);

/// A picture of a signal's values within the span.
Picture picture_of(Filling filling, Signal signal, const Contract::Span& span, Extent extent, std::mt19937& random);
/// Light between 0 and `most`, the same for a state of `random`.
Picture light(Extent extent, int channels, double most, std::mt19937& random);

/// A value that no picture should hold, or that few programs are ready for.
struct Injection {
    const char* name;
    float value;
};
const std::vector<Injection>& injections();

/// Whether every component of the texel may be `value`.
bool is_in_domain(float value, Signal signal, const Contract::Span& span);

} // namespace passgraph::tool::contract
