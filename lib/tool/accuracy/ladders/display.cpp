// From radiance to a display: the filmic curve and the sRGB encoding.
#include <cmath>

#include <fmt/format.h>

#include "tool/accuracy/ladders/ladders.hpp"
#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::accuracy {
namespace {

constexpr double kWhite = 11.2; ///< tone_map's default

Inputs colors_up_to_white(Extent extent) { return {{{"image", radiance_field(extent, 1e-4, 16.0)}}, nullptr}; }

Truth displayed(const Inputs& inputs, Extent extent)
{
    return truth_of(extent, [&](int x, int y) {
        std::array<double, 3> color = texel(inputs.pictures.at("image"), x, y);
        for (double& channel : color)
            channel = reference::srgb_encode(reference::filmic(channel, kWhite));
        return color;
    });
}

std::vector<Figure> in_codes(const Truth& truth, const Picture& result)
{
    double worst = 0.0;
    for (size_t i = 0; i < result.texels.size(); ++i)
        worst = std::max(worst, std::abs(std::round(255.0 * result.texels[i]) - std::round(255.0 * truth.values[i])));
    return {{"8-bit codes off", worst}};
}

Rung rung(const std::string& ladder, const std::string& name, const std::string& what, double bound, const std::string& no_worse_than)
{
    return {.name = name,
            .what = what,
            .graph = R"({ "passgraph": 1, "inputs": { "image": "radiance" },
  "passes": { "shown": { "pass": "tone_map", "inputs": { "image": "image" }, "codecs": { "color": "rgba32f" } } },
  "outputs": { "result": "shown" } })",
            .settings = {{"shown.curve", ladder == "curve" ? name : "exact"}, {"shown.transfer", ladder == "transfer" ? name : "exact"}},
            .bound = bound,
            .is_default = name == (ladder == "curve" ? "exact" : "rational"),
            .no_worse_than = no_worse_than};
}

Ladder display_ladder(const std::string& name, const std::string& title, const std::string& about, const std::string& selection)
{
    return {.name = name,
            .title = title,
            .stage = "display",
            .about = about,
            .passes = {"tone_map"},
            .measures = {{"tone_map", selection}},
            .metric = {"difference of a display value from the exact one, largest (white is 1)", "", Distance::absolute, Summary::largest},
            .make_inputs = colors_up_to_white,
            .find_truth = displayed,
            .describe_input = [](const Inputs& in, int x, int y) { return "radiance " + vector_text(texel(in.pictures.at("image"), x, y)); },
            .find_figures = [](const Inputs& in, const Picture& result) { return in_codes(displayed(in, result.extent), result); },
            .shown = Shown::display,
            .crop_center = {0.62, 0.5}};
}

// The filmic curve takes about 24 roundings, which the encoding damps or multiplies by less than 1; pow adds 8.6 on
// llvmpipe and the rest of the encoding 3.
constexpr double kRoundings = 46.0 / 16777216.0;

} // namespace

Ladder tone_curve()
{
    Ladder ladder = display_ladder("tone_curve", "The filmic curve",
                                   "Radiance from 2e-5 to 16 of all hues, through Hable's curve (white at 11.2) and the exact sRGB encoding. The table holds 33 samples joined by straight lines.", "curve");
    // Straight lines between samples are off by at most f'' h^2 / 8; over this curve after encoding 2.34e-3 (computed at 200 000
    // places in double), and 2 % for places between those.
    ladder.rungs = {rung("curve", "table", "33 samples joined by straight lines", 2.4e-3, ""), rung("curve", "exact", "the quotient of two quadratics", kRoundings, "table")};
    return ladder;
}

Ladder srgb_transfer()
{
    Ladder ladder = display_ladder("srgb_transfer", "Encoding for the display: sRGB",
                                   "Radiance from 2e-5 to 16 of all hues, through the exact filmic curve and the encoding. The common x^(1/2.2) is far too bright near black.", "transfer");
    // x^(1/2.2) against the standard: 0.0335 at 0.00216 (computed); the quotient of quadratics 1.305e-4 by its fit.
    ladder.rungs = {rung("transfer", "gamma_2_2", "x^(1/2.2)", 0.0336, ""),
                    rung("transfer", "rational", "a quotient of quadratics in sqrt(x)", 1.31e-4 + kRoundings, "gamma_2_2"),
                    rung("transfer", "exact", "the two pieces of IEC 61966-2-1", kRoundings, "rational")};
    return ladder;
}

} // namespace passgraph::accuracy
