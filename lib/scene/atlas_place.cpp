// From texture coordinates to places in the atlas, as shaders do it.
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

#include "passgraph/scene/atlas.hpp"

namespace passgraph {
namespace {

constexpr float kLastBelowOne = 0.99999994f;

} // namespace

// Comparisons that NaN fails, in place of min and max, which GLSL leaves undefined for it.
float atlas_wrap(float x, Wrap mode)
{
    if (mode == Wrap::clamp)
        return x > 0.0f ? std::fmin(x, 1.0f) : 0.0f;
    if (mode == Wrap::mirror) {
        const float turn = x - 2.0f * std::floor(0.5f * x); // 2 itself where x is a little below a multiple of 2
        return turn > 1.0f ? 2.0f - turn : turn > 0.0f ? turn : 0.0f;
    }
    const float fraction = x - std::floor(x); // 1 itself where x is a little below a whole number
    return fraction > 0.0f ? std::fmin(fraction, kLastBelowOne) : 0.0f;
}

int atlas_level(glm::vec2 dx_texels, glm::vec2 dy_texels, int last)
{
    assert(last >= 0);
    const float along_x = glm::dot(dx_texels, dx_texels);
    const float along_y = glm::dot(dy_texels, dy_texels);
    float squared = along_x > 1.0f ? along_x : 1.0f;
    squared = along_y > squared ? along_y : squared;
    // Level k is for lengths from 2^(k - 1/2) to 2^(k + 1/2), so for squares whose exponent is 2k - 1 or 2k.
    const int exponent_and_one = (std::bit_cast<std::int32_t>(squared) >> 23) - 126;
    return std::min(exponent_and_one >> 1, last);
}

glm::vec2 atlas_place(const AtlasRect& rect, glm::vec2 inside)
{
    return glm::vec2(rect.x, rect.y) + inside * glm::vec2(rect.width, rect.height);
}

} // namespace passgraph
