// The abstract interpreter's expressions: arithmetic on places, and the reads of inputs.
#include <algorithm>
#include <cmath>

#include "shader/interpreter.hpp"
#include "shader/tree.hpp"

namespace passgraph::shader {

using namespace glslang;

namespace {

/// The value as its type holds it: rounded, cut to whole numbers, or unknown where it wraps or overflows.
AbstractValue fitted(AbstractValue value, const TType& type)
{
    const TBasicType basic = type.getBasicType();
    for (Component& component : value)
        component = basic == EbtInt || basic == EbtUint ? as_integer(component, basic == EbtInt) : as_float(component);
    return value;
}

AbstractValue map_value(const AbstractValue& value, double (*function)(double))
{
    AbstractValue result;
    for (const Component& component : value)
        result.push_back(map_ends(component, function));
    return result;
}

} // namespace

/// Evaluates an operand whose neighbours may change what it reads: GLSL does not say which comes first.
AbstractValue Interpreter::evaluate_beside(TIntermNode* operand, const std::vector<TIntermNode*>& others)
{
    std::map<long long, AbstractValue> hidden;
    for (TIntermNode* other : others) {
        if (other == operand)
            continue;
        for (const TIntermSymbol* symbol : assigned_symbols(other))
            if (auto held = now_.values.extract(symbol->getId()))
                hidden.insert(std::move(held));
    }
    AbstractValue value = evaluate(operand);
    if (!hidden.empty())
        for (const TIntermSymbol* symbol : assigned_symbols(operand))
            if (hidden.erase(symbol->getId()) > 0)
                now_.values.erase(symbol->getId()); // both change it
    now_.values.merge(hidden);
    return value;
}

AbstractValue Interpreter::evaluate_symbol(const TIntermSymbol& symbol)
{
    if (symbol.getQualifier().storage == EvqGlobal)
        return unknown_of(symbol.getType()); // any call may change it
    const auto known = now_.values.find(symbol.getId());
    if (known != now_.values.end())
        return known->second;
    if (symbol.getConstArray().size() > 0)
        return constants_of(symbol.getConstArray(), symbol.getType());
    if (symbol.getQualifier().storage == EvqUniform)
        if (const auto param = known_symbols_.find(symbol.getName().c_str()); param != known_symbols_.end())
            return {param->second};
    return unknown_of(symbol.getType());
}

AbstractValue Interpreter::evaluate_unary(TIntermUnary& node)
{
    const AbstractValue operand = evaluate(node.getOperand());
    switch (node.getOp()) {
    case EOpNegative: {
        AbstractValue result;
        for (const Component& component : operand)
            result.push_back(negate(component));
        return fitted(std::move(result), node.getType());
    }
    case EOpConvIntToFloat:
    case EOpConvUintToFloat:
    case EOpConvIntToUint:
    case EOpConvFloatToInt:
        return fitted(operand, node.getType());
    case EOpFloor:
        return map_value(operand, [](double x) { return std::floor(x); });
    case EOpCeil:
        return map_value(operand, [](double x) { return std::ceil(x); });
    case EOpExp: {
        // GLSL allows a relative error of (3 + 2 |x|) ulp, below 1e-3 wherever the result is finite.
        AbstractValue result;
        for (const Component& component : operand)
            result.push_back(component.kind == Component::Kind::number
                                 ? Component::number(std::exp(component.lowest) * 0.999, std::exp(component.highest) * 1.001)
                                 : Component::unknown());
        return fitted(std::move(result), node.getType());
    }
    case EOpPreIncrement:
    case EOpPostIncrement:
    case EOpPreDecrement:
    case EOpPostDecrement: {
        const bool rises = node.getOp() == EOpPreIncrement || node.getOp() == EOpPostIncrement;
        const AbstractValue stepped =
            fitted(zip(operand, {Component::number(rises ? 1.0 : -1.0, rises ? 1.0 : -1.0)}, add), node.getType());
        assign(node.getOperand(), stepped);
        return node.getOp() == EOpPreIncrement || node.getOp() == EOpPreDecrement ? stepped : operand;
    }
    default:
        return unknown_of(node.getType());
    }
}

AbstractValue Interpreter::evaluate_binary(TIntermBinary& node)
{
    const AbstractValue left = evaluate_beside(node.getLeft(), {node.getRight()});
    const auto right = [&] { return evaluate_beside(node.getRight(), {node.getLeft()}); };
    switch (node.getOp()) {
    case EOpVectorSwizzle: {
        AbstractValue result;
        for (TIntermNode* item : node.getRight()->getAsAggregate()->getSequence()) {
            const size_t index = static_cast<size_t>(item->getAsConstantUnion()->getConstArray()[0].getIConst());
            result.push_back(index < left.size() ? left[index] : Component::unknown());
        }
        return result;
    }
    case EOpIndexDirect:
    case EOpIndexIndirect: {
        const AbstractValue index = right();
        const TType& type = node.getLeft()->getType();
        if (type.isArray() || type.isMatrix())
            return AbstractValue(width_of(node.getType()), left.front()); // one interval stands for every element
        if (node.getOp() == EOpIndexDirect && index.front().kind == Component::Kind::number &&
            index.front().lowest < static_cast<double>(left.size()))
            return {left[static_cast<size_t>(index.front().lowest)]};
        return {Component::unknown()};
    }
    case EOpAdd:
        return fitted(zip(left, right(), add), node.getType());
    case EOpSub:
        return fitted(zip(left, right(), [](const Component& a, const Component& b) { return add(a, negate(b)); }),
                      node.getType());
    case EOpMul:
    case EOpVectorTimesScalar:
        return fitted(zip(left, right(), multiply), node.getType());
    case EOpDiv:
        return fitted(zip(left, right(), divide), node.getType());
    case EOpLogicalAnd:
    case EOpLogicalOr: { // the right side may be skipped; here the left one does come first
        const Environment skipped = now_;
        evaluate(node.getRight());
        now_ = join_environments({skipped, now_});
        return unknown_of(node.getType());
    }
    case EOpIndexDirectStruct:
        return unknown_of(node.getType());
    default:
        right();
        return unknown_of(node.getType());
    }
}

AbstractValue Interpreter::evaluate_assignment(TIntermBinary& node)
{
    const AbstractValue left =
        evaluate_beside(node.getLeft(), {node.getRight()}); // of `a[i] = x`, too: i may read an input
    const AbstractValue right = evaluate_beside(node.getRight(), {node.getLeft()});
    AbstractValue value;
    switch (node.getOp()) {
    case EOpAssign:
        value = right;
        break;
    case EOpAddAssign:
        value = fitted(zip(left, right, add), node.getType());
        break;
    case EOpSubAssign:
        value = fitted(zip(left, right, [](const Component& a, const Component& b) { return add(a, negate(b)); }),
                       node.getType());
        break;
    case EOpMulAssign:
    case EOpVectorTimesScalarAssign:
        value = fitted(zip(left, right, multiply), node.getType());
        break;
    default:
        value = unknown_of(node.getLeft()->getType());
    }
    assign(node.getLeft(), value);
    return value;
}

void Interpreter::assign(TIntermNode* place, const AbstractValue& value, bool counts_as_written)
{
    TIntermSymbol* symbol = base_symbol(place);
    if (!symbol)
        return;
    const std::vector<size_t> components = components_of(place);
    AbstractValue& held = now_.values.try_emplace(symbol->getId(), unknown_of(symbol->getType())).first->second;
    if (components.empty()) {
        held = unknown_of(
            symbol->getType()); // an element of an array, a member of a struct: nothing is known of the whole
    } else if (place->getAsSymbolNode()) {
        held = value;
    } else {
        for (size_t i = 0; i < components.size() && components[i] < held.size(); ++i)
            held[components[i]] = value.size() == 1  ? value.front()
                                  : i < value.size() ? value[i]
                                                     : Component::unknown();
    }
    if (const auto written = now_.written.find(symbol->getId()); counts_as_written && written != now_.written.end())
        for (const size_t component : components)
            written->second |= 1u << component;
}

AbstractValue Interpreter::evaluate_selection(TIntermSelection& node)
{
    evaluate(node.getCondition());
    if (!node.getTrueBlock() || !node.getFalseBlock() || node.getType().getBasicType() == EbtVoid) {
        run_selection(node);
        return {Component::unknown()};
    }
    const Environment before = now_;
    const AbstractValue if_true = evaluate(node.getTrueBlock());
    Environment after_true = std::move(now_);
    now_ = before;
    const AbstractValue if_false = evaluate(node.getFalseBlock());
    now_ = join_environments({after_true, now_});
    return zip(if_true, if_false, join);
}

AbstractValue Interpreter::evaluate_construction(TIntermAggregate& node)
{
    AbstractValue parts;
    const std::vector<TIntermNode*> all(node.getSequence().begin(), node.getSequence().end());
    for (TIntermNode* argument : all) {
        const AbstractValue value = evaluate_beside(argument, all);
        parts.insert(parts.end(), value.begin(), value.end());
    }
    if (node.getType().isArray()) {
        Component joined = parts.front();
        for (const Component& part : parts)
            joined = join(joined, part);
        return {joined};
    }
    const size_t width = width_of(node.getType());
    if (node.getType().isMatrix() || node.getType().isStruct() || (parts.size() != 1 && parts.size() < width))
        return unknown_of(node.getType());
    if (parts.size() == 1)
        return AbstractValue(width, parts.front());
    parts.resize(width);
    return parts;
}

AbstractValue Interpreter::evaluate_aggregate(TIntermAggregate& node)
{
    const TOperator op = node.getOp();
    if (op == EOpFunctionCall)
        return call(node);
    if (op == EOpSequence || op == EOpScope) {
        run_statement(&node);
        return {Component::unknown()};
    }
    if (op == EOpComma) {
        AbstractValue last{Component::unknown()};
        for (TIntermNode* part : node.getSequence())
            last = evaluate(part);
        return last;
    }
    if (op > EOpConstructGuardStart && op < EOpConstructGuardEnd)
        return evaluate_construction(node);
    return evaluate_builtin(node);
}

AbstractValue Interpreter::evaluate_builtin(TIntermAggregate& node)
{
    const TOperator op = node.getOp();
    const std::vector<TIntermNode*> all(node.getSequence().begin(), node.getSequence().end());
    std::vector<AbstractValue> arguments;
    for (TIntermNode* argument : all)
        arguments.push_back(evaluate_beside(argument, all));
    const auto lower = [](const Component& a, const Component& b) { return clamped(a, a, b); };
    const auto higher = [](const Component& a, const Component& b) {
        return negate(clamped(negate(a), negate(a), negate(b)));
    };
    if (op == EOpMin)
        return zip(arguments[0], arguments[1], lower);
    if (op == EOpMax)
        return zip(arguments[0], arguments[1], higher);
    if (op == EOpClamp)
        return zip(zip(arguments[0], arguments[1], higher), arguments[2], lower);
    if ((op == EOpModf || op == EOpFrexp) && node.getSequence().size() > 1)
        assign(node.getSequence()[1], unknown_of(node.getSequence()[1]->getAsTyped()->getType()));
    return unknown_of(node.getType());
}

AbstractValue Interpreter::call(TIntermAggregate& node)
{
    std::vector<AbstractValue> arguments;
    std::vector<TIntermNode*> places;
    const auto function = functions_.find(node.getName().c_str());
    const auto parameters =
        function == functions_.end() ? std::vector<TIntermSymbol*>{} : parameters_of(*function->second);
    const std::vector<TIntermNode*> all(node.getSequence().begin(), node.getSequence().end());
    for (size_t i = 0; i < all.size(); ++i) {
        places.push_back(all[i]);
        arguments.push_back(evaluate_beside(all[i], all));
        if (i < parameters.size() && parameters[i]->getQualifier().storage == EvqOut)
            arguments.back() = unknown_of(all[i]->getAsTyped()->getType());
    }
    if (const auto accessor = accessors_.find(node.getName().c_str()); accessor != accessors_.end())
        return record(accessor->second, arguments, node.getType());
    if (function == functions_.end())
        return unknown_of(node.getType());
    return enter(*function->second, arguments, places);
}

AbstractValue Interpreter::record(const Accessor& accessor, const std::vector<AbstractValue>& arguments,
                                  const TType& type)
{
    Reading& reading = readings_[static_cast<size_t>(accessor.input)];
    switch (accessor.kind) {
    case AccessorKind::texel: {
        reading.is_size_asked = true;
        return {Component::texels(1.0, accessor.input, 0), Component::texels(1.0, accessor.input, 1)};
    }
    case AccessorKind::size:
    case AccessorKind::sphere_size:
        reading.is_size_asked = true;
        return unknown_of(type);
    case AccessorKind::sphere:
    case AccessorKind::level_read:
        reading.is_unbounded = true;
        return unknown_of(type);
    case AccessorKind::read:
        break;
    }
    const AbstractValue& place = arguments.front();
    const auto is_near = [&](size_t axis) {
        const Component& c = place[axis];
        return c.kind == Component::Kind::place && c.axis == static_cast<int>(axis) &&
               (c.input < 0 || c.input == accessor.input);
    };
    if (place.size() == 2 && is_near(0) && is_near(1)) {
        const double radius = std::max(place[0].highest, place[1].highest);
        (radius > 0.0 ? reading.near_pixel : reading.at_pixel) += 1;
        reading.radius = std::max(reading.radius, radius);
    } else {
        reading.computed += 1;
        reading.is_unbounded = reading.is_unbounded || loop_depth_ > 0;
    }
    return unknown_of(type);
}

} // namespace passgraph::shader
