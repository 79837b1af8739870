// Composites: a graph file with ports, declared like a pass and expanded where it is used.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/graph_settings.hpp"
#include "core/pass/header_fields.hpp"
#include "passgraph/core/graph_file.hpp"

namespace passgraph {
namespace {

template <class Ports>
std::vector<std::string> names_of(const Ports& ports)
{
    std::vector<std::string> names;
    for (const auto& port : ports)
        names.push_back(port.name);
    return names;
}

void declare_ports(PassDeclaration& pass, const GraphDescription& description, const Graph& inside)
{
    for (const auto& input : description.inputs) {
        InputPort port{};
        port.name = input.name;
        port.signal = input.signal;
        port.where = input.where;
        port.is_optional = input.is_optional;
        port.over = input.kind == GraphNode::Kind::cube    ? Over::sphere
                    : input.kind == GraphNode::Kind::scene ? Over::scene
                                                           : Over::image;
        pass.inputs.push_back(std::move(port));
    }
    for (const GraphOutput& output : inside.outputs()) {
        OutputPort port;
        port.name = output.name;
        port.where = output.where;
        const GraphNode& node = inside.nodes()[static_cast<size_t>(output.from.node)];
        port.signal = node.kind == GraphNode::Kind::pass
                          ? node.pass->outputs[static_cast<size_t>(output.from.output)].signal
                          : node.signal;
        pass.outputs.push_back(std::move(port));
    }
}

/// A routed setting takes its declaration from the first place it leads to, and its default from the value there.
void declare_settings(PassDeclaration& pass, const GraphDescription& description, const Graph& inside)
{
    for (const GraphParam& route : description.params) {
        const std::vector<std::string> places = inside.places_of(route.name);
        if (places.empty())
            continue;
        const size_t dot = places.front().rfind('.');
        const GraphNode& node = inside.nodes()[static_cast<size_t>(inside.find_node(places.front().substr(0, dot)))];
        const std::string setting = places.front().substr(dot + 1);
        if (const int param = node.pass->find_param(setting); param >= 0) {
            Param declared = node.pass->params[static_cast<size_t>(param)];
            declared.name = route.name;
            declared.default_value = node.params[static_cast<size_t>(param)];
            declared.is_static = node.is_static[static_cast<size_t>(param)];
            pass.params.push_back(std::move(declared));
        } else {
            const auto selection = static_cast<size_t>(node.pass->find_selection(setting));
            Selection declared = node.pass->selections[selection];
            declared.name = route.name;
            declared.default_item = node.selections[selection];
            pass.selections.push_back(std::move(declared));
        }
    }
}

} // namespace

namespace {

/// True when expanding the description's passes would come upon `name`, which would never end.
bool expands_to(const GraphDescription& description, std::string_view name, const PassLibrary& library,
                std::set<std::string>& seen)
{
    return std::any_of(description.passes.begin(), description.passes.end(), [&](const GraphDescription::Pass& use) {
        if (use.pass.text == name)
            return true;
        const PassPtr pass = library.find(use.pass.text);
        return pass && pass->composite && seen.insert(use.pass.text).second &&
               expands_to(*pass->composite, name, library, seen);
    });
}

} // namespace

Result<PassPtr> declare_composite(std::shared_ptr<const GraphDescription> description, const std::string& family,
                                  const PassLibrary& library)
{
    if (description->composite_name.empty())
        return fail(
            {"not_a_composite", "the file lacks \"pass\": the name of the composite", "", {description->file, 1, 1}});
    if (std::set<std::string> seen; expands_to(*description, description->composite_name, library, seen))
        return fail({"cycle",
                     fmt::format("the composite `{}` is made of itself", description->composite_name),
                     "give the composite another name, or use another pass inside",
                     {description->file, 1, 1}});
    const Graph inside = build_graph(*description, library);
    if (!inside.errors().empty())
        return tl::unexpected(inside.errors());
    auto pass = std::make_shared<PassDeclaration>();
    pass->name = description->composite_name;
    pass->family = family;
    pass->summary = description->summary;
    pass->source = description->source;
    pass->file = description->file;
    declare_ports(*pass, *description, inside);
    declare_settings(*pass, *description, inside);
    Errors errors;
    if (description->contract)
        header::read_contract(*description->contract, *pass, errors);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    pass->composite = std::move(description);
    return PassPtr(std::move(pass));
}

namespace {

using NamedImage = std::pair<std::string, ImageRef>;

/// Reports what a use of a composite gets wrong about its ports; returns the image wired to each.
std::vector<NamedImage> match_inputs(const PassDeclaration& pass, const PassArguments& arguments, Graph& graph)
{
    std::vector<NamedImage> images;
    for (const PassArguments::Input& input : arguments.inputs) {
        if (pass.find_input(input.name) >= 0)
            images.emplace_back(input.name, input.image.ref());
        else
            graph.report({"unknown_input",
                          fmt::format("{} ({}) has no input `{}`", arguments.name, pass.name, input.name),
                          suggest(input.name, names_of(pass.inputs), "inputs"), input.where});
    }
    for (const InputPort& port : pass.inputs) {
        if (std::any_of(images.begin(), images.end(),
                        [&](const NamedImage& image) { return image.first == port.name; }))
            continue;
        if (!port.is_optional)
            graph.report({"input_missing",
                      fmt::format("{} ({}): the input `{}` is not wired", arguments.name, pass.name, port.name),
                      fmt::format("wire an image of signal {} to it", info(port.signal).name), arguments.where});
        images.emplace_back(port.name, ImageRef{});
    }
    return images;
}

/// Sets what a use of a composite asks for on the inner graph, through the composite's routes.
void route_settings(const PassDeclaration& pass, const PassArguments& arguments, Graph& inside, Errors& errors)
{
    GraphNode outer; // checks names and values against the composite's own declaration
    outer.name = arguments.name;
    outer.pass = std::shared_ptr<const PassDeclaration>(std::shared_ptr<const PassDeclaration>(), &pass);
    for (const Param& param : pass.params)
        outer.params.push_back(param.default_value);
    for (const Selection& selection : pass.selections)
        outer.selections.push_back(selection.default_item);
    for (const PassArguments::Setting& setting : arguments.settings) {
        const size_t before = errors.size();
        apply_setting(outer, setting, errors);
        if (errors.size() > before)
            continue;
        if (auto set = inside.set(setting.name, setting); !set)
            errors.insert(errors.end(), set.error().begin(), set.error().end());
    }
}

/// Stores the composite's outputs as its use asks; an output that is an input handed through is not stored here.
void route_codecs(const PassDeclaration& pass, const PassArguments& arguments, const std::vector<NamedImage>& outputs,
                  std::vector<GraphNode>& nodes, Errors& errors)
{
    for (const PassArguments::Setting& codec : arguments.codecs) {
        const int output = pass.find_output(codec.name);
        if (output < 0) {
            errors.push_back({"unknown_image",
                              fmt::format("{} ({}) has no output `{}`", arguments.name, pass.name, codec.name),
                              suggest(codec.name, names_of(pass.outputs), "outputs"), codec.where});
            continue;
        }
        const ImageRef image = outputs[static_cast<size_t>(output)].second;
        if (image.node < 0 || !nodes[static_cast<size_t>(image.node)].pass)
            continue;
        GraphNode& node = nodes[static_cast<size_t>(image.node)];
        PassArguments::Setting inner = codec;
        inner.name = node.pass->outputs[static_cast<size_t>(image.output)].name;
        apply_codec(node, inner, errors);
    }
}

/// Folds those parameters of an inner node to which a static setting of the composite leads.
void fold_statics(GraphNode& node, const PassArguments& arguments, const Graph& inside)
{
    for (const auto& [name, where] : arguments.statics)
        for (const std::string& place : inside.places_of(name))
            if (place.substr(0, place.rfind('.')) == node.name)
                if (const int param = node.pass->find_param(place.substr(place.rfind('.') + 1)); param >= 0)
                    node.is_static[static_cast<size_t>(param)] = true;
}

void check_statics(const PassDeclaration& pass, const PassArguments& arguments, Graph& graph)
{
    for (const auto& [name, where] : arguments.statics)
        if (pass.find_param(name) < 0)
            graph.report({"unknown_param",
                          fmt::format("{} ({}) has no parameter `{}`", arguments.name, pass.name, name),
                          suggest(name, names_of(pass.params), "parameters"), where});
}

/// Where the images of a composite's inside are in the graph that uses it.
struct Expansion {
    const PassDeclaration& pass;
    const Graph& inside;
    const std::vector<GraphNode>& around;  ///< of the graph that uses it
    const std::vector<NamedImage>& images; ///< wired to the ports
    std::vector<int> moved;                ///< by inner node: its index outside, -1 while it has none

    const GraphNode& inner(ImageRef image) const { return inside.nodes()[static_cast<size_t>(image.node)]; }

    ImageRef outside(ImageRef image) const
    {
        if (image.node < 0)
            return image;
        if (inner(image).kind == GraphNode::Kind::pass)
            return {moved[static_cast<size_t>(image.node)], image.output};
        for (const auto& [name, wired] : images) {
            if (name != inner(image).name)
                continue;
            const bool is_scene = inner(image).kind == GraphNode::Kind::scene && wired.node >= 0 &&
                                  around[static_cast<size_t>(wired.node)].kind == GraphNode::Kind::scene;
            return is_scene ? ImageRef{wired.node, image.output} : wired; // a scene's sky is the outer scene's
        }
        return {};
    }

    /// True for an optional port to which nothing is wired.
    bool is_left_out(ImageRef image) const
    {
        const int port = inner(image).kind == GraphNode::Kind::pass ? -1 : pass.find_input(inner(image).name);
        return port >= 0 && pass.inputs[static_cast<size_t>(port)].is_optional && outside(image).node < 0;
    }
};

/// Where a use wires the port that an inner node stands for; the use itself for what it does not wire.
Location place_of_wire(const PassArguments& arguments, const GraphNode& inner)
{
    for (const PassArguments::Input& input : arguments.inputs)
        if (inner.kind != GraphNode::Kind::pass && input.name == inner.name)
            return input.where;
    return arguments.where;
}

/// Parameters that the composite routes are known by its own name for them, the others by their place inside.
void publish_params(GraphNode& node, const std::string& composite, const Graph& inside)
{
    std::vector<std::string> places;
    for (size_t i = 0; i < node.params.size(); ++i) {
        const std::string place = node.place_of(i);
        const auto route = std::find_if(inside.params().begin(), inside.params().end(), [&](const GraphParam& param) {
            return std::find(param.places.begin(), param.places.end(), place) != param.places.end();
        });
        places.push_back(fmt::format("{}.{}", composite, route == inside.params().end() ? place : route->name));
    }
    node.public_places = std::move(places);
}

} // namespace

AddedPass Graph::add_composite(const PassPtr& pass, PassArguments arguments)
{
    Graph inside = build_graph(*pass->composite, *library_);
    const std::vector<NamedImage> images = match_inputs(*pass, arguments, *this);
    route_settings(*pass, arguments, inside, errors_);
    check_statics(*pass, arguments, *this);
    if (arguments.scale || arguments.size_of)
        report({"scale_on_composite",
                fmt::format("{} ({}) is a composite: its passes choose their extents", arguments.name, pass->name),
                "scale its input instead, with a pass such as downsample", arguments.where});

    Expansion expansion{*pass, inside, nodes_, images, std::vector<int>(inside.nodes().size(), -1)};
    for (size_t i = 0; i < inside.nodes().size(); ++i) {
        GraphNode node = inside.nodes()[i];
        if (node.kind != GraphNode::Kind::pass)
            continue;
        for (auto& wire : node.inputs)
            if (wire)
                wire = expansion.is_left_out(wire->from)
                           ? std::nullopt
                           : std::optional(Wire{expansion.outside(wire->from), place_of_wire(arguments, expansion.inner(wire->from))});
        if (node.size_of)
            node.size_of = expansion.outside(*node.size_of);
        fold_statics(node, arguments, inside);
        publish_params(node, arguments.name, inside);
        node.name = fmt::format("{}.{}", arguments.name, node.name);
        node.where = arguments.where; // what is wrong with it now is the use's fault: inside it was checked
        expansion.moved[i] = static_cast<int>(nodes_.size());
        nodes_.push_back(std::move(node));
    }

    std::vector<NamedImage> outputs;
    for (const GraphOutput& output : inside.outputs())
        outputs.emplace_back(output.name, expansion.outside(output.from));
    route_codecs(*pass, arguments, outputs, nodes_, errors_);
    // The settings of a composite stay settable under its own name.
    for (const GraphParam& route : inside.params()) {
        GraphParam outer{.name = arguments.name + "." + route.name, .places = {}, .where = arguments.where};
        for (const std::string& place : route.places)
            outer.places.push_back(arguments.name + "." + place);
        params_.push_back(std::move(outer));
    }
    composites_.emplace_back(arguments.name, outputs);
    return AddedPass(*this, std::move(outputs), arguments.name);
}

} // namespace passgraph
