// Draws that the device itself leaves out: an occlusion query counts the pixels of one draw that are not black, and what
// follows from black alone is drawn only if there are any.  No value is read back, so no frame waits for the host.
//
// Proof that no bit changes.  A counting draw clears its targets to the code of 0 and discards the pixels whose stored values
// all are 0: the others are drawn as ever.  If none was drawn, its images are 0 everywhere, and so, by the declarations of
// the passes in between, is every image that `blackened_by` finds.  A conditional draw stores only such images and is cleared
// first; a draw in two variants sees only such images as the constant 0.
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

/// A value of 0 comes out of the guard as +0.  Others might keep the sign of a zero, or make something else of it.
bool keeps_black(const TypedImage& image) { return info(image.signal).guard == Guard::zero_to_cap; }

/// The input that an output's alpha is carried from; -1: it has none, or computes it.
int alpha_input(const TypedGraph& graph, int node, int output)
{
    const PassDeclaration& pass = *graph.node(node).pass;
    if (pass.outputs[static_cast<size_t>(output)].signal != Signal::color || !info(graph.image({node, output}).signal).has_alpha)
        return -1;
    const auto port = std::find_if(pass.inputs.begin(), pass.inputs.end(), [](const InputPort& p) { return p.signal == Signal::color; });
    return static_cast<int>(port - pass.inputs.begin());
}

} // namespace

/// Without guards a stored 0 may have a sign, which a cleared one has not.
bool may_skip_at_all(const CompileOptions& options)
{
    return options.skipping == Skipping::as_needed && options.specialise && options.guards;
}

bool may_skip(const TypedGraph& graph, int node)
{
    return graph.is_pass(node) && !graph.node(node).pass->skip_when.empty() && keeps_black(graph.image({node, 0}));
}

bool stores_only(const TypedGraph& graph, const Encoding& encoding, const Draw& draw, const Images& images)
{
    return graph.node(draw.nodes.front()).pass->kind == PassKind::image &&
           std::all_of(draw.stored.begin(), draw.stored.end(), [&](ImageRef image) {
               return images.contains(image) && encoding.of(image).codec.packing == Packing::plain;
           });
}

/// Producers come first, so one sweep is enough.
Images blackened_by(const Specialised& special, Images black)
{
    const TypedGraph& graph = special.graph;
    const auto is_black = [&](int node, int input) {
        const auto& wire = graph.node(node).inputs[static_cast<size_t>(input)];
        return wire ? black.contains(wire->from) : special.black_inputs.contains({node, input});
    };
    for (int node = 0; node < graph.node_count(); ++node) {
        for (int output = 0; graph.is_pass(node) && output < static_cast<int>(graph.images[static_cast<size_t>(node)].size()); ++output) {
            const std::vector<int>& inputs = graph.node(node).pass->black_inputs(output);
            const int alpha = alpha_input(graph, node, output);
            const bool follows = !inputs.empty() && keeps_black(graph.image({node, output})) &&
                                 std::all_of(inputs.begin(), inputs.end(), [&](int input) { return is_black(node, input); }) &&
                                 (alpha < 0 || is_black(node, alpha));
            if (follows)
                black.insert({node, output});
        }
    }
    return black;
}

namespace {

class Search {
public:
    Search(const Specialised& special, const Encoding& encoding, const Draws& draws, const Order& order)
        : special_(special), graph_(special.graph), encoding_(encoding), draws_(draws), order_(order)
    {
        result_.of_draw.resize(draws.draws.size());
    }

    Conditions run()
    {
        for (int node = 0; node < graph_.node_count(); ++node)
            if (may_skip(graph_, node) && draws_.draw_of[static_cast<size_t>(node)] >= 0)
                find_counting(node);
        for (size_t time = 0; time < order_.size(); ++time)
            if (Condition& condition = condition_at(time); condition.skipped_by >= 0 && condition.black_inputs.empty())
                condition.is_cleared = is_read_when_left_out(time);
        return std::move(result_);
    }

private:
    /// Whether anybody looks at a conditional draw's images though it was left out: the host, or a draw that neither is left out
    /// with it nor takes them for 0.
    bool is_read_when_left_out(size_t conditional)
    {
        const std::vector<ImageRef>& stored = draw_at(conditional).stored;
        const auto is_stored = [&](ImageRef image) { return std::find(stored.begin(), stored.end(), image) != stored.end(); };
        if (std::any_of(graph_.outputs.begin(), graph_.outputs.end(), [&](const GraphOutput& output) { return is_stored(output.from); }))
            return true;
        for (size_t time = conditional + 1; time < order_.size(); ++time) {
            const Condition& reader = condition_at(time);
            const bool knows = reader.skipped_by == condition_at(conditional).skipped_by;
            for (const ExternalRead& read : external_reads(graph_, draw_at(time).nodes))
                if (is_stored(read.image) && !(knows && (reader.black_inputs.empty() || reader.black_inputs.contains(read.image))))
                    return true;
        }
        return false;
    }

    const Draw& draw_at(size_t time) const { return draws_.draws[static_cast<size_t>(order_[time])]; }
    Condition& condition_at(size_t time) { return result_.of_draw[static_cast<size_t>(order_[time])]; }

    /// The first draw that is black when the pass is: the earlier, the more is left out. Then others that do not follow from it.
    void find_counting(int node)
    {
        const Images black = blackened_by(special_, {{node, 0}});
        for (size_t time = 0; time < order_.size(); ++time)
            if (condition_at(time).is_free() && stores_only(graph_, encoding_, draw_at(time), black))
                find_dependent(time, node);
    }

    /// Of what is 0 everywhere when the counting draw draws no pixel. `node`: the pass that it is black with.
    void find_dependent(size_t counting, int node)
    {
        const std::vector<ImageRef>& counted = draw_at(counting).stored;
        const Images black = blackened_by(special_, {counted.begin(), counted.end()});
        const int query = static_cast<int>(result_.counted.size());
        bool has_any = false;
        for (size_t time = counting + 1; time < order_.size(); ++time) {
            const Draw& draw = draw_at(time);
            Condition& condition = condition_at(time);
            if (!condition.is_free() || graph_.node(draw.nodes.front()).pass->kind != PassKind::image)
                continue;
            const bool is_conditional = stores_only(graph_, encoding_, draw, black);
            if (!is_conditional && !draw.tested_depth) // two parts of two variants each would be four programs
                for (const ExternalRead& read : external_reads(graph_, draw.nodes))
                    if (black.contains(read.image))
                        condition.black_inputs.insert(read.image);
            if (is_conditional || !condition.black_inputs.empty()) {
                condition.skipped_by = query;
                has_any = true;
            }
        }
        if (!has_any)
            return;
        condition_at(counting).counts = query;
        condition_at(counting).scout = find_scout(special_, draw_at(counting), node);
        std::vector<std::string> names;
        for (const ImageRef image : counted)
            names.push_back(graph_.name(image));
        result_.counted.push_back(fmt::format("{}", fmt::join(names, " and ")));
    }

    const Specialised& special_;
    const TypedGraph& graph_;
    const Encoding& encoding_;
    const Draws& draws_;
    const Order& order_;
    Conditions result_;
};

} // namespace

Conditions find_conditions(const Specialised& special, const Encoding& encoding, const Draws& draws, const Order& order,
                           const CompileOptions& options)
{
    if (!may_skip_at_all(options))
        return {std::vector<Condition>(draws.draws.size()), {}};
    return Search(special, encoding, draws, order).run();
}

} // namespace passgraph::compiler
