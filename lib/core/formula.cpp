// A reader of GLSL's expressions over numbers, and their values.
#include "passgraph/core/formula.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace passgraph {

/// Recursive descent, one function per level of precedence. The first mistake ends it: `failure_` then is set, and every
/// level returns at once.
class FormulaParser {
public:
    FormulaParser(std::string_view text, const Location& where) : text_(text), where_(where) {}

    Result<Formula> run()
    {
        formula_.root_ = condition();
        skip_space();
        if (!failure_ && at_ < text_.size())
            report(fmt::format("`{}` does not continue an expression", text_.substr(at_, 1)));
        if (failure_)
            return fail(*failure_);
        formula_.text_ = std::string(text_);
        return std::move(formula_);
    }

private:
    using Op = Formula::Op;
    static constexpr int kDeepest = 64;
    static constexpr size_t kLongest = 1000; // a sum of many is as deep as it is long

    struct Operator {
        std::string_view sign;
        Op op;
    };

    void report(const std::string& message)
    {
        if (failure_)
            return;
        Location place = where_;
        place.column += place.column > 0 ? 1 + static_cast<int>(at_) : 0; // behind the quote
        failure_ = Error{"formula_syntax", message,
                         "write it as in GLSL, of numbers, names, + - * /, comparisons, && || ! and ? :, min, max, abs", place};
    }

    void skip_space()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
            ++at_;
    }

    bool take(std::string_view sign)
    {
        skip_space();
        if (failure_ || !text_.substr(at_).starts_with(sign))
            return false;
        at_ += sign.size();
        return true;
    }

    void expect(std::string_view sign)
    {
        if (!take(sign))
            report(fmt::format("`{}` is missing", sign));
    }

    int add(Formula::Node node)
    {
        if (formula_.nodes_.size() >= kLongest)
            report("the expression is too long");
        formula_.nodes_.push_back(std::move(node));
        return static_cast<int>(formula_.nodes_.size()) - 1;
    }

    int condition()
    {
        if (++depth_ > kDeepest)
            report("the expression is nested too deeply");
        int test = failure_ ? 0 : binary(0);
        if (take("?")) {
            const int yes = condition();
            expect(":");
            const int no = condition();
            test = add({.op = Op::choose, .operands = {test, yes, no}});
        }
        --depth_;
        return test;
    }

    /// Left-associative operators, the loosest level first; of two that begin alike, the longer first.
    int binary(size_t level)
    {
        static const std::vector<std::vector<Operator>> kLevels = {
            {{"||", Op::either}},
            {{"&&", Op::both}},
            {{"==", Op::equal}, {"!=", Op::unequal}},
            {{"<=", Op::at_most}, {">=", Op::at_least}, {"<", Op::less}, {">", Op::greater}},
            {{"+", Op::add}, {"-", Op::subtract}},
            {{"*", Op::multiply}, {"/", Op::divide}},
        };
        if (level == kLevels.size())
            return unary();
        int left = binary(level + 1);
        for (bool goes_on = true; goes_on && !failure_;) {
            goes_on = false;
            for (const Operator& candidate : kLevels[level])
                if (take(candidate.sign)) {
                    left = add({.op = candidate.op, .operands = {left, binary(level + 1)}});
                    goes_on = true;
                    break;
                }
        }
        return left;
    }

    int unary()
    {
        if (++depth_ > kDeepest)
            report("the expression is nested too deeply");
        int result = 0;
        if (!failure_ && take("-"))
            result = add({.op = Op::negate, .operands = {unary()}});
        else if (!failure_ && take("!"))
            result = add({.op = Op::invert, .operands = {unary()}});
        else if (!failure_)
            result = primary();
        --depth_;
        return result;
    }

    int primary()
    {
        if (take("(")) {
            const int inner = condition();
            expect(")");
            return component(inner);
        }
        skip_space();
        if (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) || text_[at_] == '.'))
            return number();
        const size_t start = at_;
        while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
            ++at_;
        const std::string_view word = text_.substr(start, at_ - start);
        if (word.empty()) {
            report(at_ < text_.size() ? fmt::format("`{}` does not begin a number or a name", text_.substr(at_, 1))
                                      : "the expression ends too early");
            return 0;
        }
        if (word == "true" || word == "false")
            return add({.number = word == "true" ? 1.0 : 0.0});
        if (take("("))
            return call(word, start);
        Location place = where_;
        place.column += place.column > 0 ? 1 + static_cast<int>(start) : 0;
        formula_.names_.push_back({std::string(word), place});
        return component(add({.op = Op::name, .index = static_cast<int>(formula_.names_.size()) - 1}));
    }

    int number()
    {
        double value = 0.0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc()) {
            report("this is no number that fits");
            return 0;
        }
        at_ = static_cast<size_t>(end - text_.data());
        if (at_ < text_.size() && (text_[at_] == 'f' || text_[at_] == 'F'))
            ++at_;
        return add({.number = value});
    }

    int call(std::string_view name, size_t start)
    {
        std::vector<int> operands = {condition()};
        while (take(","))
            operands.push_back(condition());
        expect(")");
        const auto takes = [&](std::string_view wanted, size_t count) { return name == wanted && operands.size() == count; };
        if (takes("min", 2) || takes("max", 2))
            return add({.op = name == "min" ? Op::smaller : Op::larger, .operands = std::move(operands)});
        if (takes("abs", 1))
            return add({.op = Op::size_of, .operands = std::move(operands)});
        for (size_t size = 2; size <= 4; ++size)
            if (name == fmt::format("vec{}", size) && (operands.size() == size || operands.size() == 1))
                return component(add({.op = Op::vector, .index = static_cast<int>(size), .operands = std::move(operands)}));
        at_ = start;
        report(fmt::format("`{}` of {} is no function that a formula may call", name, operands.size()));
        return 0;
    }

    int component(int of)
    {
        if (failure_ || at_ >= text_.size() || text_[at_] != '.')
            return of;
        const size_t which = at_ + 1 < text_.size() ? std::string_view("xyzwrgba").find(text_[at_ + 1]) : std::string_view::npos;
        const bool goes_on = at_ + 2 < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_ + 2]));
        if (which == std::string_view::npos || goes_on) {
            report("one component is meant by .x .y .z .w or .r .g .b .a");
            return of;
        }
        at_ += 2;
        return add({.op = Op::component, .index = static_cast<int>(which % 4), .operands = {of}});
    }

    std::string_view text_;
    Location where_;
    size_t at_ = 0;
    int depth_ = 0;
    Formula formula_;
    std::optional<Error> failure_;
};

Result<Formula> Formula::parse(std::string_view text, const Location& where) { return FormulaParser(text, where).run(); }

bool Formula::uses(std::string_view name) const
{
    return std::any_of(names_.begin(), names_.end(), [&](const Name& used) { return used.text == name; });
}

double Formula::value(const Lookup& lookup) const { return value_of(root_, lookup).v[0]; }

Formula::Number Formula::value_of(int index, const Lookup& lookup) const
{
    const Node& node = nodes_[static_cast<size_t>(index)];
    const auto operand = [&](size_t i) { return value_of(node.operands[i], lookup); };
    const auto single = [](double x) { return Number{{x, x, x, x}, 1}; };
    const auto each = [&](const auto& combine) {
        const Number a = operand(0);
        const Number b = node.operands.size() > 1 ? operand(1) : a;
        Number result{{}, std::max(a.size, b.size)};
        for (size_t i = 0; i < 4; ++i)
            result.v[i] = combine(a.v[i], b.v[i]);
        return result;
    };
    const auto all = [&](const auto& holds) {
        const Number a = operand(0);
        const Number b = operand(1);
        bool result = true;
        for (size_t i = 0; i < static_cast<size_t>(std::max(a.size, b.size)); ++i)
            result = result && holds(a.v[i], b.v[i]);
        return single(result ? 1.0 : 0.0);
    };
    switch (node.op) {
    case Op::number:
        return single(node.number);
    case Op::name: {
        Number found = lookup(names_[static_cast<size_t>(node.index)].text).value_or(single(0.0));
        if (found.size == 1) // meets several by meeting each
            found = single(found.v[0]);
        return found;
    }
    case Op::component: {
        const Number whole = operand(0);
        return single(node.index < whole.size ? whole.v[static_cast<size_t>(node.index)] : 0.0);
    }
    case Op::vector: {
        Number result{operand(0).v, node.index};
        for (size_t i = 1; i < node.operands.size(); ++i)
            result.v[i] = operand(i).v[0];
        return result;
    }
    case Op::choose:
        return operand(operand(0).v[0] != 0.0 ? 1 : 2);
    case Op::either:
        return single(operand(0).v[0] != 0.0 || operand(1).v[0] != 0.0 ? 1.0 : 0.0);
    case Op::both:
        return single(operand(0).v[0] != 0.0 && operand(1).v[0] != 0.0 ? 1.0 : 0.0);
    case Op::equal:
        return all([](double a, double b) { return a == b; });
    case Op::unequal:
        return single(all([](double a, double b) { return a == b; }).v[0] != 0.0 ? 0.0 : 1.0);
    case Op::less:
        return all([](double a, double b) { return a < b; });
    case Op::at_most:
        return all([](double a, double b) { return a <= b; });
    case Op::greater:
        return all([](double a, double b) { return a > b; });
    case Op::at_least:
        return all([](double a, double b) { return a >= b; });
    case Op::add:
        return each([](double a, double b) { return a + b; });
    case Op::subtract:
        return each([](double a, double b) { return a - b; });
    case Op::multiply:
        return each([](double a, double b) { return a * b; });
    case Op::divide:
        return each([](double a, double b) { return a / b; });
    case Op::negate:
        return each([](double a, double) { return -a; });
    case Op::invert:
        return single(operand(0).v[0] != 0.0 ? 0.0 : 1.0);
    case Op::smaller:
        return each([](double a, double b) { return std::isnan(b) || b < a ? b : a; }); // NaN of either stays
    case Op::larger:
        return each([](double a, double b) { return std::isnan(b) || b > a ? b : a; });
    case Op::size_of:
        return each([](double a, double) { return std::abs(a); });
    }
    return {};
}

} // namespace passgraph
