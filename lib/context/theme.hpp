// How the user interface looks.
#pragma once

#include "passgraph/context/window.hpp"

namespace passgraph::context_kinds {

/// Loads the fonts (number 1 of the atlas is the one for columns) and sets a dark, compact style.
void set_theme(const WindowOptions& options);

} // namespace passgraph::context_kinds
