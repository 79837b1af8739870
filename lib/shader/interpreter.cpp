// The abstract interpreter's statements: paths, loops, calls and what they leave written.
#include "shader/interpreter.hpp"

#include <algorithm>
#include <cmath>

#include "shader/tree.hpp"

namespace passgraph::shader {

using namespace glslang;

namespace {

/// Beyond this a pass is too large to follow: its reads then count as unknown, never as something better.
constexpr int kMostSteps = 100000;
constexpr size_t kDeepestCall = 100;

unsigned all_components(const TType& type) { return (1u << width_of(type)) - 1u; }

} // namespace

Access access_of(const Reading& reading)
{
    const int bounded = reading.at_pixel + reading.near_pixel;
    constexpr double kWidestRadius = 65536.0; // no picture is wider
    if (reading.is_unbounded || reading.computed > 1 || (reading.computed == 1 && bounded > 0) ||
        reading.radius > kWidestRadius)
        return {AccessClass::gather, Access::kUnknownRadius};
    if (reading.computed == 1)
        return {AccessClass::warp, Access::kUnknownRadius};
    if (reading.near_pixel > 0)
        return {AccessClass::gather, static_cast<int>(std::ceil(reading.radius))};
    return {reading.at_pixel > 0 ? AccessClass::pointwise : AccessClass::size_only, 0};
}

Interpreter::Interpreter(const PassDeclaration& pass, TIntermNode* root) : pass_(pass), readings_(pass.inputs.size())
{
    for (TIntermNode* node : root->getAsAggregate()->getSequence())
        if (TIntermAggregate* aggregate = node->getAsAggregate(); aggregate && aggregate->getOp() == EOpFunction)
            functions_[aggregate->getName().c_str()] = aggregate;
    for (size_t i = 0; i < pass.inputs.size(); ++i) {
        const std::string& name = pass.inputs[i].name;
        const int input = static_cast<int>(i);
        if (pass.inputs[i].over == Over::sphere) {
            accessors_[name + "(vf3;f1;"] = {AccessorKind::sphere, input};
            accessors_[name + "_top_lod("] = {AccessorKind::sphere_size, input};
        } else {
            accessors_[name + "(vf2;"] = {AccessorKind::read, input};
            accessors_[name + "_lod(vf2;f1;"] = {AccessorKind::level_read, input};
            accessors_[name + "_size("] = {AccessorKind::size, input};
            accessors_[name + "_texel("] = {AccessorKind::texel, input};
        }
    }
    // A live parameter stays in its range, whatever it is set to.
    for (const Param& param : pass.params)
        if (component_count(param.type) == 1 && std::isfinite(param.lowest) && std::isfinite(param.highest))
            known_symbols_[param.name] = Component::number(param.lowest, param.highest);
}

std::vector<std::string> Interpreter::overloads(const std::string& name) const
{
    std::vector<std::string> found;
    for (const auto& [mangled, node] : functions_)
        if (mangled.starts_with(name + "("))
            found.push_back(mangled);
    return found;
}

Interpreter::Result Interpreter::run(const std::string& function, bool has_uv)
{
    const TIntermAggregate& entry = *functions_.at(function);
    now_ = {};
    std::vector<AbstractValue> arguments;
    bool is_uv_due = has_uv;
    for (const TIntermSymbol* parameter : parameters_of(entry)) {
        const bool is_uv = is_uv_due && width_of(parameter->getType()) == 2 && !is_out(*parameter);
        arguments.push_back(is_uv ? AbstractValue{Component::uv(0), Component::uv(1)}
                                  : unknown_of(parameter->getType()));
        is_uv_due = is_uv_due && !is_uv;
        if (is_out(*parameter))
            now_.written[parameter->getId()] = 0;
    }
    frames_.push_back({&entry, {}, {}});
    const std::vector<TIntermSymbol*> parameters = parameters_of(entry);
    for (size_t i = 0; i < parameters.size(); ++i)
        now_.values[parameters[i]->getId()] = arguments[i];
    if (entry.getSequence().size() > 1)
        run_statement(entry.getSequence()[1]);

    Result result;
    result.recursive = recursive_;
    const bool returns_value = entry.getType().getBasicType() != EbtVoid;
    if (now_.is_reachable && returns_value)
        result.unwritten.emplace_back("");
    frames_.back().exits.push_back(now_);
    for (const TIntermSymbol* parameter : parameters) {
        if (!is_out(*parameter))
            continue;
        const bool is_written =
            std::all_of(frames_.back().exits.begin(), frames_.back().exits.end(), [&](const Environment& exit) {
                const auto mask = exit.written.find(parameter->getId());
                return !exit.is_reachable ||
                       (mask != exit.written.end() && mask->second == all_components(parameter->getType()));
            });
        if (!is_written)
            result.unwritten.emplace_back(parameter->getName().c_str());
    }
    frames_.pop_back();
    if (steps_ > kMostSteps)
        result.unwritten.clear(); // what was not followed is not blamed
    result.readings = readings_;
    return result;
}

Interpreter::Environment Interpreter::join_environments(const std::vector<Environment>& environments)
{
    Environment joined;
    joined.is_reachable = false;
    for (const Environment& environment : environments) {
        if (!environment.is_reachable)
            continue;
        if (!joined.is_reachable) {
            joined = environment;
            continue;
        }
        std::erase_if(joined.values, [&](const auto& entry) { return !environment.values.contains(entry.first); });
        for (auto& [id, value] : joined.values)
            value = zip(value, environment.values.at(id), join);
        for (auto& [id, mask] : joined.written) {
            const auto other = environment.written.find(id);
            mask &= other == environment.written.end() ? 0u : other->second;
        }
    }
    return joined;
}

void Interpreter::run_statement(TIntermNode* node)
{
    if (!node || !now_.is_reachable)
        return;
    if (TIntermAggregate* aggregate = node->getAsAggregate();
        aggregate && (aggregate->getOp() == EOpSequence || aggregate->getOp() == EOpScope)) {
        for (TIntermNode* statement : aggregate->getSequence())
            run_statement(statement);
    } else if (TIntermSelection* selection = node->getAsSelectionNode()) {
        run_selection(*selection);
    } else if (TIntermLoop* loop = node->getAsLoopNode()) {
        run_loop(*loop);
    } else if (TIntermSwitch* branches = node->getAsSwitchNode()) {
        run_switch(*branches);
    } else if (TIntermBranch* branch = node->getAsBranchNode()) {
        run_branch(*branch);
    } else {
        evaluate(node);
    }
}

void Interpreter::run_selection(TIntermSelection& node)
{
    evaluate(node.getCondition());
    const Environment before = now_;
    run_statement(node.getTrueBlock());
    Environment after_true = std::move(now_);
    now_ = before;
    run_statement(node.getFalseBlock());
    now_ = join_environments({after_true, now_});
}

void Interpreter::forget_assigned(TIntermNode* node)
{
    for (const TIntermSymbol* symbol : assigned_symbols(node))
        now_.values[symbol->getId()] = unknown_of(symbol->getType());
}

const std::vector<TIntermSymbol*>& Interpreter::assigned_symbols(TIntermNode* node)
{
    const auto [entry, is_new] = assigned_.try_emplace(node);
    if (is_new)
        for (TIntermNode* place : assigned_places(node))
            if (TIntermSymbol* symbol = base_symbol(place))
                entry->second.push_back(symbol);
    return entry->second;
}

/// Recognises `for (int i = A; i < B; ++i)` with known A and B: the counter is then known to lie between them.
bool Interpreter::bind_counter(TIntermLoop& loop, const Environment& before)
{
    TIntermBinary* test = loop.getTest() ? loop.getTest()->getAsBinaryNode() : nullptr;
    TIntermSymbol* counter = test ? test->getLeft()->getAsSymbolNode() : nullptr;
    if (!counter || !loop.getTerminal())
        return false;
    const bool rises = test->getOp() == EOpLessThan || test->getOp() == EOpLessThanEqual;
    const bool falls = test->getOp() == EOpGreaterThan || test->getOp() == EOpGreaterThanEqual;
    const TIntermUnary* step = loop.getTerminal()->getAsUnaryNode();
    const bool steps_up = step && (step->getOp() == EOpPreIncrement || step->getOp() == EOpPostIncrement);
    const bool steps_down = step && (step->getOp() == EOpPreDecrement || step->getOp() == EOpPostDecrement);
    const bool wraps = falls && counter->getType().getBasicType() == EbtUint; // below 0
    if ((!(rises && steps_up) && !(falls && steps_down)) || wraps)
        return false;
    for (TIntermNode* part : {loop.getBody(), static_cast<TIntermNode*>(loop.getTest())})
        for (const TIntermSymbol* symbol : assigned_symbols(part))
            if (symbol->getId() == counter->getId())
                return false;
    const auto start = before.values.find(counter->getId());
    const AbstractValue bound = evaluate(test->getRight());
    if (start == before.values.end() || start->second.front().kind != Component::Kind::number ||
        bound.front().kind != Component::Kind::number)
        return false;
    const Component from = start->second.front();
    const Component to = bound.front();
    now_.values[counter->getId()] = {rises ? Component::number(from.lowest, std::max(from.lowest, to.highest))
                                           : Component::number(std::min(from.highest, to.lowest), from.highest)};
    return true;
}

void Interpreter::run_loop(TIntermLoop& node)
{
    const Environment before = now_;
    forget_assigned(node.getBody());
    forget_assigned(node.getTest());
    forget_assigned(node.getTerminal());
    bind_counter(node, before);
    const Environment after = [&] {
        Environment forgotten = now_; // what holds however often the body ran, nothing of it counting as written
        forget_assigned(&node);
        std::swap(forgotten, now_);
        return forgotten;
    }();
    std::vector<Environment> left;
    breaks_.push_back(&left);
    ++loop_depth_;
    const Environment head = now_;
    if (node.getTest() && node.testFirst())
        evaluate(node.getTest());
    run_statement(node.getBody());
    now_ = head; // the body may have ended by `continue`
    if (node.getTest() && !node.testFirst())
        evaluate(node.getTest());
    if (node.getTerminal())
        evaluate(node.getTerminal());
    --loop_depth_;
    breaks_.pop_back();
    now_ = after;
}

void Interpreter::run_switch(TIntermSwitch& node)
{
    evaluate(node.getCondition());
    const Environment before = now_;
    std::vector<Environment> ends;
    breaks_.push_back(&ends);
    bool has_default = false;
    now_.is_reachable = false;
    for (TIntermNode* statement : node.getBody()->getSequence()) {
        const TIntermBranch* label = statement->getAsBranchNode();
        if (label && (label->getFlowOp() == EOpCase || label->getFlowOp() == EOpDefault)) {
            has_default = has_default || label->getFlowOp() == EOpDefault;
            now_ = join_environments({before, now_}); // entered here, or fallen into from above
        } else {
            run_statement(statement);
        }
    }
    breaks_.pop_back();
    ends.push_back(now_);
    if (!has_default)
        ends.push_back(before);
    now_ = join_environments(ends);
}

void Interpreter::run_branch(TIntermBranch& node)
{
    switch (node.getFlowOp()) {
    case EOpReturn:
        if (node.getExpression()) {
            AbstractValue result = evaluate(node.getExpression()); // may enter functions: frames_ grows
            frames_.back().results.push_back(std::move(result));
        }
        frames_.back().exits.push_back(now_);
        break;
    case EOpBreak:
        if (!breaks_.empty())
            breaks_.back()->push_back(now_);
        break;
    default:
        break; // continue, discard: this path ends here
    }
    now_.is_reachable = false;
}

AbstractValue Interpreter::enter(const TIntermAggregate& function, const std::vector<AbstractValue>& arguments,
                                 const std::vector<TIntermNode*>& places)
{
    const bool is_recursive =
        std::any_of(frames_.begin(), frames_.end(), [&](const Frame& frame) { return frame.function == &function; });
    if (is_recursive)
        recursive_.emplace_back(function.getName().c_str());
    if (is_recursive || frames_.size() > kDeepestCall) {
        give_up();
        return unknown_of(function.getType());
    }
    const std::vector<TIntermSymbol*> parameters = parameters_of(function);
    std::vector<std::vector<Environment>*> outer_breaks;
    std::swap(outer_breaks, breaks_);
    frames_.push_back({&function, {}, {}});
    for (size_t i = 0; i < parameters.size(); ++i) {
        now_.values[parameters[i]->getId()] =
            i < arguments.size() ? arguments[i] : unknown_of(parameters[i]->getType());
        if (is_out(*parameters[i]))
            now_.written[parameters[i]->getId()] = 0;
    }
    if (function.getSequence().size() > 1)
        run_statement(function.getSequence()[1]);
    Frame frame = std::move(frames_.back());
    frames_.pop_back();
    std::swap(outer_breaks, breaks_);
    frame.exits.push_back(now_);
    now_ = join_environments(frame.exits);
    copy_out(function, places);
    if (frame.results.empty())
        return unknown_of(function.getType());
    AbstractValue result = frame.results.front();
    for (const AbstractValue& other : frame.results)
        result = zip(result, other, join);
    return result;
}

/// What a call leaves in the places that were given for its out parameters.
void Interpreter::copy_out(const TIntermAggregate& function, const std::vector<TIntermNode*>& places)
{
    const std::vector<TIntermSymbol*> parameters = parameters_of(function);
    std::vector<long long> seen;
    for (size_t i = 0; i < parameters.size() && i < places.size() && now_.is_reachable; ++i) {
        const TIntermSymbol* base = base_symbol(places[i]);
        if (!is_out(*parameters[i]) || !base)
            continue;
        const long long id = parameters[i]->getId();
        const auto value = now_.values.find(id);
        // GLSL does not say in which order one variable gets the results of two parameters.
        const bool is_second = std::find(seen.begin(), seen.end(), base->getId()) != seen.end();
        const bool is_complete = now_.written[id] == all_components(parameters[i]->getType());
        const AbstractValue unknown = unknown_of(parameters[i]->getType());
        assign(places[i], value == now_.values.end() || is_second ? unknown : AbstractValue(value->second),
               is_complete);
        if (is_second)
            now_.values[base->getId()] = unknown_of(base->getType());
        seen.push_back(base->getId());
    }
}

/// From here on nothing is followed: every input may be read anywhere.
void Interpreter::give_up()
{
    steps_ = kMostSteps + 1;
    for (Reading& reading : readings_)
        reading.is_unbounded = true;
}

AbstractValue Interpreter::evaluate(TIntermNode* node)
{
    if (++steps_ > kMostSteps) {
        give_up();
        return {Component::unknown()};
    }
    if (TIntermConstantUnion* constant = node->getAsConstantUnion())
        return constants_of(constant->getConstArray(), constant->getType());
    if (TIntermSymbol* symbol = node->getAsSymbolNode())
        return evaluate_symbol(*symbol);
    if (TIntermUnary* unary = node->getAsUnaryNode())
        return evaluate_unary(*unary);
    if (TIntermBinary* binary = node->getAsBinaryNode())
        return is_assignment(binary->getOp()) ? evaluate_assignment(*binary) : evaluate_binary(*binary);
    if (TIntermSelection* selection = node->getAsSelectionNode())
        return evaluate_selection(*selection);
    if (TIntermAggregate* aggregate = node->getAsAggregate())
        return evaluate_aggregate(*aggregate);
    run_statement(node);
    return {Component::unknown()};
}

} // namespace passgraph::shader
