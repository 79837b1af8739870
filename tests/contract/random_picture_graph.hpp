// Random graphs of the built-in passes that need pictures alone, to be drawn.
#pragma once

#include <map>
#include <string>

#include <passgraph/core/graph.hpp>
#include <passgraph/core/picture.hpp>

namespace passgraph::test {

struct PictureGraph {
    Graph graph;
    std::map<std::string, Picture> pictures; ///< by import
};

/// 3 to 10 passes over two pictures, one to three outputs; the same for the same seed.
PictureGraph random_picture_graph(unsigned seed);

} // namespace passgraph::test
