// Arithmetic on what is known of a place.
#include "shader/abstract_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace passgraph::shader {
namespace {

using Kind = Component::Kind;

/// The input both offsets are measured in; -2 when they differ. An offset of 0 is measured in any.
int common_input(const Component& a, const Component& b)
{
    if (a.input == b.input || b.input < 0)
        return a.input;
    return a.input < 0 ? b.input : -2;
}

bool is_zero(const Component& c) { return c.kind == Kind::number && c.lowest == 0.0 && c.highest == 0.0; }

double largest(const Component& number) { return std::max(std::abs(number.lowest), std::abs(number.highest)); }

/// A picture may be far wider than high: a texel along one axis says nothing along the other.
bool have_one_axis(const Component& a, const Component& b) { return a.axis == b.axis; }

Component offset(Kind kind, const Component& a, const Component& b, double radius, int axis)
{
    const int input = common_input(a, b);
    if (input == -2 || !std::isfinite(radius))
        return Component::unknown();
    return {kind, kind == Kind::texels ? -radius : 0.0, radius, axis, input};
}

} // namespace

Component join(const Component& a, const Component& b)
{
    if (a == b)
        return a;
    if (a.kind == Kind::number && b.kind == Kind::number)
        return Component::number(std::min(a.lowest, b.lowest), std::max(a.highest, b.highest));
    if (a.kind == Kind::place && b.kind == Kind::place && a.axis == b.axis)
        return offset(Kind::place, a, b, std::max(a.highest, b.highest), a.axis);
    if (a.kind == Kind::texels && is_zero(b))
        return a;
    if (a.kind == Kind::texels && b.kind == Kind::texels && have_one_axis(a, b))
        return offset(Kind::texels, a, b, std::max(a.highest, b.highest), a.axis);
    if (b.kind == Kind::texels && is_zero(a))
        return b;
    return Component::unknown();
}

Component add(const Component& a, const Component& b)
{
    if (is_zero(a))
        return b;
    if (is_zero(b))
        return a;
    if (a.kind == Kind::number && b.kind == Kind::number)
        return Component::number(a.lowest + b.lowest, a.highest + b.highest);
    if (a.kind == Kind::texels && b.kind == Kind::texels && have_one_axis(a, b))
        return offset(Kind::texels, a, b, a.highest + b.highest, a.axis);
    if (a.kind == Kind::place && b.kind == Kind::texels && have_one_axis(a, b))
        return offset(Kind::place, a, b, a.highest + b.highest, a.axis);
    if (a.kind == Kind::texels && b.kind == Kind::place && have_one_axis(a, b))
        return add(b, a);
    return Component::unknown();
}

Component negate(const Component& a)
{
    if (a.kind == Kind::number)
        return Component::number(-a.highest, -a.lowest);
    return a.kind == Kind::texels ? a : Component::unknown();
}

Component multiply(const Component& a, const Component& b)
{
    if (a.kind == Kind::number && b.kind == Kind::number) {
        const auto [low, high] =
            std::minmax({a.lowest * b.lowest, a.lowest * b.highest, a.highest * b.lowest, a.highest * b.highest});
        return std::isnan(low) || std::isnan(high) ? Component::unknown() : Component::number(low, high);
    }
    if (a.kind == Kind::texels && b.kind == Kind::number)
        return offset(Kind::texels, a, a, a.highest * largest(b), a.axis);
    if (a.kind == Kind::number && b.kind == Kind::texels)
        return multiply(b, a);
    return Component::unknown();
}

Component divide(const Component& a, const Component& b)
{
    constexpr double smallest = std::numeric_limits<float>::min(); // what is smaller may be flushed to 0
    if (b.kind != Kind::number || (b.lowest < smallest && b.highest > -smallest))
        return Component::unknown();
    return multiply(a, Component::number(1.0 / b.highest, 1.0 / b.lowest));
}

Component clamped(const Component& a, const Component& lowest, const Component& highest)
{
    if (a.kind != Kind::number || lowest.kind != Kind::number || highest.kind != Kind::number)
        return Component::unknown();
    return Component::number(std::min(std::max(a.lowest, lowest.lowest), highest.lowest),
                             std::min(std::max(a.highest, lowest.highest), highest.highest));
}

Component as_float(const Component& a)
{
    constexpr float most = std::numeric_limits<float>::max();
    if (a.kind != Kind::number)
        return a;
    if (!(a.lowest >= -most && a.highest <= most))
        return Component::unknown();
    float lowest = static_cast<float>(a.lowest);
    float highest = static_cast<float>(a.highest);
    if (lowest > a.lowest)
        lowest = std::nextafter(lowest, -most);
    if (highest < a.highest)
        highest = std::nextafter(highest, most);
    return Component::number(lowest, highest);
}

Component as_integer(const Component& a, bool is_signed)
{
    const double least = is_signed ? -2147483648.0 : 0.0;
    const double most = is_signed ? 2147483647.0 : 4294967295.0;
    if (a.kind == Kind::number && a.lowest >= least && a.highest <= most)
        return Component::number(std::trunc(a.lowest), std::trunc(a.highest));
    return a.kind == Kind::number ? Component::unknown() : a;
}

} // namespace passgraph::shader
