// Compares the picture a pass made with what a formula in double says, texel by texel.
#pragma once

#include <array>
#include <functional>

#include <passgraph/core/picture.hpp>

namespace passgraph::test {

/// Half the distance from 1 to the next binary32: the largest relative error of one rounding.
inline constexpr double kRounding = 1.0 / 16777216.0;

/// Sizes with an edge on every side of every texel, in one direction, and odd.
inline constexpr std::array<Extent, 4> kExtents = {{{1, 1}, {1, 9}, {9, 1}, {17, 13}}};

using Formula = std::function<double(int x, int y, int channel)>;

/// Fails with the worst texel unless every channel is within `tolerance` of `expected`; a NaN is never within.
void require_texels(const Picture& got, const Formula& expected, const Formula& tolerance);
void require_texels(const Picture& got, const Formula& expected, double tolerance);

/// Fails with the first difference unless the pictures are equal bit by bit.
void require_same(const Picture& got, const Picture& expected);

/// The texel at a place, or the nearest one at the edge.
double clamped(const Picture& picture, int x, int y, int channel);

/// What a linear filter gives at a place in texels, 0.5 being the first texel's center.
double bilinear(const Picture& picture, double x, double y, int channel);

/// The picture with rows and columns exchanged, or seen in a mirror that stands on its right.
Picture transposed(const Picture& picture);
Picture mirrored(const Picture& picture);

double largest(const Picture& picture);

} // namespace passgraph::test
