// One graph of the window: its file's content, what a person changed, and the plans made of both.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <passgraph/core/compile.hpp>
#include <passgraph/core/graph_file.hpp>

#include "tool/view/controls.hpp"

namespace passgraph::tool::view {

struct Stack {
    std::string file;
    std::string name; ///< the file's, without folder and endings
    std::shared_ptr<const GraphDescription> description{}; ///< nullptr: could not be read yet
    Settings settings{};
    std::string shown{}; ///< an image to look at instead of the output; "": the output
};

/// "samples/bloom.graph.json" -> "bloom".
std::string stack_name(const std::string& file);

/// The images of the graph's passes, in the graph's order.
std::vector<std::string> images_of(const Stack& stack, const PassLibrary& library);

/// The plan of the stack's output, or of the image that is shown.
/// Errors   those of `compile`.
Result<Plan> plan_of(const Stack& stack, const PassLibrary& library, const CompileOptions& options);

/// A plan that keeps every image of the graph, each being an output of its own name.
Result<Plan> plan_of_all_images(const Stack& stack, const PassLibrary& library, const CompileOptions& options);

/// True when the two plans differ in live values alone, so that one may run with the other's.
bool runs_alike(const Plan& a, const Plan& b);

/// Settings by name ("glow.sigma", or a param of the graph) as settings of the file's passes.
Settings settings_by_place(const std::vector<PassArguments::Setting>& settings, const GraphDescription& description);

} // namespace passgraph::tool::view
