// Blur along one direction: its kernel, its sum, its edges, its mirror image.
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "passes/expected.hpp"
#include "support/catch.hpp"
#include "support/pass_runner.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

const std::map<std::string, int> kReach = {{"5", 2}, {"9", 4}, {"13", 6}, {"25", 12}, {"learnopengl5", 4}};

/// Weights at offsets 0 to reach; twice all but the first and the first sum to 1.
std::vector<double> weights_of(const std::string& taps, double sigma)
{
    std::vector<double> weights = {0.227027, 0.1945946, 0.1216216, 0.054054, 0.016216};
    if (taps != "learnopengl5") {
        weights.clear();
        for (int i = 0; i <= kReach.at(taps); ++i)
            weights.push_back(i == 0 ? 1.0 : std::exp(-0.5 * i * i / (sigma * sigma)));
    }
    const double total = 2.0 * std::accumulate(weights.begin(), weights.end(), 0.0) - weights[0];
    for (double& weight : weights)
        weight /= total;
    return weights;
}

Picture blurred(const Picture& image, const std::string& direction, const std::string& taps, const std::string& sigma)
{
    return run_for_output({.pass = "blur_direction", .inputs = {{"image", image}}, .settings = {{"direction", direction}, {"taps", taps}, {"sigma", sigma}}});
}

/// Each of the weights may be 9 ulp off (llvmpipe's exp; none where the compiler folds it), so may their sum; the sum of
/// n terms adds n roundings, the quotient one.
double tolerance(const std::string& taps, double brightest)
{
    return (2.0 * 18.0 + 2.0 * kReach.at(taps) + 4.0) * kRounding * brightest;
}

} // namespace

TEST_CASE("blur is the sum of its taps, the edge texel standing for those outside", "[passes][blur]")
{
    unsigned seed = 10;
    for (const auto& [taps, reach] : kReach) {
        for (const Extent extent : kExtents) {
            const Picture image = noise(extent, 3, 0.0f, 4.0f, seed++);
            for (const char* sigma : {"0.8", "2"}) {
                CAPTURE(taps, extent.width, extent.height, sigma);
                const std::vector<double> weights = weights_of(taps, std::stod(sigma));
                for (const bool is_row : {true, false}) {
                    const auto expected = [&](int x, int y, int c) {
                        double sum = weights[0] * image.at(x, y, c);
                        for (int i = 1; i < static_cast<int>(weights.size()); ++i) {
                            const int dx = is_row ? i : 0;
                            const int dy = is_row ? 0 : i;
                            sum += weights[static_cast<size_t>(i)] * (clamped(image, x - dx, y - dy, c) + clamped(image, x + dx, y + dy, c));
                        }
                        return sum;
                    };
                    require_texels(blurred(image, is_row ? "horizontal" : "vertical", taps, sigma), expected, tolerance(taps, 4.0));
                }
            }
        }
    }
}

TEST_CASE("a constant picture is not changed, where the original counts the center twice", "[passes][blur][defect 5]")
{
    const Picture grey = constant({17, 13}, {0.7f, 1.5f, 3.0f});
    for (const auto& [taps, reach] : kReach) {
        const Picture got = blurred(grey, "vertical", taps, "2");
        require_texels(got, [&](int x, int y, int c) { return grey.at(x, y, c); }, tolerance(taps, 3.0));
    }
}

TEST_CASE("one bright texel becomes the kernel itself, one texel per tap", "[passes][blur][defect 5]")
{
    for (const auto& [taps, reach] : kReach) {
        Picture image({31, 3}, 3);
        image.at(15, 1, 0) = 1.0f;
        const Picture got = blurred(image, "horizontal", taps, "2");
        const std::vector<double> weights = weights_of(taps, 2.0);
        const auto expected = [&](int x, int y, int c) {
            const size_t distance = static_cast<size_t>(std::abs(x - 15));
            return y == 1 && c == 0 && distance < weights.size() ? weights[distance] : 0.0;
        };
        require_texels(got, expected, tolerance(taps, 1.0));
    }
}

TEST_CASE("blur of sigma 0 is its input, on every rung", "[passes][blur][identity]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 3);
    for (const auto& [taps, reach] : kReach)
        require_same(blurred(image, "horizontal", taps, "0"), image);
}

TEST_CASE("a sigma too small for its neighbours divides nothing by 0", "[passes][blur]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 4);
    for (const char* sigma : {"1e-20", "0.0001", "0.05"})
        require_same(blurred(image, "vertical", "13", sigma), image);
}

TEST_CASE("blur of a mirror image is the mirror image of the blur", "[passes][blur]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 5);
    for (const auto& [taps, reach] : kReach)
        require_same(blurred(mirrored(image), "horizontal", taps, "2"), mirrored(blurred(image, "horizontal", taps, "2")));
}

TEST_CASE("blur along columns is blur along rows of the transposed picture", "[passes][blur]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 4.0f, 6);
    require_same(transposed(blurred(image, "vertical", "13", "1.7")), blurred(transposed(image), "horizontal", "13", "1.7"));
}

TEST_CASE("more taps come closer to the whole Gaussian", "[passes][blur]")
{
    Picture image({63, 1}, 3);
    image.at(31, 0, 0) = 1.0f;
    double last = 1.0;
    for (const char* taps : {"5", "9", "13", "25"}) {
        const Picture got = blurred(image, "horizontal", taps, "2");
        double worst = 0.0;
        for (int x = 0; x < 63; ++x) {
            // The sum over all integers of exp(-x^2 / 8) is sqrt(8 pi) within 1e-33.
            const double gaussian = std::exp(-(x - 31.0) * (x - 31.0) / 8.0) / std::sqrt(8.0 * 3.14159265358979324);
            worst = std::max(worst, std::abs(got.at(x, 0, 0) - gaussian));
        }
        CAPTURE(taps, worst);
        CHECK(worst < 0.5 * last);
        last = worst;
    }
}

TEST_CASE("the widest blur keeps what it is given", "[passes][blur]")
{
    const Picture image = noise({17, 13}, 3, 0.0f, 65504.0f, 8);
    const Picture got = blurred(image, "horizontal", "25", "20");
    CHECK(largest(got) <= largest(image) * (1.0 + 64.0 * kRounding));
    require_texels(got, [](int, int, int) { return 32752.0; }, 32752.0);
}
