// The small expressions of headers: conditions and bounds that follow from parameters, selections and facts.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <passgraph/core/error.hpp>

namespace passgraph {

/// In a pass header a formula knows the pass's parameters, choices and items (`taps_9`); the largest component of each input, by
/// its name, so that `bloom == 0` is "bloom is black"; IMAGE_behind, that of the input `IMAGE` where no surface is; and the
/// scene's facts.
///
/// An expression in GLSL's notation: `? : || && == != < <= > >= + - * / !`, parentheses, numbers, names, one component of
/// a name (`tint.g`), `vec3(1, 0, 0)`, `min max abs`.
///
/// Units    a number has one to four components; one component meets several by meeting each. A comparison holds when
///          it holds in every component and is 1, else 0; `!=` is the opposite of `==`.
/// Range    doubles: a condition is decided on the values that a float parameter has, without rounding of its own. What has no
///          value (infinity less infinity) is NaN, and stays it in min and max.
///          At most 1000 operators, numbers and names, 64 levels deep; a parenthesis is two.
class Formula {
public:
    struct Number {
        std::array<double, 4> v{};
        int size = 1;
    };
    /// What a name stands for; nothing when it is unknown.
    using Lookup = std::function<std::optional<Number>(std::string_view)>;
    struct Name {
        std::string text;
        Location where;
    };

    /// `where` is the place of the string's first quote.
    /// Errors   formula_syntax (one, at its place).
    static Result<Formula> parse(std::string_view text, const Location& where);

    /// As it was written.
    const std::string& text() const { return text_; }
    /// Every name that the formula uses, in its order, each use once.
    const std::vector<Name>& names() const { return names_; }
    bool uses(std::string_view name) const;

    /// The first component of the value. A name that `lookup` does not know is 0; a component that is not there, too.
    /// Cost     linear in the text; below a microsecond.
    double value(const Lookup& lookup) const;

private:
    friend class FormulaParser;
    enum class Op : std::uint8_t {
        number, name, component, vector, choose, either, both, equal, unequal, less, at_most, greater, at_least,
        add, subtract, multiply, divide, negate, invert, smaller, larger, size_of
    };
    struct Node {
        Op op = Op::number;
        double number = 0.0;
        int index = 0; ///< of the name, or the component
        std::vector<int> operands{};
    };
    Number value_of(int node, const Lookup& lookup) const;

    std::string text_;
    std::vector<Node> nodes_;
    std::vector<Name> names_;
    int root_ = 0;
};

} // namespace passgraph
