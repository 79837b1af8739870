// A graph with everything it needs to be drawn, checked as far as that is possible without a context.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include <passgraph/core/compile.hpp>
#include <passgraph/gl/renderer.hpp>
#include <passgraph/scene/scene.hpp>

#include "tool/options.hpp"

namespace passgraph::tool {

/// What the host supplies, loaded.
struct Sources {
    std::optional<Scene> scene;
    std::map<std::string, Picture> pictures; ///< by the graph's input
    std::map<std::string, std::array<Picture, 6>> cubes;
    Extent extent{1280, 720};
    std::map<std::string, Extent> picture_extents; ///< that the pictures are resampled to
};

struct Job {
    Graph graph;
    Sources sources;
    CompileOptions options;
    Plan plan; ///< for options.device; `create_renderer` makes the one that is run
};

/// Loads what the options name and compiles the graph.
///
/// A `--size` resamples the pictures so that the first gets it, the others by the same ratios.
/// Errors   those of the graph; unknown_input, duplicate_name, input_missing, scene_missing; those of the files. All at once.
Result<Job> prepare(Graph graph, const SourceOptions& sources, const CompilerOptions& compiler);

/// As `prepare`, with the plan for a device; inputs may be missing unless it `draws`.
Result<Job> prepare_for(const Device& device, Graph graph, const SourceOptions& sources, const CompilerOptions& compiler, bool draws);

/// A renderer with the plan for its device, and with all the job's sources uploaded. The job must outlive it.
Result<Renderer> create_renderer(const Job& job, const CompileOptions& options, const RendererOptions& device);

} // namespace passgraph::tool
