// The window behind a GLFW context, for those of this layer who take its events.
#pragma once

#include "passgraph/context/context.hpp"

struct GLFWwindow;

namespace passgraph::context_kinds {

/// Of a context of kind `glfw`.
GLFWwindow* window_of(const Context& context);

} // namespace passgraph::context_kinds
