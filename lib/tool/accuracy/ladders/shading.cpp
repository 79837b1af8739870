// Two terms of the BRDF: GGX's density, which cancels, and Fresnel's power, which need not be a pow.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tool/accuracy/ladders/ladders.hpp"
#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::accuracy {
namespace {

// The smallest roughness that lighting uses: the sharpest highlight, and the hardest case.
constexpr float kRoughness = 0.045f;

/// Half vectors at 1e-4 to 0.1 rad from normals all over the hemisphere, in every direction around them.
Inputs normals_and_halves(Extent extent)
{
    const auto place = [&](int x, int y) {
        const double tilt = 1.2 * std::fmod(0.6180339887 * y, 1.0); // golden steps: rows fill the hemisphere evenly
        const double turn = 2.0 * std::numbers::pi * std::fmod(0.7548776662 * y + 0.1 * x / extent.width, 1.0);
        const reference::Vector n{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
        const reference::Vector across{std::cos(tilt) * std::cos(turn), std::cos(tilt) * std::sin(turn), -std::sin(tilt)};
        const reference::Vector along{-std::sin(turn), std::cos(turn), 0.0};
        const double angle = 1e-4 * std::pow(1e3, (x + 0.5) / extent.width);
        const double around = 2.0 * std::numbers::pi * std::fmod(0.5698402910 * (x + 31 * y), 1.0);
        reference::Vector h{};
        for (size_t c = 0; c < 3; ++c)
            h[c] = std::cos(angle) * n[c] + std::sin(angle) * (std::cos(around) * across[c] + std::sin(around) * along[c]);
        return std::pair(n, h);
    };
    return {{{"normals", picture_of(extent, [&](int x, int y) { return place(x, y).first; })},
             {"halves", picture_of(extent, [&](int x, int y) { return place(x, y).second; })}},
            nullptr};
}

Truth densities(const Inputs& inputs, Extent extent)
{
    // The stored vectors are what is given: their own rounding is no error of the form.
    Truth truth{extent, 1, {}};
    const double alpha = static_cast<double>(kRoughness) * kRoughness;
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            truth.values.push_back(reference::ggx_density(texel(inputs.pictures.at("normals"), x, y), texel(inputs.pictures.at("halves"), x, y), alpha));
    return truth;
}

/// Cosines of 0 to 1, evenly and close to 1, and one in 64 that rounding left just above it.
Inputs cosines(Extent extent)
{
    return {{{"cosines", picture_of(extent, [&](int x, int y) {
                  const double even = (x + 0.5) / extent.width;
                  const double close = 1.0 - std::pow(10.0, -6.0 * even);
                  const double beyond = (x + y) % 64 == 0 ? 1.0 + std::ldexp(1.0, -23) : (y + 0.5) / extent.height;
                  return std::array<double, 3>{even, close, beyond};
              })}},
            nullptr};
}

Truth edge_weights(const Inputs& inputs, Extent extent)
{
    return truth_of(extent, [&](int x, int y) {
        std::array<double, 3> weights = texel(inputs.pictures.at("cosines"), x, y);
        for (double& weight : weights)
            weight = reference::schlick_weight(weight);
        return weights;
    });
}

/// Cosines of 1e-3 to 1 by roughnesses of 0.05 to 1.
Inputs cosines_and_roughnesses(Extent extent)
{
    return {{{"angles", picture_of(extent, [&](int x, int y) {
                  return std::array<double, 3>{std::pow(10.0, -3.0 * (1.0 - (x + 0.5) / extent.width)), 0.05 + 0.95 * (y + 0.5) / extent.height, 0.0};
              })}},
            nullptr};
}

Truth facets_seen(const Inputs& inputs, Extent extent)
{
    Truth truth{extent, 1, {}};
    const Picture& angles = inputs.pictures.at("angles");
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x)
            truth.values.push_back(reference::beckmann_seen(angles.at(x, y, 0), static_cast<double>(angles.at(x, y, 1)) * angles.at(x, y, 1)));
    return truth;
}

Rung masking_rung(const std::string& masking, const std::string& what, double bound)
{
    return {.name = masking,
            .what = what,
            .graph = R"({ "passgraph": 1, "inputs": { "angles": "position" },
  "passes": { "seen": { "pass": "facets_seen", "inputs": { "angles": "angles" }, "codecs": { "seen": "rgba32f" } } },
  "outputs": { "result": "seen" } })",
            .settings = {{"seen.beckmann_masking", masking}},
            .bound = bound,
            .has_guards = false};
}

Rung form_rung(const std::string& form, const std::string& what, double bound)
{
    return {.name = form,
            .what = what,
            .graph = R"({ "passgraph": 1, "inputs": { "normals": "position", "halves": "position" },
  "passes": { "density": { "pass": "ggx_density", "inputs": { "normals": "normals", "halves": "halves" }, "codecs": { "density": "rgba32f" } } },
  "outputs": { "result": "density" } })",
            .settings = {{"density.ggx_form", form}},
            .bound = bound,
            .has_guards = false}; // a guard would hide what is no number
}

Rung power_rung(const std::string& power, const std::string& what, double bound)
{
    return {.name = power,
            .what = what,
            .graph = R"({ "passgraph": 1, "inputs": { "cosines": "position" },
  "passes": { "edge": { "pass": "fresnel_edge", "inputs": { "cosines": "cosines" }, "codecs": { "weight": "rgba32f" } } },
  "outputs": { "result": "edge" } })",
            .settings = {{"edge.fresnel_power", power}},
            .bound = bound,
            .has_guards = false};
}

} // namespace

Ladder ggx_form()
{
    Ladder ladder{.name = "ggx_form",
                  .title = "The shape of a highlight: GGX",
                  .stage = "lighting",
                  .about = "GGX's density at roughness 0.045, the sharpest that is lit, for normals all over the hemisphere and half vectors within 0.1 rad. "
                           "The textbook subtracts two numbers close to 1; the Lagrange identity takes the sine from the cross product instead.",
                  .passes = {"pbr", "pbr_surface"},
                  .measures = {{"pbr", "ggx_form"}, {"pbr_surface", "ggx_form"}},
                  .metric = {"relative error, 99th percentile", "", Distance::relative, Summary::p99},
                  .make_inputs = normals_and_halves,
                  .find_truth = densities,
                  .describe_input =
                      [](const Inputs& in, int x, int y) {
                          return fmt::format("half vector {:.4g} degrees from the normal",
                                             reference::angle_degrees(texel(in.pictures.at("normals"), x, y), texel(in.pictures.at("halves"), x, y)));
                      },
                  .shown = Shown::logarithmic,
                  .crop_center = {0.45, 0.5}};
    // A cosine near 1 is known to 2^-24 or so, four times that after the dot product's roundings; D's condition in it is
    // 4 cos^2 / (alpha^2 + sin^2) * ..., at most 4 / alpha^2 = 9.8e5: 9.8e5 * 4 * 2^-24 = 0.23, both for 1 - c^2 and for
    // (1 - c)(1 + c), which saves the subtraction's own half. The cross product of unit vectors rounds to 2^-25 in each of
    // six products: sin is off by up to 3 * 2^-25 in 99 of 100, D by 2 / alpha of that ... 4e-5; 2e-5 is asked and held.
    ladder.rungs = {
        form_rung("textbook", "cos^2 (alpha^2 - 1) + 1", 0.23),
        form_rung("difference_of_squares", "(1 - cos)(1 + cos) for the sine", 0.23),
        form_rung("lagrange", "|n x h| for the sine", 2e-5),
    };
    ladder.rungs[2].is_default = true;
    ladder.rungs[2].no_worse_than = "difference_of_squares";
    return ladder;
}

Ladder fresnel_power()
{
    Ladder ladder{.name = "fresnel_power",
                  .title = "The Fresnel edge: a fifth power",
                  .stage = "lighting",
                  .about = "Schlick's (1 - cos)^5 for cosines from 0 to 1, many of them close to 1, and some that rounding left 1.2e-7 above it, "
                           "where a bare pow is undefined.",
                  .passes = {"pbr", "pbr_surface"},
                  .measures = {{"pbr", "fresnel_power"}, {"pbr_surface", "fresnel_power"}, {"split_sum", "fresnel_power"}},
                  .metric = {"relative error of a channel, largest", "", Distance::relative, Summary::largest, 0.0, true, 1e-20},
                  .make_inputs = cosines,
                  .find_truth = edge_weights,
                  .describe_input = [](const Inputs& in, int x, int y) { return "cosines " + vector_text(texel(in.pictures.at("cosines"), x, y)); },
                  .shown = Shown::logarithmic,
                  .crop_center = {0.6, 0.5}};
    // The subtraction is exact above 1/2 and rounds once below, five times magnified; three products follow: 8 roundings.
    // pow is exp2(5 log2(x)): 5 log2(1e-6) = 100 carries log2's and its own rounding, 2^-24 each, into the exponent, times
    // ln 2 * 100: about 140 roundings and 3 ulp of exp2.
    ladder.rungs = {
        power_rung("pow", "pow(1 - cos, 5)", 150.0 / 16777216.0),
        power_rung("multiplications", "x^2 x^2 x", 8.0 / 16777216.0),
    };
    ladder.rungs[1].is_default = true;
    ladder.rungs[1].no_worse_than = "pow";
    return ladder;
}

Ladder beckmann_masking()
{
    Ladder ladder{.name = "beckmann_masking",
                  .title = "What Beckmann's facets hide",
                  .stage = "lighting",
                  .about = "Smith's G1 for Beckmann facets, for cosines from 1e-3 to 1 and roughnesses from 0.05 to 1. The exact form needs an error function; Walter's rational one does not.",
                  .passes = {"pbr", "pbr_surface", "split_sum"},
                  .measures = {{"pbr", "beckmann_masking"}, {"pbr_surface", "beckmann_masking"}, {"split_sum", "beckmann_masking"}},
                  .metric = {"difference of the share of facets seen, largest", "", Distance::absolute, Summary::largest},
                  .make_inputs = cosines_and_roughnesses,
                  .find_truth = facets_seen,
                  .describe_input =
                      [](const Inputs& in, int x, int y) {
                          const Picture& angles = in.pictures.at("angles");
                          return fmt::format("cosine {:.4g}, roughness {:.3g}", angles.at(x, y, 0), angles.at(x, y, 1));
                      },
                  .shown = Shown::logarithmic,
                  .crop_center = {0.6, 0.6}};
    // The rational form is within 0.32 % of G1 (Walter et al. 2007). The error function's own is 1.5e-7, of which G1, in
    // [0, 1], keeps at most half; 20 roundings of binary32 and exp's 9 ulp are 1.8e-6.
    ladder.rungs = {masking_rung("rational", "a quotient of polynomials", 0.0032), masking_rung("erf", "an error function by Abramowitz and Stegun", 2e-6)};
    ladder.rungs[1].is_default = true;
    ladder.rungs[1].no_worse_than = "rational";
    return ladder;
}

} // namespace passgraph::accuracy
