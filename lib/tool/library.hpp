// Where the program finds passes and graphs.
#pragma once

#include <passgraph/core/graph.hpp>
#include <passgraph/core/graph_file.hpp>

#include "tool/options.hpp"

namespace passgraph::tool {

/// The built-in passes, extended or replaced by those of the user's folders.
/// Errors   every mistake in the folders' passes.
Result<PassLibrary> load_library(const LibraryOptions& options);

/// A pass by its name, or by the path of its file, which is then added to the library.
/// Errors   unknown_pass; those of the file.
Result<PassPtr> find_pass(const std::string& name_or_file, PassLibrary& library);

/// The graph of a file with presets and settings applied. The library must outlive it.
///
/// Mistakes in settings are kept in the graph, so that `compile` returns them with all others.
/// Errors   those of form, of the graph and of the preset.
Result<Graph> open_graph(const GraphOptions& options, const PassLibrary& library);

/// The folder that `#include` falls back to: the built-in passes' common functions.
std::string common_folder();

} // namespace passgraph::tool
