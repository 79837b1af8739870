// The abstract domain of the access analysis: what is known of a place, component by component.
#pragma once

#include <cstddef>
#include <vector>

namespace passgraph::shader {

/// What is known of one number: an interval, or a uv coordinate plus a bounded number of texels, or nothing.
struct Component {
    enum class Kind {
        unknown,
        number, ///< in [lowest, highest]
        texels, ///< within `highest` texels of `input` either way, along `axis`
        place,  ///< uv[axis], off by at most `highest` texels of `input` (0: exactly)
    };
    Kind kind = Kind::unknown;
    double lowest = 0.0;
    double highest = 0.0;
    int axis = 0;
    int input = -1; ///< whose texels; -1: of any (an offset of 0)

    static Component unknown() { return {}; }
    static Component number(double lowest, double highest) { return {Kind::number, lowest, highest, 0, -1}; }
    static Component texels(double radius, int input, int axis) { return {Kind::texels, -radius, radius, axis, input}; }
    static Component uv(int axis) { return {Kind::place, 0.0, 0.0, axis, -1}; }
    friend bool operator==(const Component&, const Component&) = default;
};

/// A scalar or vector; what is no vector of numbers (matrices, structs, arrays of anything unknown) is one unknown component.
using AbstractValue = std::vector<Component>;

Component join(const Component& a, const Component& b);
Component add(const Component& a, const Component& b);
Component negate(const Component& a);
Component multiply(const Component& a, const Component& b);
Component divide(const Component& a, const Component& b);
Component clamped(const Component& a, const Component& lowest, const Component& highest);

/// What an interval becomes in binary32: its ends rounded outwards; unknown beyond the largest number.
Component as_float(const Component& a);
/// What an interval becomes in 32 bits: cut to whole numbers towards 0; unknown where it would wrap.
Component as_integer(const Component& a, bool is_signed);

/// Applies a rising function to both ends of an interval.
template <class Function>
Component map_ends(const Component& a, const Function& function)
{
    return a.kind == Component::Kind::number ? Component::number(function(a.lowest), function(a.highest))
                                             : Component::unknown();
}

/// Applies an operation component by component; a scalar meets every component of the other.
template <class Operation>
AbstractValue zip(const AbstractValue& a, const AbstractValue& b, const Operation& operation)
{
    AbstractValue result;
    const std::size_t count = a.size() > b.size() ? a.size() : b.size();
    for (std::size_t i = 0; i < count; ++i) {
        const bool fits = (a.size() == 1 || i < a.size()) && (b.size() == 1 || i < b.size());
        result.push_back(fits ? operation(a[a.size() == 1 ? 0 : i], b[b.size() == 1 ? 0 : i]) : Component::unknown());
    }
    return result;
}

} // namespace passgraph::shader
