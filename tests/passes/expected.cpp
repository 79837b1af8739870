// Compares the picture a pass made with what a formula in double says, texel by texel.
#include "passes/expected.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "support/catch.hpp"

namespace passgraph::test {

void require_texels(const Picture& got, const Formula& expected, const Formula& tolerance)
{
    double worst = 0.0;
    std::string account;
    for (int y = 0; y < got.extent.height; ++y) {
        for (int x = 0; x < got.extent.width; ++x) {
            for (int c = 0; c < got.channels; ++c) {
                const double value = got.at(x, y, c);
                const double wanted = expected(x, y, c);
                const double allowed = tolerance(x, y, c);
                const double difference = std::abs(value - wanted);
                if (difference <= allowed || !(std::isnan(difference) || difference - allowed > worst))
                    continue;
                worst = std::isnan(difference) ? INFINITY : difference - allowed;
                account = fmt::format("worst at ({}, {}) channel {}: got {:.9g}, expected {:.9g}, off by {:.3g}, allowed {:.3g}", x,
                                      y, c, value, wanted, difference, allowed);
            }
        }
    }
    INFO(account);
    REQUIRE(account.empty());
}

void require_texels(const Picture& got, const Formula& expected, double tolerance)
{
    require_texels(got, expected, [tolerance](int, int, int) { return tolerance; });
}

void require_same(const Picture& got, const Picture& expected)
{
    REQUIRE(got.extent == expected.extent);
    REQUIRE(got.channels == expected.channels);
    const auto differs = [](float a, float b) { return std::bit_cast<std::uint32_t>(a) != std::bit_cast<std::uint32_t>(b); };
    const auto [a, b] = std::mismatch(got.texels.begin(), got.texels.end(), expected.texels.begin(),
                                      [&](float x, float y) { return !differs(x, y); });
    if (a != got.texels.end()) {
        INFO(fmt::format("value {}: got {:.9g}, expected {:.9g}", a - got.texels.begin(), *a, *b));
        REQUIRE(a == got.texels.end());
    }
}

double clamped(const Picture& picture, int x, int y, int channel)
{
    return picture.at(std::clamp(x, 0, picture.extent.width - 1), std::clamp(y, 0, picture.extent.height - 1), channel);
}

double bilinear(const Picture& picture, double x, double y, int channel)
{
    const double left = std::floor(x - 0.5);
    const double low = std::floor(y - 0.5);
    const double s = x - 0.5 - left;
    const double t = y - 0.5 - low;
    const auto at = [&](double i, double j) { return clamped(picture, static_cast<int>(i), static_cast<int>(j), channel); };
    return (1.0 - t) * ((1.0 - s) * at(left, low) + s * at(left + 1.0, low)) +
           t * ((1.0 - s) * at(left, low + 1.0) + s * at(left + 1.0, low + 1.0));
}

namespace {

Picture rearranged(const Picture& picture, Extent extent, const std::function<std::array<int, 2>(int, int)>& source)
{
    Picture result(extent, picture.channels);
    for (int y = 0; y < extent.height; ++y) {
        for (int x = 0; x < extent.width; ++x) {
            const auto [from_x, from_y] = source(x, y);
            for (int c = 0; c < picture.channels; ++c)
                result.at(x, y, c) = picture.at(from_x, from_y, c);
        }
    }
    return result;
}

} // namespace

Picture transposed(const Picture& picture)
{
    return rearranged(picture, {picture.extent.height, picture.extent.width}, [](int x, int y) { return std::array{y, x}; });
}

Picture mirrored(const Picture& picture)
{
    const int last = picture.extent.width - 1;
    return rearranged(picture, picture.extent, [last](int x, int y) { return std::array{last - x, y}; });
}

double largest(const Picture& picture)
{
    return *std::max_element(picture.texels.begin(), picture.texels.end());
}

} // namespace passgraph::test
