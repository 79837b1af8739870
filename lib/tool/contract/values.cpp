// Fills pictures with values of a domain, its edges, and what lies beyond.
#include "tool/contract/values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <passgraph/core/signal.hpp>

namespace passgraph::tool::contract {
namespace {

/// Only the engine is used: distributions differ between standard libraries.
double unit(std::mt19937& random) { return static_cast<double>(random() >> 8) / 16777216.0; }

/// Small values as often as large ones: between 1e-8 of the span's size and all of it, with zeros among them.
double value_between(double lowest, double highest, std::mt19937& random)
{
    const double size = std::max(std::abs(lowest), std::abs(highest));
    if (unit(random) < 0.05)
        return std::clamp(0.0, lowest, highest);
    if (size <= 2.0 || unit(random) < 0.5)
        return lowest + (highest - lowest) * unit(random);
    const double magnitude = size * std::pow(10.0, -8.0 * unit(random));
    return std::clamp(lowest < 0.0 && unit(random) < 0.5 ? -magnitude : magnitude, lowest, highest);
}

double edge_between(double lowest, double highest, std::mt19937& random)
{
    const std::array<double, 5> edges = {lowest, highest, 0.0, 1.0, 0.5 * (lowest + highest)};
    return std::clamp(edges[random() % edges.size()], lowest, highest);
}

std::array<double, 3> direction(Filling filling, std::mt19937& random)
{
    if (filling != Filling::random && filling != Filling::alike) {
        std::array<double, 3> axis = {0.0, 0.0, 0.0};
        const auto which = filling == Filling::edges ? random() % 6 : filling == Filling::lowest ? 5u : 4u;
        axis[which / 2] = which % 2 == 0 ? 1.0 : -1.0;
        return axis;
    }
    const double z = 2.0 * unit(random) - 1.0;
    const double around = 6.283185307179586 * unit(random);
    const double r = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {r * std::cos(around), r * std::sin(around), z};
}

/// Places in view space that a camera may see: metres, in front of it; and its own, of a pixel without geometry.
double place(size_t component, Filling filling, std::mt19937& random)
{
    const double reach = filling == Filling::random || filling == Filling::alike ? std::pow(10.0, 6.0 * unit(random) - 3.0) : 1000.0;
    if (filling == Filling::lowest || (filling == Filling::edges && random() % 4 == 0))
        return 0.0;
    return component == 2 ? -reach : reach * (2.0 * unit(random) - 1.0);
}

} // namespace

bool is_light(Signal signal) { return signal == Signal::color || info(signal).is_generic_color; }

Contract::Span span_of(const std::vector<Contract::Span>& stated, const std::string& port, Signal signal)
{
    for (const Contract::Span& span : stated)
        if (span.port == port) {
            Contract::Span known = span;
            known.highest = std::min(known.highest, static_cast<double>(info(signal).cap)); // of what a generic port got
            return known;
        }
    const SignalInfo& row = info(signal);
    const bool is_signed = row.guard == Guard::finite || row.guard == Guard::unit_vector;
    Contract::Span span{.port = port, .lowest = is_signed ? -static_cast<double>(row.cap) : 0.0, .highest = row.cap};
    if (row.guard == Guard::positive)
        span.lowest = std::numeric_limits<float>::min();
    return span;
}

std::string_view name(Filling filling)
{
    static constexpr std::array<std::string_view, 5> kNames = {"random values", "values at the domain's edges",
                                                               "the domain's lowest value", "the domain's highest value",
                                                               "the same random values in all inputs of a signal"};
    return kNames[static_cast<size_t>(filling)];
}

Picture picture_of(Filling filling, Signal signal, const Contract::Span& span, Extent extent, std::mt19937& random)
{
    const int components = info(signal).components;
    Picture picture(extent, components);
    const auto width = static_cast<size_t>(components);
    for (size_t texel = 0; texel < picture.texels.size(); texel += width) {
        const std::array<double, 3> facing = direction(filling, random);
        for (size_t c = 0; c < width; ++c) {
            double value = filling == Filling::edges     ? edge_between(span.lowest, span.highest, random)
                           : filling == Filling::lowest  ? span.lowest
                           : filling == Filling::highest ? span.highest
                                                         : value_between(span.lowest, span.highest, random);
            if (signal == Signal::normal)
                value = facing[c];
            if (signal == Signal::position)
                value = place(c, filling, random);
            picture.texels[texel + c] = static_cast<float>(value);
        }
    }
    return picture;
}

Picture light(Extent extent, int channels, double most, std::mt19937& random)
{
    Picture picture(extent, channels);
    for (float& value : picture.texels)
        value = static_cast<float>(most * std::pow(unit(random), 3.0));
    return picture;
}

const std::vector<Injection>& injections()
{
    static const std::vector<Injection> all = {{"NaN", std::numeric_limits<float>::quiet_NaN()},
                                               {"+Inf", std::numeric_limits<float>::infinity()},
                                               {"-Inf", -std::numeric_limits<float>::infinity()},
                                               {"-1000", -1000.0f},
                                               {"65504", 65504.0f},
                                               {"65520", 65520.0f},
                                               {"1e-8", 1e-8f},
                                               {"-0", -0.0f},
                                               {"1e-40", 1e-40f}};
    return all;
}

bool is_in_domain(float value, Signal signal, const Contract::Span& span)
{
    if (signal == Signal::normal)
        return false; // no vector of three equal components is among the injected ones
    return value >= span.lowest && value <= span.highest;
}

} // namespace passgraph::tool::contract
