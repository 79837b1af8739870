// Calls instead of fetches: passes that read one another at their own pixel become one draw.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/compiler/ir.hpp"

namespace passgraph::compiler {
namespace {

/// Grows draws by merging the draw of a reader with the draw of what it reads, edge by edge in declaration order.
class Fusion {
public:
    Fusion(const TypedGraph& graph, const Encoding& encoding, const Liveness& live, const CompileOptions& options)
        : graph_(graph), encoding_(encoding), options_(options), draw_of_(static_cast<size_t>(graph.node_count()), -1)
    {
        for (int node = 0; node < graph.node_count(); ++node) {
            if (live.is_live[static_cast<size_t>(node)] && graph.is_pass(node)) {
                draw_of_[static_cast<size_t>(node)] = static_cast<int>(members_.size());
                members_.push_back({node});
            }
        }
    }

    /// A pass whose only reader looks at each of its texels about once need not be stored: it is computed where the reader looks.
    void call_what_may()
    {
        if (!options_.fuse)
            return;
        for_each_edge([&](ImageRef image, int reader, int port) {
            const InputPort& input = graph_.node(reader).pass->inputs[static_cast<size_t>(port)];
            const bool may_call = input.is_visited_once && input.over == Over::image && input.wrap == AddressMode::clamp && !input.has_levels;
            const int a = draw_of(image.node);
            const int b = draw_of(reader);
            if (may_call && !called_.contains(reader) && may_be_called(image) && why_not_fit(a, b).empty()) {
                called_.emplace(image.node, reader);
                merge(a, b);
            }
        });
    }

    void merge_what_may()
    {
        if (!options_.fuse)
            return;
        // A merge may free what stood in another's way (a texture that both read counts once), so try until none is left.
        bool is_changed = true;
        while (is_changed) {
            is_changed = false;
            for_each_edge([&](ImageRef image, int reader, int) {
                const int a = draw_of(image.node);
                const int b = draw_of(reader);
                if (a == b || !why_not(a, b).empty())
                    return;
                merge(a, b);
                is_changed = true;
            });
        }
    }

    Draws result() const
    {
        Draws result;
        result.draw_of.assign(draw_of_.size(), -1);
        for (const std::vector<int>& nodes : members_) {
            if (nodes.empty())
                continue;
            for (const int node : nodes)
                result.draw_of[static_cast<size_t>(node)] = static_cast<int>(result.draws.size());
            result.draws.push_back({.nodes = nodes, .stored = stored_images(nodes)});
            for (const int node : nodes)
                if (called_.contains(node))
                    result.draws.back().called.insert(node);
        }
        std::set<std::pair<std::string, std::string>> seen;
        for_each_edge([&](ImageRef image, int reader, int) {
            const int a = draw_of(image.node);
            const int b = draw_of(reader);
            if (a != b && seen.emplace(graph_.name(image), graph_.node(reader).name).second)
                result.boundaries.push_back({graph_.name(image), graph_.node(reader).name, why_not(a, b)});
        });
        add_inlined(result);
        return result;
    }

private:
    int draw_of(int node) const { return draw_of_[static_cast<size_t>(node)]; }
    const std::vector<int>& members(int draw) const { return members_[static_cast<size_t>(draw)]; }

    /// Every edge between two drawn passes: the image, its reader, and the reader's port.
    template <class Visit>
    void for_each_edge(const Visit& visit) const
    {
        for (int reader = 0; reader < graph_.node_count(); ++reader) {
            if (draw_of(reader) < 0)
                continue;
            const auto& inputs = graph_.node(reader).inputs;
            for (size_t port = 0; port < inputs.size(); ++port)
                if (inputs[port] && draw_of(inputs[port]->from.node) >= 0)
                    visit(inputs[port]->from, reader, static_cast<int>(port));
        }
    }

    /// Whether a pass may be computed at any place: it looks at textures there, and at nothing that is bound to its own pixel.
    bool may_be_called(ImageRef image) const
    {
        const GraphNode& node = graph_.node(image.node);
        const PassDeclaration& pass = *node.pass;
        const TypedImage& typed = graph_.image(image);
        const bool is_plain = pass.kind == PassKind::image && pass.only_where == OnlyWhere::everywhere && pass.outputs.size() == 1 &&
                              !info(typed.signal).has_alpha && members(draw_of(image.node)).size() == 1 && !names_pixels(pass.body);
        if (!is_plain || node.inputs.empty())
            return false;
        for (size_t i = 0; i < node.inputs.size(); ++i) {
            const InputPort& input = pass.inputs[i];
            if (!node.inputs[i] || input.over != Over::image || input.access.kind != AccessClass::pointwise)
                return false;
            const TypedImage& read = graph_.image(node.inputs[i]->from);
            if (!(read.extent == typed.extent) || info(read.signal).has_alpha)
                return false;
        }
        int readers = 0;
        for_each_edge([&](ImageRef read, int, int) { readers += read.node == image.node; });
        const bool is_output = std::any_of(graph_.outputs.begin(), graph_.outputs.end(),
                                           [&](const GraphOutput& output) { return output.from.node == image.node; });
        return readers == 1 && !is_output;
    }

    void merge(int a, int b)
    {
        std::vector<int>& into = members_[static_cast<size_t>(std::min(a, b))];
        std::vector<int>& from = members_[static_cast<size_t>(std::max(a, b))];
        for (const int node : from)
            draw_of_[static_cast<size_t>(node)] = std::min(a, b);
        into.insert(into.end(), from.begin(), from.end());
        std::sort(into.begin(), into.end()); // declaration order: producers first
        from.clear();
    }

    /// Why the draws `a` (producer) and `b` (reader) must stay apart; "" when they may become one.
    std::string why_not(int a, int b) const
    {
        if (!options_.fuse)
            return "fusion is off";
        for (const int draw : {a, b})
            for (const int node : members(draw))
                if (graph_.node(node).pass->kind == PassKind::geometry)
                    return fmt::format("{} draws the scene's geometry", graph_.node(node).name);
        if (const std::string reason = why_not_read(a, b); !reason.empty())
            return reason;
        if (const int between = draw_between(a, b); between >= 0)
            return fmt::format("{} stands between them", graph_.node(members(between).front()).name);
        return why_not_fit(a, b);
    }

    std::string why_not_read(int a, int b) const
    {
        for (const int node : members(b))
            if (const auto caller = called_.find(node); caller != called_.end())
                return fmt::format("{} is computed where {} looks", graph_.node(node).name, graph_.node(caller->second).name);
        std::string reason;
        for_each_edge([&](ImageRef image, int reader, int port) {
            if (!reason.empty() || draw_of(image.node) != a || draw_of(reader) != b)
                return;
            const InputPort& input = graph_.node(reader).pass->inputs[static_cast<size_t>(port)];
            const bool is_at_pixel =
                input.access.kind == AccessClass::pointwise || input.access.kind == AccessClass::size_only;
            if (input.over == Over::table)
                reason = fmt::format("{}.{} reads it as a table", graph_.node(reader).name, input.name);
            else if (!is_at_pixel)
                reason =
                    fmt::format("{}.{} reads it as {}", graph_.node(reader).name, input.name, to_text(input.access));
        });
        if (!reason.empty())
            return reason;
        const Extent from = extent_of_draw(a);
        const Extent to = extent_of_draw(b);
        if (!(from == to))
            return fmt::format("extents differ: {}x{} and {}x{}", from.width, from.height, to.width, to.height);
        return "";
    }

    /// That of whatever is computed at the draw's own pixels.
    Extent extent_of_draw(int draw) const
    {
        const auto own = std::find_if(members(draw).begin(), members(draw).end(), [&](int node) { return !called_.contains(node); });
        return extent_of(*own);
    }

    /// A draw has one extent: outputs of one pass that differ keep it alone.
    Extent extent_of(int node) const
    {
        const auto& images = graph_.images[static_cast<size_t>(node)];
        return images.empty() ? options_.extent : images.front().extent;
    }

    /// A draw other than the two on a path from `a` to `b`: merging would make it wait for itself. -1: none.
    int draw_between(int a, int b) const
    {
        std::vector<int> first_hop(members_.size(), -1); // the draw by which a path leaves `a`
        bool is_changed = true;
        while (is_changed) {
            is_changed = false;
            for_each_edge([&](ImageRef image, int reader, int) {
                const int from = draw_of(image.node);
                const int to = draw_of(reader);
                if (from == to || to == a)
                    return;
                const int via = from == a ? (to == b ? -1 : to) : first_hop[static_cast<size_t>(from)];
                if (via >= 0 && first_hop[static_cast<size_t>(to)] < 0) {
                    first_hop[static_cast<size_t>(to)] = via;
                    is_changed = true;
                }
            });
        }
        return first_hop[static_cast<size_t>(b)];
    }

    std::string why_not_fit(int a, int b) const
    {
        std::vector<int> both = members(a);
        both.insert(both.end(), members(b).begin(), members(b).end());
        std::sort(both.begin(), both.end());
        std::set<std::tuple<int, int, Filter, AddressMode, bool>> textures;
        for (const ExternalRead& read : external_reads(graph_, both)) {
            const GraphNode& node = graph_.node(read.node);
            const InputPort& port = node.pass->inputs[static_cast<size_t>(read.port)];
            const Filter filter = filter_of(*node.pass, port, node.selections);
            for (const TargetRef target : encoding_.targets_of(read.image))
                textures.emplace(target.node, target.target, filter, port.wrap, port.has_levels);
        }
        constexpr int kHostBuffers = 1; // the lights
        if (static_cast<int>(textures.size()) + kHostBuffers > options_.device.max_texture_units)
            return fmt::format("together they read {} textures, the device allows {}", textures.size(),
                               options_.device.max_texture_units - kHostBuffers);
        if (const size_t targets = stored_images(both).size();
            static_cast<int>(targets) > options_.device.max_color_targets)
            return fmt::format("together they store {} images, the device allows {}", targets,
                               options_.device.max_color_targets);
        return "";
    }

    std::vector<ImageRef> stored_images(const std::vector<int>& nodes) const
    {
        const auto is_inside = [&](int node) { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); };
        std::set<ImageRef, ImageLess> stored;
        for (const GraphOutput& output : graph_.outputs)
            if (is_inside(output.from.node))
                stored.insert(output.from);
        for_each_edge([&](ImageRef image, int reader, int) {
            if (is_inside(image.node) && !is_inside(reader))
                stored.insert(image);
        });
        if (stored.empty()) // kept alive by force: it needs somewhere to draw
            stored.insert({nodes.back(), 0});
        return {stored.begin(), stored.end()};
    }

    void add_inlined(Draws& result) const
    {
        std::set<ImageRef, ImageLess> stored;
        for (const Draw& draw : result.draws)
            stored.insert(draw.stored.begin(), draw.stored.end());
        std::set<ImageRef, ImageLess> inlined;
        for_each_edge([&](ImageRef image, int, int) {
            if (!stored.contains(image) && inlined.insert(image).second)
                result.inlined.push_back(graph_.name(image));
        });
    }

    const TypedGraph& graph_;
    const Encoding& encoding_;
    const CompileOptions& options_;
    std::vector<int> draw_of_;
    std::vector<std::vector<int>> members_;
    std::map<int, int> called_; ///< nodes that are computed where their reader looks, and that reader
};

} // namespace

bool names_pixels(std::string_view text)
{
    return text.find("pixel(") != std::string_view::npos || text.find("pixel_count(") != std::string_view::npos;
}

bool names_pixels(const GlslText& text)
{
    return names_pixels(std::string_view(text.text)) ||
           std::any_of(text.includes.begin(), text.includes.end(), [](const auto& include) { return names_pixels(*include); });
}

std::vector<ExternalRead> external_reads(const TypedGraph& graph, const std::vector<int>& nodes)
{
    std::vector<ExternalRead> reads;
    for (const int node : nodes) {
        const auto& inputs = graph.node(node).inputs;
        for (size_t port = 0; port < inputs.size(); ++port) {
            if (!inputs[port] || graph.image(inputs[port]->from).over == Over::scene)
                continue;
            if (std::find(nodes.begin(), nodes.end(), inputs[port]->from.node) == nodes.end())
                reads.push_back({inputs[port]->from, node, static_cast<int>(port)});
        }
    }
    return reads;
}

Draws fuse(const TypedGraph& graph, const Encoding& encoding, const Liveness& live, const CompileOptions& options)
{
    Fusion fusion(graph, encoding, live, options);
    fusion.call_what_may();
    fusion.merge_what_may();
    return fusion.result();
}

} // namespace passgraph::compiler
