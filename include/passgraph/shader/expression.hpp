// What a GLSL expression needs before it can be evaluated alone.
#pragma once

#include <string>
#include <vector>

#include <passgraph/core/error.hpp>

namespace passgraph {

/// GLSL ready to stand before an expression: the functions of a common file, or those of a pass with its parameters and
/// selections at their defaults and its inputs as functions returning their default values.
struct ExpressionScope {
    std::string declarations;
    std::vector<std::string> sources; ///< file of each `#line` source number
};

/// Reads the file (a pass or a common file) with what it includes, checked.
/// Errors   those of `load_pass_file`; for a common file include_missing, forbidden_builtin, glsl_error.
Result<ExpressionScope> load_expression_scope(const std::string& path, const std::string& fallback_common = "");

/// The number of components (1 to 4) of the expression's value, each of `columns` being a float variable.
/// Errors   glsl_error when it does not compile, or its value is no float, integer, boolean or float vector.
Result<int> expression_components(const ExpressionScope& scope, const std::string& expression,
                                  const std::vector<std::string>& columns);

} // namespace passgraph
