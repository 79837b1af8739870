// Where the pixels of a pass that may be black are counted, when no draw along its chain does that for nothing.
//
// A pass with "skip" that shares its draw with passes that are not black cannot discard pixels there, and the next draw of its
// chain reads every texel before it knows.  So the draw stores one byte more per pixel, whether it is black, and a small draw
// counts over blocks of 8 x 8: an eighth of what that next draw costs.
#include <algorithm>

#include "core/compiler/ir.hpp"
#include "core/graph_settings.hpp"

namespace passgraph::compiler {
namespace {

constexpr int kBlock = 8; // sixteen linear taps of four texels each, a read of an eighth of the texels in each direction

OutputPort mask_output(Ratio scale)
{
    OutputPort port;
    port.name = "mask";
    port.signal = Signal::mask;
    port.size_of = "image";
    port.scale = scale;
    return port;
}

PassPtr mask_pass(Signal signal)
{
    PassDeclaration pass;
    pass.name = "not_black";
    pass.inputs.push_back({.name = "image", .signal = signal, .access = {AccessClass::pointwise, 0}});
    pass.outputs.push_back(mask_output({}));
    pass.body.file = "generated";
    const std::string type(glsl_type(info(signal).components));
    pass.body.text = "float not_black(vec2 uv) { return image(uv) == " + type + "(0.0) ? 0.0 : 1.0; }\n";
    pass.body.globals = {pass.name};
    return std::make_shared<const PassDeclaration>(std::move(pass));
}

/// Taps on the corners between four texels, found by the pixel's index: no rounding makes them miss a texel.
PassPtr block_pass()
{
    PassDeclaration pass;
    pass.name = "anything_in_block";
    pass.inputs.push_back({.name = "image", .signal = Signal::mask, .filter = Filter::linear, .access = {AccessClass::gather, kBlock}});
    pass.outputs.push_back(mask_output({1, kBlock}));
    pass.body.file = "generated";
    pass.body.text = "float anything_in_block(vec2 uv)\n{\n    float sum = 0.0;\n"
                     "    for (int y = 1; y < 8; y += 2)\n        for (int x = 1; x < 8; x += 2)\n"
                     "            sum += image(vec2(8 * pixel() + ivec2(x, y)) * image_texel());\n    return sum;\n}\n";
    pass.body.globals = {pass.name};
    return std::make_shared<const PassDeclaration>(std::move(pass));
}

/// Passes whose chain has a draw that is black when they are, but not their own.
std::set<int> find_watched(const Specialised& special, const CompileOptions& options)
{
    const TypedGraph& graph = special.graph;
    std::set<int> watched;
    const Encoding encoding = encode(graph);
    const Draws draws = fuse(graph, encoding, cull(special, graph, options.cull), options);
    for (int node = 0; node < graph.node_count(); ++node) {
        if (!may_skip(graph, node) || draws.draw_of[static_cast<size_t>(node)] < 0)
            continue;
        const Images black = blackened_by(special, {{node, 0}});
        const auto is_black = [&](const Draw& draw) { return stores_only(graph, encoding, draw, black); };
        const Draw& own = draws.draws[static_cast<size_t>(draws.draw_of[static_cast<size_t>(node)])];
        if (!is_black(own) && std::any_of(draws.draws.begin(), draws.draws.end(), is_black))
            watched.insert(node);
    }
    return watched;
}

/// Copies a graph node by node, and puts the two passes behind each that is watched.
class Insertion {
public:
    Insertion(const Specialised& special, const std::set<int>& watched)
        : special_(special), graph_(special.graph), watched_(watched)
    {
        result_.outputs = graph_.outputs;
        result_.library = graph_.library;
    }

    Specialised run()
    {
        for (int index = 0; index < graph_.node_count(); ++index) {
            GraphNode node = graph_.node(index);
            for (auto& wire : node.inputs)
                if (wire)
                    wire->from = moved(wire->from);
            if (node.size_of)
                node.size_of = moved(*node.size_of);
            moved_.push_back(append(std::move(node), graph_.images[static_cast<size_t>(index)]));
            if (watched_.contains(index))
                watch({moved_.back(), 0});
        }
        for (GraphOutput& output : result_.outputs)
            output.from = moved(output.from);
        Specialised result{std::move(result_), {}, special_.decisions};
        for (const auto& [input, extent] : special_.black_inputs)
            result.black_inputs[{moved_[static_cast<size_t>(input.first)], input.second}] = extent;
        return result;
    }

private:
    ImageRef moved(ImageRef image) const { return {moved_[static_cast<size_t>(image.node)], image.output}; }

    int append(GraphNode node, std::vector<TypedImage> images)
    {
        result_.nodes.push_back(std::move(node));
        result_.images.push_back(std::move(images));
        return static_cast<int>(result_.nodes.size()) - 1;
    }

    int append_reader(const PassPtr& pass, const std::string& name, ImageRef of, Extent extent)
    {
        const Location where = result_.node(of.node).where;
        GraphNode node = node_of(pass, name, where);
        node.inputs[0] = Wire{of, where};
        return append(std::move(node), {{Signal::mask, Over::image, extent}});
    }

    void watch(ImageRef image)
    {
        const TypedImage typed = result_.image(image);
        const std::string name = result_.node(image.node).name;
        const auto blocks = [](int texels) { return (texels + kBlock - 1) / kBlock; };
        const int mask = append_reader(mask_pass(typed.signal), name + ".not_black", image, typed.extent);
        const int counter = append_reader(block_pass(), name + ".anything", {mask, 0},
                                          {blocks(typed.extent.width), blocks(typed.extent.height)});
        result_.watches.push_back({image, counter});
    }

    const Specialised& special_;
    const TypedGraph& graph_;
    const std::set<int>& watched_;
    TypedGraph result_;
    std::vector<int> moved_; ///< by old node
};

} // namespace

Specialised watch(const Specialised& special, const CompileOptions& options)
{
    const std::set<int> watched = may_skip_at_all(options) ? find_watched(special, options) : std::set<int>{};
    return watched.empty() ? special : Insertion(special, watched).run();
}

} // namespace passgraph::compiler
