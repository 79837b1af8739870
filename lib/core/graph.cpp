// Building a graph: nodes, wires, outputs. Mistakes are kept, to come back all at once.
#include "passgraph/core/graph.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/graph_settings.hpp"
#include "passgraph/core/graph_file.hpp"

namespace passgraph {
namespace {

template <class Items>
std::vector<std::string> names_of(const Items& items)
{
    std::vector<std::string> names;
    for (const auto& item : items)
        names.push_back(item.name);
    return names;
}

} // namespace

AnyImage AddedPass::operator[](std::string_view output) const
{
    if (output.empty() && outputs_.size() == 1)
        return AnyImage(outputs_.front().second);
    std::vector<std::string> names;
    for (const auto& [name, image] : outputs_) {
        if (name == output)
            return AnyImage(image);
        names.push_back(name);
    }
    // A pass that could not be added was reported already.
    if (!outputs_.empty()) {
        graph_->report({"unknown_image", fmt::format("`{}` has no output `{}`", name_, output),
                        suggest(output, names, "outputs")});
    }
    return AnyImage(ImageRef{});
}

SceneInput Graph::scene(std::string name, Location where)
{
    const int index = static_cast<int>(nodes_.size());
    GraphNode node;
    node.kind = GraphNode::Kind::scene;
    node.name = free_name(std::move(name), where, true);
    node.where = std::move(where);
    nodes_.push_back(std::move(node));
    return {AnyImage(ImageRef{index, 0}), Cube<Radiance>(ImageRef{index, 1})};
}

AnyImage Graph::picture(std::string name, Signal signal, Location where)
{
    GraphNode node;
    node.kind = GraphNode::Kind::picture;
    node.name = free_name(std::move(name), where, true);
    node.signal = signal;
    node.where = std::move(where);
    nodes_.push_back(std::move(node));
    return AnyImage(ImageRef{static_cast<int>(nodes_.size()) - 1, 0});
}

AnyImage Graph::cube(std::string name, Signal signal, Location where)
{
    const AnyImage image = picture(std::move(name), signal, std::move(where));
    nodes_.back().kind = GraphNode::Kind::cube;
    return image;
}

std::string Graph::free_name(std::string wanted, const Location& where, bool is_chosen)
{
    const auto is_taken = [&](const std::string& name) {
        return find_node(name) >= 0 ||
               std::any_of(composites_.begin(), composites_.end(), [&](const auto& c) { return c.first == name; });
    };
    if (!is_taken(wanted))
        return wanted;
    if (is_chosen) {
        report({"duplicate_name", fmt::format("the name `{}` is used twice", wanted), "rename one of the two", where});
        return wanted;
    }
    int number = 2;
    while (is_taken(fmt::format("{}_{}", wanted, number)))
        ++number;
    return fmt::format("{}_{}", wanted, number);
}

AddedPass Graph::add(std::string_view pass, PassArguments arguments)
{
    const bool is_chosen = !arguments.name.empty();
    arguments.name = free_name(is_chosen ? arguments.name : std::string(pass), arguments.where, is_chosen);
    const PassPtr declaration = library_->find(pass);
    if (!declaration) {
        report({"unknown_pass", fmt::format("{}: there is no pass `{}`", arguments.name, pass),
                suggest(pass, library_->names(), "passes"), arguments.where});
        return AddedPass(*this, {}, arguments.name);
    }
    return declaration->composite ? add_composite(declaration, std::move(arguments))
                                  : add_plain(declaration, std::move(arguments));
}

AddedPass Graph::add_plain(const PassPtr& pass, PassArguments arguments)
{
    GraphNode node = node_of(pass, arguments.name, arguments.where);
    node.scale = arguments.scale;
    if (arguments.size_of)
        node.size_of = arguments.size_of->ref();
    for (const PassArguments::Input& input : arguments.inputs) {
        const int port = pass->find_input(input.name);
        if (port < 0) {
            report({"unknown_input", fmt::format("{} ({}) has no input `{}`", node.name, pass->name, input.name),
                    suggest(input.name, names_of(pass->inputs), "inputs"), input.where});
        } else {
            node.inputs[static_cast<size_t>(port)] = Wire{input.image.ref(), input.where};
        }
    }
    for (const PassArguments::Setting& setting : arguments.settings)
        apply_setting(node, setting, errors_);
    for (const auto& [name, where] : arguments.statics) {
        const int param = pass->find_param(name);
        if (param < 0) {
            report({"unknown_param", fmt::format("{} ({}) has no parameter `{}`", node.name, pass->name, name),
                    suggest(name, names_of(pass->params), "parameters"), where});
        } else {
            node.is_static[static_cast<size_t>(param)] = true;
        }
    }
    for (const PassArguments::Setting& codec : arguments.codecs)
        apply_codec(node, codec, errors_);

    const int index = static_cast<int>(nodes_.size());
    std::vector<std::pair<std::string, ImageRef>> outputs;
    for (size_t i = 0; i < pass->outputs.size(); ++i)
        outputs.emplace_back(pass->outputs[i].name, ImageRef{index, static_cast<int>(i)});
    nodes_.push_back(std::move(node));
    return AddedPass(*this, std::move(outputs), arguments.name);
}

void Graph::output(std::string name, AnyImage image, Location where)
{
    for (const GraphOutput& other : outputs_) {
        if (other.name == name)
            report({"duplicate_name", fmt::format("there are two outputs `{}`", name), "rename one of the two", where});
    }
    outputs_.push_back({std::move(name), image.ref(), std::move(where)});
}

std::string GraphNode::place_of(size_t param) const
{
    return public_places.empty() ? fmt::format("{}.{}", name, pass->params[param].name) : public_places[param];
}

int Graph::find_node(std::string_view name) const
{
    for (size_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].name == name)
            return static_cast<int>(i);
    return -1;
}

std::string_view name(ScenePort port)
{
    switch (port) {
    case ScenePort::elements:
        return "";
    case ScenePort::sky:
        return "sky";
    case ScenePort::atlas_albedo:
        return "atlas_albedo";
    case ScenePort::atlas_material:
        return "atlas_material";
    case ScenePort::atlas_emissive:
        return "atlas_emissive";
    }
    return "";
}

std::string image_name(const std::vector<GraphNode>& nodes, ImageRef image)
{
    if (image.node < 0)
        return "nothing";
    const GraphNode& node = nodes[static_cast<size_t>(image.node)];
    if (node.kind == GraphNode::Kind::scene && image.output > 0)
        return fmt::format("{}.{}", node.name, name(static_cast<ScenePort>(image.output)));
    if (node.kind != GraphNode::Kind::pass || node.pass->outputs.size() == 1)
        return node.name;
    return node.name + "." + node.pass->outputs[static_cast<size_t>(image.output)].name;
}

} // namespace passgraph
