// What the compiler's steps hand to each other: plain values, each built by one step from the ones before.
#pragma once

#include <compare>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "passgraph/core/codec.hpp"
#include "passgraph/core/compile.hpp"
#include "passgraph/core/facts.hpp"
#include "passgraph/core/graph.hpp"
#include "passgraph/core/plan.hpp"

namespace passgraph::compiler {

struct ImageLess {
    bool operator()(ImageRef a, ImageRef b) const { return a.node != b.node ? a.node < b.node : a.output < b.output; }
};

/// An output of a node with everything generic resolved.
struct TypedImage {
    Signal signal = Signal::radiance;
    Over over = Over::image;
    Extent extent;
};

/// A graph without mistakes: `images[node][output]`. Steps that change a graph hand on another.
struct TypedGraph {
    std::vector<GraphNode> nodes; ///< producers first
    std::vector<GraphOutput> outputs;
    std::vector<std::vector<TypedImage>> images;
    const PassLibrary* library = nullptr; ///< where derivations are found

    const GraphNode& node(int index) const { return nodes[static_cast<size_t>(index)]; }
    std::string name(ImageRef image) const { return image_name(nodes, image); }
    const TypedImage& image(ImageRef ref) const
    {
        return images[static_cast<size_t>(ref.node)][static_cast<size_t>(ref.output)];
    }
    int node_count() const { return static_cast<int>(images.size()); }
    bool is_pass(int index) const { return node(index).kind == GraphNode::Kind::pass; }
};

/// A graph without what the scene and the parameters make superfluous.
struct Specialised {
    TypedGraph graph;
    std::map<std::pair<int, int>, Extent> black_inputs{}; ///< by node and input: not wired any more; its values are 0
    std::vector<Plan::Decision> decisions{};
};

/// A texture that a node draws into; one may hold several images, and one image may stand in several.
struct TargetRef {
    int node = -1;
    int target = 0;
    friend auto operator<=>(const TargetRef&, const TargetRef&) = default;
};

/// How an image stands in the targets of its node; without places it is never stored.
struct Storage {
    Codec codec;
    std::vector<Layout::Place> places;
};

/// How everything is stored: `storage[node][output]`, and `targets[node]` to hold it.
struct Encoding {
    std::vector<std::vector<Storage>> storage;
    std::vector<std::vector<Layout::Target>> targets;
    std::vector<int> depth_target; ///< by node: what geometry tests against; -1 for full-screen passes

    const Storage& of(ImageRef ref) const
    {
        return storage[static_cast<size_t>(ref.node)][static_cast<size_t>(ref.output)];
    }
    const Layout::Target& target(TargetRef ref) const
    {
        return targets[static_cast<size_t>(ref.node)][static_cast<size_t>(ref.target)];
    }
    /// Where an image stands, each target once.
    std::set<TargetRef> targets_of(ImageRef image) const;
};

/// A full-screen draw has no depth buffer to write its depth to.
inline bool can_store(const PassDeclaration& pass, const Codec& codec)
{
    return !is_depth(codec.format) || pass.kind == PassKind::geometry;
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
    std::set<int> called{}; ///< of the nodes: those that are computed where another looks, not at the draw's own pixel
    std::optional<TargetRef> tested_depth{}; ///< set: drawn in two parts, by this depth buffer
};

struct Draws {
    std::vector<Draw> draws;  ///< by the declaration order of their first pass
    std::vector<int> draw_of; ///< by node; -1 for what is not drawn
    std::vector<Plan::Boundary> boundaries;
    std::vector<std::string> inlined;
};

/// Indices into Draws::draws, in the order of execution.
using Order = std::vector<int>;

/// A small draw that looks first whether a draw will be black: at all that a pass of it reads, with that pass's condition, or
/// whether the images that the draw reads are 0.
struct Scout {
    PassPtr pass; ///< of one mask, not 0 where something is found
    int node = -1; ///< the pass whose condition it asks, with that node's inputs and parameters
    std::vector<ImageRef> images; ///< without such: its inputs
    Extent extent;
};

/// What a draw has to do with a query: does any pixel that a draw stores differ from black?
struct Condition {
    int counts = -1;     ///< the query that this draw answers; -1: none
    int skipped_by = -1; ///< the query that must count a pixel, or else this draw is left out; -1: none
    /// Not empty: nothing is left out, but a simpler variant is drawn instead, for which these images are 0.
    std::set<ImageRef, ImageLess> black_inputs{};

    bool is_cleared = false; ///< left out, its images are read all the same, by what does not know, or by the host
    std::optional<Scout> scout{}; ///< of a draw that counts

    bool is_free() const { return counts < 0 && skipped_by < 0; }
};

struct Conditions {
    std::vector<Condition> of_draw;   ///< by draw
    std::vector<std::string> counted; ///< by query: the images whose pixels it counts
};

/// When a target is needed: from the draw that writes it to the last that reads it, as positions in the order.
struct Lifetime {
    TargetRef target;
    int first = 0;
    int last = 0;
};

struct Slots {
    std::vector<Plan::Slot> slots;
    std::map<TargetRef, int> slot_of;
    std::int64_t bytes = 0;
    std::int64_t bytes_unshared = 0;
};

Result<TypedGraph> validate(const Graph& graph, const CompileOptions& options);
TypedGraph derive(const TypedGraph& graph);
Specialised specialise(const TypedGraph& graph, const CompileOptions& options);
Encoding encode(const TypedGraph& graph);
/// What was needed in `before` and no longer is has another reason than what never was.
Liveness cull(const Specialised& special, const TypedGraph& before, bool is_on);
Draws fuse(const TypedGraph& graph, const Encoding& encoding, const Liveness& live, const CompileOptions& options);
/// The geometry passes that a node's inputs come from, directly or not.
std::set<int> geometry_of(const TypedGraph& graph, int node);
/// Sets Draw::tested_depth where passes of a draw do nothing at some pixels.
Draws split_by_depth(const TypedGraph& graph, const Encoding& encoding, Draws draws, bool is_on);
Order order_draws(const TypedGraph& graph, const Draws& draws);
using Images = std::set<ImageRef, ImageLess>;
/// Whether anything may be left out by what the device counts.
bool may_skip_at_all(const CompileOptions& options);
/// Whether a node is a pass that says where it is black, and black means 0 in its signal.
bool may_skip(const TypedGraph& graph, int node);
/// The given images, and all that are 0 everywhere when these are.
Images blackened_by(const Specialised& special, Images black);
/// Whether a full-screen draw leaves nothing in memory but these images, and 0 as the code of 0.
bool stores_only(const TypedGraph& graph, const Encoding& encoding, const Draw& draw, const Images& images);
/// What looks first for pixels of a draw that is black where the node is; nothing where that cannot be known from its texels.
std::optional<Scout> find_scout(const Specialised& special, const Draw& draw, int node);
/// Whether a body, or an expression in it, asks which pixel it computes.
bool names_pixels(const GlslText& text);
bool names_pixels(std::string_view text);
/// Which draws the device leaves out where nothing is bright.
Conditions find_conditions(const Specialised& special, const Encoding& encoding, const Draws& draws, const Order& order,
                           const CompileOptions& options);
std::vector<Lifetime> find_lifetimes(const TypedGraph& graph, const Encoding& encoding, const Draws& draws,
                                     const Order& order);
Slots allocate(const TypedGraph& graph, const Encoding& encoding, const std::vector<Lifetime>& lifetimes,
               bool is_shared);
Plan lower(const Specialised& special, const Encoding& encoding, const Draws& draws, const Order& order,
           const Conditions& conditions, const Slots& slots, const CompileOptions& options);

/// What a draw writes: where its stored images stand, and geometry's depth buffer.
std::set<TargetRef> targets_of(const Encoding& encoding, const Draw& draw);
/// The images that stand in a target, for people: "surface.normal + surface.atlas_uv".
std::string target_name(const TypedGraph& graph, const Encoding& encoding, TargetRef target);

/// The layout that a node's pass is drawn with; nullptr when its pass has none.
const Layout* layout_of(const GraphNode& node);

/// The images of other draws, pictures and cubes that a draw reads: each with the port that reads it.
struct ExternalRead {
    ImageRef image;
    int node = 0; ///< the reader
    int port = 0;
};
std::vector<ExternalRead> external_reads(const TypedGraph& graph, const std::vector<int>& nodes);

} // namespace passgraph::compiler
