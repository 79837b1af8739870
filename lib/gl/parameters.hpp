// Live parameters by their place ("lit.exposure").
#pragma once

#include <string_view>

#include "gl/targets.hpp"

namespace passgraph::gl {

/// Gives a live parameter a value, in every step that has it.
/// Errors   unknown_param, param_out_of_range (a component outside the range, not finite, or not whole where it must
/// be).
Result<void> set_parameter(PlanObjects& objects, std::string_view place, const Value& value);

} // namespace passgraph::gl
