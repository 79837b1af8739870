// Random graphs of hand-made passes, the same for the same seed.
#pragma once

#include <memory>

#include <passgraph/core/compile.hpp>

namespace passgraph::test {

struct RandomGraph {
    std::unique_ptr<PassLibrary> library; ///< the graph points to it
    Graph graph;
    CompileOptions options;
};

/// 3 to 24 passes with 1 to 3 inputs and outputs, of every access class and several extents; some feed no output.
RandomGraph random_graph(unsigned seed);

} // namespace passgraph::test
