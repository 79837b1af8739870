// Small draws that look whether there is anything to draw.
//
// A draw that counts its pixels has read and averaged everything before it knows that all are black.  Its scout knows that for
// half of the time: a pixel for 8 x 8 texels, which asks the pass's own condition at each, or whether the texels are 0.  Where
// something is bright that would be spent for nothing, so a scout is sent out only after a frame in which nothing was counted, if
// the device has said so by then: most frames are like the one before.  Nobody waits for that, and no picture depends on it.
//
// Proof that no bit changes.  Where the condition holds at all texels that a pass reads, the pass is 0 at all of its own, by
// `only_value`; and where it or the images that a draw reads are 0, the draw stores only 0, by what passes declare to hand on.
#include <algorithm>

#include <fmt/format.h>

#include "core/compiler/ir.hpp"
#include "core/glsl/assemble.hpp"

namespace passgraph::compiler {
namespace {

constexpr int kBlock = 8; // 14,400 pixels for 1280x720: their own time is a tenth of that of the texels

int divided_up(int a, int b) { return (a + b - 1) / b; }

/// The extent of a scout: not beyond that of its draw, in whose targets it has its place.
Extent extent_over(Extent texels, Extent drawn)
{
    return {std::min(divided_up(texels.width, kBlock), drawn.width), std::min(divided_up(texels.height, kBlock), drawn.height)};
}

/// Completes a pass of which a function "bool passgraph_is_black(vec2 uv)" is given, and whose inputs are all of one extent.
PassPtr block_pass(PassDeclaration pass, std::string_view is_black, Extent texels, Extent extent)
{
    const int width = divided_up(texels.width, extent.width);
    const int height = divided_up(texels.height, extent.height);
    OutputPort mask;
    mask.name = "mask";
    mask.signal = Signal::mask;
    pass.outputs = {mask};
    pass.name = "passgraph_scout";
    // Rows end where nobody knows beforehand: llvmpipe is slower by a half where Mesa unrolls all 64 texels.
    pass.body.text += fmt::format(R"({0}
float {1}(vec2 uv)
{{
    ivec2 first = ivec2({3}, {4}) * pixel();
    ivec2 end = min(first + ivec2({3}, {4}), {2}_size());
    bool found = false;
    for (int y = first.y; y < end.y && !found; ++y)
        for (int x = 0; x < {3}; ++x) {{
            passgraph_texel = ivec2({5}, y);
            found = !passgraph_is_black((vec2(passgraph_texel) + 0.5) * {2}_texel()) || found;
        }}
    return found ? 1.0 : 0.0;
}}
)",
                                  is_black, pass.name, pass.inputs.front().name, width, height,
                                  width * extent.width == texels.width ? "first.x + x" : "min(first.x + x, end.x - 1)");
    pass.body.globals.insert(pass.body.globals.end(), {pass.name, "passgraph_is_black"});
    return std::make_shared<const PassDeclaration>(std::move(pass));
}

PassPtr image_pass(const std::vector<Signal>& signals, Extent texels, Extent extent)
{
    PassDeclaration pass;
    pass.body.file = "generated";
    std::string all;
    for (const Signal signal : signals) {
        const std::string name = fmt::format("image_{}", pass.inputs.size());
        pass.inputs.push_back({.name = name, .signal = signal});
        all += fmt::format("{}{}(uv) == {}(0.0)", all.empty() ? "" : " && ", name, glsl_type(info(signal).components));
    }
    return block_pass(std::move(pass), fmt::format("bool passgraph_is_black(vec2 uv) {{ return {}; }}", all), texels, extent);
}

/// The pass's condition, in the scope of its body.
PassPtr condition_pass(const PassDeclaration& asked, Extent texels, Extent extent)
{
    PassDeclaration pass;
    pass.inputs = asked.inputs;
    pass.params = asked.params;
    pass.selections = asked.selections;
    pass.reads = asked.reads;
    pass.body = asked.body;
    pass.body.globals.emplace_back(glsl::kSkips);
    return block_pass(std::move(pass),
                      fmt::format("\n#line {}\n{}bool passgraph_is_black(vec2 uv) {{ return {}(uv); }}", asked.skip_where.line,
                                  glsl::skip_text(asked).text, glsl::kSkips),
                      texels, extent);
}

bool is_inside(const Draw& draw, int node) { return std::find(draw.nodes.begin(), draw.nodes.end(), node) != draw.nodes.end(); }

/// Whether a pass of the draw may be asked anywhere: it looks at stored texels alone, each where it is itself.
bool may_be_asked(const TypedGraph& graph, const Draw& draw, int node)
{
    const GraphNode& asked = graph.node(node);
    const PassDeclaration& pass = *asked.pass;
    if (asked.inputs.empty() || names_pixels(pass.body) || names_pixels(pass.skip_when))
        return false;
    for (size_t i = 0; i < asked.inputs.size(); ++i) {
        const auto& wire = asked.inputs[i];
        const InputPort& port = pass.inputs[i];
        if (!wire || is_inside(draw, wire->from.node) || port.has_levels || port.access.kind != AccessClass::pointwise ||
            !(graph.image(wire->from).extent == graph.image({node, 0}).extent))
            return false;
    }
    return true;
}

} // namespace

std::optional<Scout> find_scout(const Specialised& special, const Draw& draw, int node)
{
    const TypedGraph& graph = special.graph;
    if (draw.tested_depth)
        return std::nullopt;
    const Extent drawn = graph.image(draw.stored.front()).extent;
    if (is_inside(draw, node)) {
        if (!may_be_asked(graph, draw, node))
            return std::nullopt;
        const Extent texels = graph.image({node, 0}).extent;
        const Extent extent = extent_over(texels, drawn);
        return Scout{condition_pass(*graph.node(node).pass, texels, extent), node, {}, extent};
    }
    const Images black = blackened_by(special, {{node, 0}});
    Images images;
    for (const ExternalRead& read : external_reads(graph, draw.nodes))
        if (black.contains(read.image))
            images.insert(read.image);
    if (images.empty())
        return std::nullopt;
    const Extent texels = graph.image(*images.begin()).extent;
    if (std::any_of(images.begin(), images.end(), [&](ImageRef image) { return !(graph.image(image).extent == texels); }))
        return std::nullopt;
    std::vector<Signal> signals;
    for (const ImageRef image : images)
        signals.push_back(graph.image(image).signal);
    const Extent extent = extent_over(texels, drawn);
    return Scout{image_pass(signals, texels, extent), -1, {images.begin(), images.end()}, extent};
}

} // namespace passgraph::compiler
