// From a graph to a plan: which draws, in which order, into which memory.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <passgraph/core/error.hpp>
#include <passgraph/core/facts.hpp>
#include <passgraph/core/graph.hpp>
#include <passgraph/core/plan.hpp>

namespace passgraph {

/// The limits of a device that a plan must respect; the default is what OpenGL 3.3 guarantees.
struct Device {
    int max_texture_size = 1024;
    int max_texture_units = 16;
    int max_color_targets = 8;
    int max_varying_components = 60;
    /// Images that a draw may load texels from, where the device does that quicker than a sampler fetches them; else 0.
    int max_loaded_images = 0;
};

/// Whether passes that say where they are black ("skip" in the header) may keep what follows from them from being drawn.
enum class Skipping : std::uint8_t {
    as_needed, ///< the device counts their pixels, and leaves out what would be black
    never,     ///< everything is drawn
    always,    ///< they are taken to be black everywhere, whether they are or not: for comparing
};

struct CompileOptions {
    Extent extent{1280, 720};                        ///< of the frame: geometry passes, and graphs without pictures
    std::map<std::string, Extent> picture_extents{}; ///< of imported pictures, by name; else `extent`
    Device device{16384, 32, 8, 120};
    Facts facts{}; ///< of the scene, as far as known
    bool specialise = true; ///< false: what a scene or a pixel does not need is done all the same
    Skipping skipping = Skipping::as_needed; ///< as `never` when `specialise` is off
    bool fuse = true;  ///< false: every pass is a step of its own
    bool cull = true;  ///< false: passes that nothing needs run all the same
    bool alias = true; ///< false: every stored image has its own slot
    bool guards = true; ///< false: what a pass returns is stored as it is, outside its signal's domain too
    bool import_guards = true; ///< false: passes get what the host supplies as it is; for the contract suite
};

/// Turns a declared graph into a plan. Pure and deterministic: equal graphs and options give equal plans, byte for byte.
///
/// Errors   every mistake of the graph at once: unknown_pass, unknown_input, unknown_param, unknown_item, unknown_codec,
///          unknown_image, input_missing, signal_mismatch, over_mismatch, generic_mismatch, param_out_of_range, cycle,
///          duplicate_name, output_missing, extent_too_large (a lack of the machine), extent_empty.
/// Cost     O(nodes^2) at most; about a millisecond for the demo.
Result<Plan> compile(const Graph& graph, const CompileOptions& options = {});

} // namespace passgraph
