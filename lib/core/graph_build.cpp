// Builds a graph from its description: producers first, names resolved, composites expanded.
#include <algorithm>

#include <fmt/format.h>

#include "core/graph_settings.hpp"
#include "passgraph/core/graph_file.hpp"

namespace passgraph {
namespace {

/// The pass of the description that an image name refers to, or -1: the name itself, or what stands before its last dot.
int producer_index(const GraphDescription& description, const std::string& image)
{
    const auto find = [&](std::string_view name) {
        for (size_t i = 0; i < description.passes.size(); ++i)
            if (description.passes[i].name == name)
                return static_cast<int>(i);
        return -1;
    };
    const int whole = find(image);
    const size_t dot = image.rfind('.');
    return whole >= 0 || dot == std::string::npos ? whole : find(image.substr(0, dot));
}

/// Sorts passes so that producers come before consumers, keeping the file's order where it can; a cycle is reported.
class ProducerOrder {
public:
    ProducerOrder(const GraphDescription& description, Errors& errors)
        : description_(description), errors_(errors), state_(description.passes.size(), State::unseen)
    {
        for (size_t i = 0; i < description.passes.size(); ++i)
            visit(i);
    }

    const std::vector<size_t>& order() const { return order_; }

private:
    enum class State { unseen, open, done };

    void visit(size_t pass)
    {
        if (state_[pass] != State::unseen)
            return;
        state_[pass] = State::open;
        path_.push_back(pass);
        for (const NamedPlace& image : images_of(description_.passes[pass])) {
            const int producer = producer_index(description_, image.text);
            if (producer < 0)
                continue;
            if (state_[static_cast<size_t>(producer)] == State::open)
                report_cycle(static_cast<size_t>(producer), image.where);
            else
                visit(static_cast<size_t>(producer));
        }
        path_.pop_back();
        state_[pass] = State::done;
        order_.push_back(pass);
    }

    static std::vector<NamedPlace> images_of(const GraphDescription::Pass& pass)
    {
        std::vector<NamedPlace> images;
        for (const auto& input : pass.inputs)
            images.push_back(input.image);
        if (pass.size_of)
            images.push_back(*pass.size_of);
        return images;
    }

    void report_cycle(size_t start, const Location& where)
    {
        std::vector<std::string> names;
        for (auto at = std::find(path_.begin(), path_.end(), start); at != path_.end(); ++at)
            names.push_back(description_.passes[*at].name);
        std::reverse(names.begin(), names.end()); // from producer to reader
        names.push_back(names.front());
        errors_.push_back({"cycle", fmt::format("these passes wait for each other: {}", fmt::join(names, " -> ")),
                           "a pass cannot read what depends on it: cut one of these wires", where});
    }

    const GraphDescription& description_;
    Errors& errors_;
    std::vector<State> state_;
    std::vector<size_t> path_;
    std::vector<size_t> order_;
};

/// Resolves a name while the graph grows; a pass that failed or stands in a cycle was reported already.
std::optional<AnyImage> resolve(Graph& graph, const GraphDescription& description, const NamedPlace& name)
{
    Error why;
    if (const auto image = graph.find_image(name.text, &why))
        return AnyImage(*image);
    const int producer = producer_index(description, name.text);
    if (producer >= 0 && graph.find_node(description.passes[static_cast<size_t>(producer)].name) < 0 &&
        !graph.errors().empty() && why.message.starts_with("there is no image"))
        return std::nullopt;
    why.where = name.where;
    graph.report(std::move(why));
    return std::nullopt;
}

void add_pass(Graph& graph, const GraphDescription& description, const GraphDescription::Pass& pass)
{
    PassArguments arguments;
    arguments.name = pass.name;
    arguments.where = pass.pass.where;
    arguments.settings = pass.settings;
    arguments.statics = pass.statics;
    arguments.codecs = pass.codecs;
    arguments.scale = pass.scale;
    const PassPtr declaration = graph.library().find(pass.pass.text);
    for (const auto& input : pass.inputs) {
        const auto image = resolve(graph, description, input.image);
        const bool is_port = declaration && declaration->find_input(input.port) >= 0;
        arguments.inputs.push_back(
            {input.port, image.value_or(AnyImage(ImageRef{})), is_port ? input.image.where : input.where});
    }
    if (pass.size_of)
        arguments.size_of = resolve(graph, description, *pass.size_of);
    graph.add(pass.pass.text, std::move(arguments));
}

void check_param(Graph& graph, const GraphParam& param)
{
    for (const std::string& place : param.places) {
        if (!graph.places_of(place).empty())
            continue;
        const size_t dot = place.rfind('.');
        const int node = dot == std::string::npos ? -1 : graph.find_node(place.substr(0, dot));
        const PassPtr pass = node < 0 ? nullptr : graph.nodes()[static_cast<size_t>(node)].pass;
        graph.report({"unknown_param", fmt::format("param `{}`: there is no setting `{}`", param.name, place),
                      pass ? suggest(place.substr(dot + 1), setting_names(*pass), "settings") : "places are PASS.NAME",
                      param.where});
    }
}

} // namespace

Graph build_graph(const GraphDescription& description, const PassLibrary& library)
{
    Graph graph(library);
    for (const auto& input : description.inputs) {
        switch (input.kind) {
        case GraphNode::Kind::scene:
            graph.scene(input.name, input.where);
            break;
        case GraphNode::Kind::cube:
            graph.cube(input.name, input.signal, input.where);
            break;
        default:
            graph.picture(input.name, input.signal, input.where);
            break;
        }
    }
    Errors cycles;
    const ProducerOrder producers(description, cycles);
    for (Error& error : cycles)
        graph.report(std::move(error));
    for (const size_t pass : producers.order())
        add_pass(graph, description, description.passes[pass]);
    for (const auto& output : description.outputs)
        graph.output(output.name, resolve(graph, description, output.image).value_or(AnyImage(ImageRef{})),
                     output.image.where);
    for (const GraphParam& param : description.params) {
        graph.param(param);
        check_param(graph, param);
    }
    return graph;
}

Result<Graph> load_graph(const std::string& path, const PassLibrary& library)
{
    const auto text = read_text_file(path);
    if (!text)
        return tl::unexpected(text.error());
    const auto description = read_graph_description(*text, path);
    if (!description)
        return tl::unexpected(description.error());
    if (!description->composite_name.empty() ||
        std::any_of(description->inputs.begin(), description->inputs.end(), [](const auto& input) {
            return input.signal == Signal::color && input.kind != GraphNode::Kind::scene;
        })) {
        return fail({"composite_alone",
                     "this file is a composite pass, not a graph",
                     "name it as a pass in a graph",
                     {path, 1, 1}});
    }
    return build_graph(*description, library);
}

} // namespace passgraph
