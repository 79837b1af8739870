// Small questions about glslang's syntax tree.
#include "shader/tree.hpp"

#include <limits>

namespace passgraph::shader {

using namespace glslang;

size_t width_of(const TType& type)
{
    return type.isVector() && !type.isArray() ? static_cast<size_t>(type.getVectorSize()) : 1;
}

AbstractValue unknown_of(const TType& type) { return AbstractValue(width_of(type), Component::unknown()); }

namespace {

double number_of(const TConstUnion& constant)
{
    switch (constant.getType()) {
    case EbtInt:
        return constant.getIConst();
    case EbtUint:
        return constant.getUConst();
    case EbtBool:
        return constant.getBConst() ? 1.0 : 0.0;
    case EbtFloat:
    case EbtDouble:
        return constant.getDConst();
    default:
        return std::numeric_limits<double>::quiet_NaN();
    }
}

Component component_of(double number)
{
    return number == number ? Component::number(number, number) : Component::unknown();
}

class AssignedPlaces : public TIntermTraverser {
public:
    bool visitBinary(TVisit, TIntermBinary* node) override
    {
        if (is_assignment(node->getOp()))
            places.push_back(node->getLeft());
        return true;
    }
    bool visitUnary(TVisit, TIntermUnary* node) override
    {
        if (is_step(node->getOp()))
            places.push_back(node->getOperand());
        return true;
    }
    bool visitAggregate(TVisit, TIntermAggregate* node) override
    {
        const bool is_call = node->getOp() == EOpFunctionCall;
        const bool has_out = node->getOp() == EOpModf || node->getOp() == EOpFrexp;
        for (size_t i = 0; (is_call || has_out) && i < node->getSequence().size(); ++i) {
            const TQualifierList& qualifiers = node->getQualifierList();
            const bool is_written =
                is_call ? i >= qualifiers.size() || qualifiers[i] == EvqOut || qualifiers[i] == EvqInOut : i == 1;
            if (is_written)
                places.push_back(node->getSequence()[i]);
        }
        return true;
    }
    std::vector<TIntermNode*> places;
};

} // namespace

AbstractValue constants_of(const TConstUnionArray& constants, const TType& type)
{
    const size_t width = width_of(type);
    AbstractValue value;
    for (int i = 0; i < constants.size(); ++i) {
        const Component component = component_of(number_of(constants[i]));
        if (type.isArray() || type.isMatrix() || type.isStruct()) {
            value = value.empty() ? AbstractValue{component} : AbstractValue{join(value.front(), component)};
        } else {
            value.push_back(component);
        }
    }
    if (value.empty() || (!type.isArray() && value.size() != width && !type.isMatrix()))
        return unknown_of(type);
    return value;
}

TIntermSymbol* base_symbol(TIntermNode* place)
{
    if (TIntermSymbol* symbol = place->getAsSymbolNode())
        return symbol;
    if (TIntermBinary* binary = place->getAsBinaryNode()) {
        switch (binary->getOp()) {
        case EOpIndexDirect:
        case EOpIndexIndirect:
        case EOpIndexDirectStruct:
        case EOpVectorSwizzle:
            return base_symbol(binary->getLeft());
        default:
            break;
        }
    }
    return nullptr;
}

std::vector<size_t> components_of(TIntermNode* place)
{
    std::vector<size_t> components;
    if (const TIntermSymbol* symbol = place->getAsSymbolNode()) {
        for (size_t i = 0; i < width_of(symbol->getType()); ++i)
            components.push_back(i);
        return components;
    }
    TIntermBinary* binary = place->getAsBinaryNode();
    if (!binary || !binary->getLeft()->getAsSymbolNode() || !binary->getLeft()->getType().isVector() ||
        binary->getLeft()->getType().isArray())
        return {};
    if (binary->getOp() == EOpIndexDirect && binary->getRight()->getAsConstantUnion()) {
        components.push_back(
            static_cast<size_t>(binary->getRight()->getAsConstantUnion()->getConstArray()[0].getIConst()));
    } else if (binary->getOp() == EOpVectorSwizzle) {
        for (TIntermNode* item : binary->getRight()->getAsAggregate()->getSequence())
            components.push_back(static_cast<size_t>(item->getAsConstantUnion()->getConstArray()[0].getIConst()));
    }
    return components;
}

std::vector<TIntermNode*> assigned_places(TIntermNode* node)
{
    AssignedPlaces traverser;
    if (node)
        node->traverse(&traverser);
    return std::move(traverser.places);
}

bool is_assignment(TOperator op) { return op >= EOpAssign && op <= EOpRightShiftAssign; }

bool is_step(TOperator op)
{
    return op == EOpPostIncrement || op == EOpPostDecrement || op == EOpPreIncrement || op == EOpPreDecrement;
}

std::vector<TIntermSymbol*> parameters_of(const TIntermAggregate& function)
{
    std::vector<TIntermSymbol*> parameters;
    for (TIntermNode* node : function.getSequence()[0]->getAsAggregate()->getSequence())
        if (TIntermSymbol* symbol = node->getAsSymbolNode())
            parameters.push_back(symbol);
    return parameters;
}

bool is_out(const TIntermSymbol& parameter)
{
    return parameter.getQualifier().storage == EvqOut || parameter.getQualifier().storage == EvqInOut;
}

} // namespace passgraph::shader
