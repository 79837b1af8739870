// What it costs to keep every stored value inside its signal's domain, and what one bad pixel does without.
#include <cmath>

#include <fmt/format.h>

#include "tool/accuracy/ladders/ladders.hpp"
#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::accuracy {
namespace {

constexpr double kSigma = 2.0;
constexpr int kApart = 41; // texels between bad ones: a blur of 25 taps reaches 12 to each side

/// Radiance, and in places a mark for what the probe spoils: -1 no number, -2 infinity, -3 less than nothing.
Inputs radiance_with_marks(Extent extent)
{
    const Picture plain = radiance_field(extent, 0.01, 100.0);
    return {{{"value", picture_of(extent, [&](int x, int y) {
                  const bool is_marked = x % kApart == kApart / 2 && y % kApart == kApart / 2;
                  const double mark = -1.0 - (x / kApart + y / kApart) % 3;
                  return is_marked ? std::array<double, 3>{mark, mark, mark} : texel(plain, x, y);
              })}},
            nullptr};
}

/// Bad values replaced as the signal says (no number and negative by 0, infinity by the largest half), then blurred.
Truth cleaned_and_blurred(const Inputs& inputs, Extent extent)
{
    const Picture& value = inputs.pictures.at("value");
    std::vector<double> clean(value.texels.begin(), value.texels.end());
    for (double& number : clean)
        number = number == -2.0 ? 65504.0 : std::max(number, 0.0);
    return {extent, 3, reference::gaussian_blur(clean, extent.width, extent.height, 3, kSigma)};
}

Rung rung(const std::string& name, const std::string& what, bool has_guards, double bound)
{
    return {.name = name,
            .what = what,
            .graph = R"({ "passgraph": 1, "inputs": { "value": "position" },
  "passes": {
    "spoilt": { "pass": "spoil", "inputs": { "value": "value" } },
    "across": { "pass": "blur_direction", "inputs": { "image": "spoilt" }, "rungs": { "taps": "25" } },
    "along": { "pass": "blur_direction", "inputs": { "image": "across" }, "choices": { "direction": "vertical" }, "rungs": { "taps": "25" } },
    "seen": { "pass": "keep_radiance", "inputs": { "value": "along" }, "codecs": { "kept": "rgba32f" } } },
  "outputs": { "result": "seen" } })",
            .bound = bound,
            .is_default = has_guards,
            .no_worse_than = has_guards ? "off" : "",
            .has_guards = has_guards};
}

} // namespace

Ladder guards()
{
    Ladder ladder{.name = "guards",
                  .title = "Guards on every store",
                  .stage = "every pass",
                  .about = "One texel in 1681 is no number, infinite or negative; the picture is stored, blurred along rows and columns and read. "
                           "A texel counts as wrong when it is not within 1 % of the blur of the picture with the bad texels replaced.",
                  .passes = {},
                  .metric = {"share of the texels that are wrong", "", Distance::is_wrong, Summary::mean, 0.01},
                  .make_inputs = radiance_with_marks,
                  .find_truth = cleaned_and_blurred,
                  .describe_input = [](const Inputs&, int x, int y) { return fmt::format("texel ({}, {})", x, y); },
                  .shown = Shown::radiance,
                  .crop_center = {0.4, 0.4}};
    // Three truncating stores of binary16 lose 3 * 2^-10 = 0.3 %, the 25 taps 1e-8: nothing is off by 1 %. Without guards every
    // texel in reach of a bad one may be wrong: at most all of them.
    ladder.rungs = {rung("off", "values are stored as a pass returns them", false, 1.0), rung("on", "an ordered select before every store", true, 0.0)};
    return ladder;
}

} // namespace passgraph::accuracy
