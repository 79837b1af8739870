// What the compiler's steps hand to each other: plain values, each built by one step from the ones before.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "passgraph/core/codec.hpp"
#include "passgraph/core/compile.hpp"
#include "passgraph/core/graph.hpp"
#include "passgraph/core/plan.hpp"

namespace passgraph::compiler {

/// An output of a node with everything generic resolved.
struct TypedImage {
    Signal signal = Signal::radiance;
    Over over = Over::image;
    Extent extent;
};

/// A graph without mistakes: `images[node][output]`.
struct TypedGraph {
    const Graph* graph = nullptr;
    std::vector<std::vector<TypedImage>> images;

    const GraphNode& node(int index) const { return graph->nodes()[static_cast<size_t>(index)]; }
    const TypedImage& image(ImageRef ref) const
    {
        return images[static_cast<size_t>(ref.node)][static_cast<size_t>(ref.output)];
    }
    int node_count() const { return static_cast<int>(images.size()); }
    bool is_pass(int index) const { return node(index).kind == GraphNode::Kind::pass; }
};

/// The codec of each image: `codecs[node][output]`.
struct Encoding {
    std::vector<std::vector<Codec>> codecs;
    const Codec& of(ImageRef ref) const
    {
        return codecs[static_cast<size_t>(ref.node)][static_cast<size_t>(ref.output)];
    }
};

/// A depth buffer is what geometry writes its depth to, and nothing else: a full-screen draw has none.
inline bool can_store(const PassDeclaration& pass, Signal signal, const Codec& codec)
{
    return signal != Signal::depth || is_depth(codec.format) == (pass.kind == PassKind::geometry);
}

/// Which nodes an output depends on.
struct Liveness {
    std::vector<bool> is_live;
    std::vector<Plan::Culled> culled;
};

/// One draw: its passes, producers first, and the images it leaves in memory.
struct Draw {
    std::vector<int> nodes;
    std::vector<ImageRef> stored;
};

struct Draws {
    std::vector<Draw> draws;  ///< by the declaration order of their first pass
    std::vector<int> draw_of; ///< by node; -1 for what is not drawn
    std::vector<Plan::Boundary> boundaries;
    std::vector<std::string> inlined;
};

/// Indices into Draws::draws, in the order of execution.
using Order = std::vector<int>;

struct ImageLess {
    bool operator()(ImageRef a, ImageRef b) const { return a.node != b.node ? a.node < b.node : a.output < b.output; }
};

/// When a stored image is needed: from the draw that writes it to the last that reads it, as positions in the order.
struct Lifetime {
    ImageRef image;
    int first = 0;
    int last = 0;
};

struct Slots {
    std::vector<Plan::Slot> slots;
    std::map<ImageRef, int, ImageLess> slot_of;
    std::int64_t bytes = 0;
    std::int64_t bytes_unshared = 0;
};

Result<TypedGraph> validate(const Graph& graph, const CompileOptions& options);
Encoding encode(const TypedGraph& graph);
Liveness cull(const TypedGraph& graph, bool is_on);
Draws fuse(const TypedGraph& graph, const Liveness& live, const CompileOptions& options);
Order order_draws(const TypedGraph& graph, const Draws& draws);
std::vector<Lifetime> find_lifetimes(const TypedGraph& graph, const Draws& draws, const Order& order);
Slots allocate(const TypedGraph& graph, const Encoding& encoding, const std::vector<Lifetime>& lifetimes,
               bool is_shared);
Plan lower(const TypedGraph& graph, const Encoding& encoding, const Draws& draws, const Order& order,
           const Slots& slots, const CompileOptions& options);

/// The images of other draws, pictures and cubes that a draw reads: each with the port that reads it.
struct ExternalRead {
    ImageRef image;
    int node = 0; ///< the reader
    int port = 0;
};
std::vector<ExternalRead> external_reads(const TypedGraph& graph, const std::vector<int>& nodes);

} // namespace passgraph::compiler
