// A rung ready to be drawn.
#pragma once

#include <passgraph/core/graph_file.hpp>
#include <passgraph/gl/renderer.hpp>

#include "tool/accuracy/ladder.hpp"

namespace passgraph::accuracy {

/// A renderer with a rung's plan and its ladder's inputs. The inputs must outlive it.
struct Subject {
    Renderer renderer;
    double bytes_per_pixel = 0.0; ///< of the images kept between draws, or of the result where there are none
};

/// Builds, compiles and uploads. Every pass is a step of its own, so that each store and load is there.
/// Errors   those of the graph, the plan and the renderer: a rung that no longer fits the passes it measures.
Result<Subject> make_subject(const Rung& rung, const Inputs& inputs, Extent extent, const PassLibrary& library, GlLoader loader);

/// Draws once and reads the rung's `result`.
Result<Picture> draw_and_read(Subject& subject);

} // namespace passgraph::accuracy
