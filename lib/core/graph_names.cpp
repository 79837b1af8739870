// The names people give to images and settings of a graph, resolved.
#include <set>

#include <fmt/format.h>

#include "core/graph_settings.hpp"
#include "passgraph/core/graph.hpp"

namespace passgraph {

namespace {

/// "node.name" split at its last dot.
std::pair<std::string_view, std::string_view> split_place(std::string_view place)
{
    const size_t dot = place.rfind('.');
    return dot == std::string_view::npos ? std::pair{std::string_view(), place}
                                         : std::pair{place.substr(0, dot), place.substr(dot + 1)};
}

bool has_setting(const GraphNode& node, std::string_view name)
{
    return node.pass && (node.pass->find_param(name) >= 0 || node.pass->find_selection(name) >= 0);
}

} // namespace

std::vector<std::string> Graph::places_of(std::string_view name) const
{
    std::vector<std::string> places;
    std::set<std::string, std::less<>> seen; // params may name each other in a circle, which leads nowhere
    const auto follow = [&](const auto& self, std::string_view wanted) -> void {
        if (!seen.emplace(wanted).second)
            return;
        const auto [node_name, setting] = split_place(wanted);
        const int node = find_node(node_name);
        if (node >= 0 && has_setting(nodes_[static_cast<size_t>(node)], setting)) {
            places.emplace_back(wanted);
            return;
        }
        for (const GraphParam& param : params_)
            if (param.name == wanted)
                for (const std::string& place : param.places)
                    self(self, place);
    };
    follow(follow, name);
    return places;
}

Result<void> Graph::set(std::string_view place, const PassArguments::Setting& setting)
{
    Errors errors;
    for (const std::string& target : places_of(place)) {
        const auto [node, name] = split_place(target);
        PassArguments::Setting inner = setting;
        inner.name = std::string(name);
        apply_setting(nodes_[static_cast<size_t>(find_node(node))], inner, errors);
    }
    if (places_of(place).empty()) {
        std::vector<std::string> known;
        for (const GraphParam& param : params_)
            known.push_back(param.name);
        for (const GraphNode& node : nodes_)
            if (node.kind == GraphNode::Kind::pass)
                for (const std::string& name : setting_names(*node.pass))
                    known.push_back(node.name + "." + name);
        errors.push_back({"unknown_param", fmt::format("the graph has no setting `{}`", place),
                          suggest(place, known, "settings"), setting.where});
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

Result<void> Graph::set_codec(std::string_view image, std::string_view codec)
{
    Error why;
    const auto found = find_image(image, &why);
    if (!found)
        return fail(std::move(why));
    Errors errors;
    GraphNode& node = nodes_[static_cast<size_t>(found->node)];
    if (node.kind == GraphNode::Kind::pass) {
        PassArguments::Setting setting;
        setting.name = node.pass->outputs[static_cast<size_t>(found->output)].name;
        setting.item = std::string(codec);
        apply_codec(node, setting, errors);
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

std::optional<ImageRef> Graph::find_image(std::string_view name, Error* why) const
{
    const auto refuse = [&](std::string message, std::string hint) -> std::optional<ImageRef> {
        if (why)
            *why = {"unknown_image", std::move(message), std::move(hint)};
        return std::nullopt;
    };
    const auto pick = [&](const std::vector<std::pair<std::string, ImageRef>>& outputs, std::string_view node,
                          std::string_view port) -> std::optional<ImageRef> {
        std::vector<std::string> names;
        for (const auto& [output, image] : outputs) {
            if (output == port || (port.empty() && outputs.size() == 1))
                return image;
            names.push_back(output.empty() ? std::string(node) : fmt::format("{}.{}", node, output));
        }
        if (port.empty())
            return refuse(fmt::format("`{}` has {} outputs", node, outputs.size()), suggest("", names, "images"));
        return refuse(fmt::format("`{}` has no output `{}`", node, port),
                      suggest(fmt::format("{}.{}", node, port), names, "images"));
    };
    const auto outputs_of =
        [&](std::string_view wanted) -> std::optional<std::vector<std::pair<std::string, ImageRef>>> {
        for (const auto& [composite, outputs] : composites_)
            if (composite == wanted)
                return outputs;
        const int index = find_node(wanted);
        if (index < 0)
            return std::nullopt;
        const GraphNode& node = nodes_[static_cast<size_t>(index)];
        std::vector<std::pair<std::string, ImageRef>> outputs;
        if (node.kind == GraphNode::Kind::pass) {
            for (size_t i = 0; i < node.pass->outputs.size(); ++i)
                outputs.emplace_back(node.pass->outputs[i].name, ImageRef{index, static_cast<int>(i)});
        } else {
            outputs.emplace_back("", ImageRef{index, 0});
            for (int port = 1; node.kind == GraphNode::Kind::scene && port < kScenePorts; ++port)
                outputs.emplace_back(passgraph::name(static_cast<ScenePort>(port)), ImageRef{index, port});
        }
        return outputs;
    };
    if (const auto whole = outputs_of(name))
        return pick(*whole, name, "");
    const size_t dot = name.rfind('.');
    if (dot != std::string_view::npos)
        if (const auto outputs = outputs_of(name.substr(0, dot)))
            return pick(*outputs, name.substr(0, dot), name.substr(dot + 1));
    std::vector<std::string> known;
    for (const GraphNode& node : nodes_)
        known.push_back(node.name);
    return refuse(fmt::format("there is no image `{}`", name), suggest(name, known, "passes and inputs"));
}

} // namespace passgraph
