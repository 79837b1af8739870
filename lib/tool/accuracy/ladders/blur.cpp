// A Gaussian of a stated width: how many taps, how they read, and at which resolution.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tool/accuracy/ladders/ladders.hpp"
#include "tool/accuracy/reference/reference.hpp"

namespace passgraph::accuracy {
namespace {

constexpr double kSigma = 3.0; ///< texels of the full picture
// Single bright texels stand this far apart, each at another place within a quarter-size texel.
constexpr int kApart = 72;

bool is_bright_texel(int x, int y)
{
    const int column = x / kApart;
    const int row = y / kApart;
    return x == column * kApart + kApart / 2 + column % 4 && y == row * kApart + kApart / 2 + row % 4;
}

/// Red: single texels so bright that a Gaussian of the stated width peaks at 1. Green: hard edges, bars of 2 to 40 texels.
/// Blue: a slow wave with a grain of whole texels.
Inputs bright_texels_and_edges(Extent extent)
{
    return {{{"image", picture_of(extent, [](int x, int y) {
                  const double peak = is_bright_texel(x, y) ? 2.0 * std::numbers::pi * kSigma * kSigma : 0.0;
                  const int bar = 2 << (y / 24 % 5);
                  const double edge = (x / bar + y / 48) % 2;
                  const double grain = (x * 7919 + y * 104729) % 97 / 97.0;
                  return std::array<double, 3>{peak, edge, 0.4 + 0.3 * std::sin(0.03 * x) * std::cos(0.05 * y) + 0.3 * grain};
              })}},
            nullptr};
}

Truth gaussian_of(const Inputs& inputs, Extent extent)
{
    const Picture& image = inputs.pictures.at("image");
    const std::vector<double> exact(image.texels.begin(), image.texels.end());
    return {extent, 3, reference::gaussian_blur(exact, extent.width, extent.height, 3, kSigma)};
}

/// What single bright texels became: their energy, and the root of the mean squared distance from where they were, along an
/// axis, both over all of them. A smaller picture puts each at another place within its larger texels; that counts as spread.
std::vector<Figure> spread_of_bright_texels(const Inputs& inputs, const Picture& result)
{
    double sent = 0.0;
    double arrived = 0.0;
    double spread = 0.0;
    const Extent extent = result.extent;
    for (int row = 0; (row + 1) * kApart <= extent.height; ++row) {
        for (int column = 0; (column + 1) * kApart <= extent.width; ++column) {
            const double from_x = column * kApart + kApart / 2 + column % 4;
            const double from_y = row * kApart + kApart / 2 + row % 4;
            for (int y = row * kApart; y < (row + 1) * kApart; ++y)
                for (int x = column * kApart; x < (column + 1) * kApart; ++x) {
                    const double value = result.at(x, y, 0);
                    sent += inputs.pictures.at("image").at(x, y, 0);
                    arrived += value;
                    spread += 0.5 * value * ((x - from_x) * (x - from_x) + (y - from_y) * (y - from_y));
                }
        }
    }
    if (!(arrived > 0.0))
        return {};
    return {{"realised sigma", std::sqrt(spread / arrived)}, {"energy ratio", arrived / sent}};
}

std::string full_graph()
{
    return R"({ "passgraph": 1, "inputs": { "image": "radiance" },
  "passes": {
    "across": { "pass": "blur_direction", "inputs": { "image": "image" }, "codecs": { "blurred": "rgba32f" } },
    "along": { "pass": "blur_direction", "inputs": { "image": "across" }, "choices": { "direction": "vertical" }, "codecs": { "blurred": "rgba32f" } } },
  "params": { "sigma": ["across.sigma", "along.sigma"], "taps": ["across.taps", "along.taps"], "sampling": ["across.sampling", "along.sampling"] },
  "outputs": { "result": "along" } })";
}

/// Halved once or twice, blurred there, and read back with a linear filter.
std::string reduced_graph(bool is_quarter)
{
    const std::string small = is_quarter ? "quarter" : "half";
    const std::string quarter = R"(
    "quarter": { "pass": "downsample", "inputs": { "image": "half" }, "codecs": { "color": "rgba32f" } },)";
    return fmt::format(R"({{ "passgraph": 1, "inputs": {{ "image": "radiance" }},
  "passes": {{
    "half": {{ "pass": "downsample", "inputs": {{ "image": "image" }}, "codecs": {{ "color": "rgba32f" }} }},{}
    "across": {{ "pass": "blur_direction", "inputs": {{ "image": "{}" }}, "codecs": {{ "blurred": "rgba32f" }} }},
    "along": {{ "pass": "blur_direction", "inputs": {{ "image": "across" }}, "choices": {{ "direction": "vertical" }}, "codecs": {{ "blurred": "rgba32f" }} }},
    "enlarged": {{ "pass": "upsample", "inputs": {{ "image": "along" }}, "size": {{ "of": "image" }}, "codecs": {{ "color": "rgba32f" }} }} }},
  "params": {{ "sigma": ["across.sigma", "along.sigma"], "taps": ["across.taps", "along.taps"], "sampling": ["across.sampling", "along.sampling"] }},
  "outputs": {{ "result": "enlarged" }} }})",
                       is_quarter ? quarter : "", small);
}

struct Row {
    const char* name;
    const char* what;
    int divisor; ///< of the resolution
    const char* taps;
    const char* sampling;
    double bound;
    const char* no_worse_than;
};

// Halving averages two texels, a variance of 1/4 of a texel squared, or 1 at a quarter; a linear filter from half or quarter size
// adds the mean of t (1 - t) over its places: 3/16 of 4, or 11/64 of 16 texels squared. The blur does the rest, so that
// sigma^2 is 1/4 + 3/4 + 4 s^2, or 1/4 + 1 + 11/4 + 16 s^2.
double sigma_at(int divisor)
{
    const double square = kSigma * kSigma;
    return divisor == 1 ? kSigma : divisor == 2 ? std::sqrt((square - 1.0) / 4.0) : std::sqrt((square - 4.0) / 16.0);
}

Rung rung_of(const Row& row)
{
    return {.name = row.name,
            .what = row.what,
            .graph = row.divisor == 1 ? full_graph() : reduced_graph(row.divisor == 4),
            .settings = {{"sigma", fmt::format("{}", sigma_at(row.divisor))}, {"taps", row.taps}, {"sampling", row.sampling}},
            .bound = row.bound,
            .no_worse_than = row.no_worse_than};
}

} // namespace

Ladder blur()
{
    Ladder ladder{.name = "blur",
                  .title = "Blurring by a stated width",
                  .stage = "bloom",
                  .about = "A Gaussian of sigma 3 texels of a picture with single bright texels, hard edges and grain. Taps that end too early realise a smaller "
                           "sigma than asked; a smaller picture costs less and is smoother than it should be. All images are binary32, so that only the kernel differs.",
                  .passes = {"blur_direction", "gaussian_blur", "downsample", "upsample"},
                  .measures = {{"blur_direction", "taps"}, {"blur_direction", "sampling"}, {"gaussian_blur", "taps"}, {"gaussian_blur", "sampling"}},
                  .metric = {"difference from the exact Gaussian, largest (the picture's peak is 1)", "", Distance::absolute, Summary::largest},
                  .make_inputs = bright_texels_and_edges,
                  .find_truth = gaussian_of,
                  .describe_input =
                      [](const Inputs& in, int x, int y) { return fmt::format("texel ({}, {}), value {}", x, y, vector_text(texel(in.pictures.at("image"), x, y))); },
                  .find_figures = spread_of_bright_texels,
                  .shown = Shown::radiance,
                  .crop_center = {0.16, 0.32}};
    // Cut off at r texels and scaled to a sum of 1, a row's weights differ from the Gaussian's by twice the mass that is
    // outside (0.40, 0.134, 0.030, 3.1e-5 for r = 2, 4, 6, 12 at sigma 3, computed) in the sum of their sizes: on a picture in [0, 1] by so much in
    // each direction at most. A bright texel is not in [0, 1], but its peak w(0)^2 grows as 1 / (1 - mass)^2.
    const auto cut = [](double outside) { return std::max(4.0 * outside, 1.0 / ((1.0 - outside) * (1.0 - outside)) - 1.0); };
    // A linear tap's place is rounded three times at a uv of up to 1: in a picture of up to 2048 texels by 3.7e-4 of one, of
    // which a bright texel of 56.5, a pair's weight of 0.25 and the other direction's 0.133 make 7e-4.
    // A smaller picture is compared through its peak: two pictures without negative values differ by the larger peak at most.
    // A quarter's weights at sigma 0.559 begin with 0.711, spread over 4 texels, half's at 1.414 with 0.282 over 2; ours is 0.133.
    const auto peak = [](double weight, double texels) { return std::pow(weight / texels / 0.13298, 2.0); };
    const std::vector<Row> rows = {
        {"learnopengl5", "the 2017 demo's five weights, whatever the sigma", 1, "learnopengl5", "nearest_taps", peak(0.227027, 1.0), ""},
        {"nearest_5", "5 nearest taps", 1, "5", "nearest_taps", cut(0.404), ""},
        {"quarter_5", "quarter size, 5 nearest taps", 4, "5", "nearest_taps", peak(0.711, 4.0), ""},
        {"nearest_9", "9 nearest taps", 1, "9", "nearest_taps", cut(0.134), "nearest_5"},
        {"half_13", "half size, 13 nearest taps", 2, "13", "nearest_taps", peak(0.2821, 2.0), "quarter_5"},
        {"linear_13", "13 taps as 7 linear ones", 1, "13", "linear_pairs", cut(0.0303), "nearest_9"},
        {"nearest_13", "13 nearest taps", 1, "13", "nearest_taps", cut(0.0303), "nearest_9"},
        {"linear_25", "25 taps as 13 linear ones", 1, "25", "linear_pairs", cut(3.1e-5) + 7e-4, "linear_13"},
        {"nearest_25", "25 nearest taps", 1, "25", "nearest_taps", cut(3.1e-5) + 1e-5, "nearest_13"},
    };
    for (const Row& row : rows)
        ladder.rungs.push_back(rung_of(row));
    ladder.rungs[6].is_default = true; // gaussian_blur's own
    return ladder;
}

} // namespace passgraph::accuracy
