// Runs a pass's syntax tree on what is known instead of on numbers, to learn where it reads its inputs and what it writes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glslang/Include/intermediate.h>

#include "passgraph/core/declaration.hpp"
#include "shader/abstract_value.hpp"

namespace passgraph::shader {

/// How one input was read, over every path of one entry.
struct Reading {
    bool is_size_asked = false;
    int at_pixel = 0;          ///< reads at uv itself
    int near_pixel = 0;        ///< reads at a bounded number of texels from it
    double radius = 0.0;       ///< the largest such number
    int computed = 0;          ///< reads at places of which nothing is known
    bool is_unbounded = false; ///< a computed place in a loop, or a level of detail

    bool is_used() const { return is_size_asked || at_pixel + near_pixel + computed > 0 || is_unbounded; }
};

Access access_of(const Reading& reading);

/// An abstract interpreter over glslang's tree.
///
/// Context-sensitive: each call is entered anew with what is known of its arguments (GLSL has no recursion). Branches are
/// both taken and joined; a loop's variables are forgotten first, except a counter with known bounds.
class Interpreter {
public:
    Interpreter(const PassDeclaration& pass, TIntermNode* root);

    struct Result {
        std::vector<Reading> readings;      ///< as pass.inputs
        std::vector<std::string> unwritten; ///< out parameters, or "" for a missing return value
        std::vector<std::string> recursive; ///< mangled names of functions that call themselves
    };
    /// Enters `function` (a mangled name); its first vec2 parameter called uv is the entry's uv when `has_uv`.
    Result run(const std::string& function, bool has_uv);

    bool has_function(const std::string& mangled) const { return functions_.contains(mangled); }
    const glslang::TIntermAggregate* function(const std::string& mangled) const { return functions_.at(mangled); }
    /// Mangled names of every function called `name`.
    std::vector<std::string> overloads(const std::string& name) const;

private:
    struct Environment {
        std::map<long long, AbstractValue> values;
        std::map<long long, unsigned> written; ///< components assigned, by out parameter
        bool is_reachable = true;
    };
    struct Frame {
        const glslang::TIntermAggregate* function = nullptr;
        std::vector<AbstractValue> results;
        std::vector<Environment> exits;
    };
    enum class AccessorKind { read, level_read, size, texel, sphere, sphere_size };
    struct Accessor {
        AccessorKind kind;
        int input;
    };

    void run_statement(TIntermNode* node);
    void run_selection(glslang::TIntermSelection& node);
    void run_loop(glslang::TIntermLoop& node);
    void run_switch(glslang::TIntermSwitch& node);
    void run_branch(glslang::TIntermBranch& node);
    bool bind_counter(glslang::TIntermLoop& loop, const Environment& before);

    AbstractValue evaluate(TIntermNode* node);
    AbstractValue evaluate_beside(TIntermNode* operand, const std::vector<TIntermNode*>& others);
    AbstractValue evaluate_symbol(const glslang::TIntermSymbol& symbol);
    AbstractValue evaluate_unary(glslang::TIntermUnary& node);
    AbstractValue evaluate_binary(glslang::TIntermBinary& node);
    AbstractValue evaluate_assignment(glslang::TIntermBinary& node);
    AbstractValue evaluate_builtin(glslang::TIntermAggregate& node);
    AbstractValue evaluate_aggregate(glslang::TIntermAggregate& node);
    AbstractValue evaluate_construction(glslang::TIntermAggregate& node);
    AbstractValue evaluate_selection(glslang::TIntermSelection& node);
    AbstractValue call(glslang::TIntermAggregate& node);
    AbstractValue enter(const glslang::TIntermAggregate& function, const std::vector<AbstractValue>& arguments,
                        const std::vector<TIntermNode*>& places);
    AbstractValue record(const Accessor& accessor, const std::vector<AbstractValue>& arguments,
                         const glslang::TType& type);
    void assign(TIntermNode* place, const AbstractValue& value, bool counts_as_written = true);
    void copy_out(const glslang::TIntermAggregate& function, const std::vector<TIntermNode*>& places);
    void forget_assigned(TIntermNode* node);
    const std::vector<glslang::TIntermSymbol*>& assigned_symbols(TIntermNode* node);
    void give_up();

    static Environment join_environments(const std::vector<Environment>& environments);

    const PassDeclaration& pass_;
    std::map<std::string, glslang::TIntermAggregate*> functions_;
    std::map<std::string, Accessor> accessors_;
    std::map<std::string, Component> known_symbols_; ///< live parameters by name
    Environment now_;
    std::vector<Frame> frames_;
    std::vector<std::vector<Environment>*> breaks_;
    std::vector<Reading> readings_;
    std::map<TIntermNode*, std::vector<glslang::TIntermSymbol*>> assigned_; ///< once looked for
    std::vector<std::string> recursive_;
    int loop_depth_ = 0;
    int steps_ = 0;
};

} // namespace passgraph::shader
