// Small questions about glslang's syntax tree.
#pragma once

#include <string>
#include <vector>

#include <glslang/Include/intermediate.h>

#include "shader/abstract_value.hpp"

namespace passgraph::shader {

/// The number of components of a scalar or vector; 1 for everything else.
size_t width_of(const glslang::TType& type);
/// A value of which nothing is known.
AbstractValue unknown_of(const glslang::TType& type);
/// Constants: scalars and vectors component by component, arrays and matrices as one interval over all of it.
AbstractValue constants_of(const glslang::TConstUnionArray& constants, const glslang::TType& type);
/// The variable that an assignable expression belongs to, or nullptr.
glslang::TIntermSymbol* base_symbol(TIntermNode* place);
/// The components of its vector that an assignable expression names: `v` all, `v.xz` two; empty when not known.
std::vector<size_t> components_of(TIntermNode* place);
/// Every place that is assigned, incremented or passed as an out parameter inside `node`.
std::vector<TIntermNode*> assigned_places(TIntermNode* node);
bool is_assignment(glslang::TOperator op);
bool is_step(glslang::TOperator op); ///< ++ and --
/// The parameters of a function, in order.
std::vector<glslang::TIntermSymbol*> parameters_of(const glslang::TIntermAggregate& function);
bool is_out(const glslang::TIntermSymbol& parameter); ///< out or inout

} // namespace passgraph::shader
