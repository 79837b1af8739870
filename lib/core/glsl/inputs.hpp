// GLSL of a pass's inputs in a step: the functions that its body reads them by.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/glsl/assemble.hpp"
#include "core/glsl/flat.hpp"
#include "core/glsl/module_text.hpp"

namespace passgraph::glsl {

/// A body's names, and what stands for them in the program.
using Renames = std::vector<std::pair<std::string, std::string>>;

/// The pixels, or the case, that a fragment stage is for.
enum class Part { whole, surfaces, background, when_skipped };

/// What makes the names of an instance unique.
std::string prefix_of(int number);

void add_inputs(ProgramText& text, const Instance& instance, const Flats& flats, Renames& renames, Part part);

} // namespace passgraph::glsl
