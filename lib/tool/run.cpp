// `passgraph run`: draws one pass alone, on pictures or on a scene.
#include <algorithm>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>

#include "tool/commands.hpp"
#include "tool/device.hpp"
#include "tool/job.hpp"
#include "tool/library.hpp"
#include "tool/outputs.hpp"

namespace passgraph::tool {
namespace {

struct RunOptions {
    std::string pass;
    std::vector<std::string> params;
    LibraryOptions library;
    SourceOptions sources;
    CompilerOptions compiler;
    DeviceOptions device;
    std::vector<std::string> outputs;
};

bool holds_codes(const std::string& file)
{
    const Result<bool> answer = holds_display_codes(file);
    return answer && *answer;
}

/// What a generic input is taken for: display when codes of a display go in and come out, else radiance.
Signal generic_signal(const PassDeclaration& pass, const RunOptions& options)
{
    for (const Pair& pair : pairs_of("--in", options.sources.pictures)) {
        const int input = pass.find_input(pair.name);
        if (input >= 0 && pass.inputs[static_cast<size_t>(input)].signal == Signal::color && !holds_codes(pair.text))
            return Signal::radiance;
    }
    const std::vector<Pair> outputs = pairs_of("--out", options.outputs);
    const bool all_codes = std::all_of(outputs.begin(), outputs.end(), [](const Pair& pair) { return holds_codes(pair.text); });
    return all_codes ? Signal::display : Signal::radiance;
}

/// The graph that is this pass and its inputs.
Graph graph_of(const PassDeclaration& pass, const PassLibrary& library, const RunOptions& options)
{
    Graph graph(library);
    const bool is_taken = std::any_of(pass.inputs.begin(), pass.inputs.end(), [](const InputPort& port) {
        return port.name == "scene" && port.over != Over::scene;
    });
    std::optional<SceneInput> scene;
    const auto use_scene = [&] {
        if (!scene)
            scene = graph.scene(is_taken ? "drawn_scene" : "scene");
        return *scene;
    };
    const std::vector<Pair> pictures = pairs_of("--in", options.sources.pictures);
    const Signal generic = generic_signal(pass, options);
    PassArguments arguments;
    for (const InputPort& port : pass.inputs) {
        const Signal signal = port.signal == Signal::color ? generic : port.signal;
        const bool is_given =
            std::any_of(pictures.begin(), pictures.end(), [&](const Pair& pair) { return pair.name == port.name; });
        if (port.over == Over::scene)
            arguments.inputs.push_back({port.name, use_scene().elements});
        else if (port.over == Over::sphere && !is_given && !options.sources.scene.empty())
            arguments.inputs.push_back({port.name, use_scene().sky});
        else if (port.over == Over::sphere && (is_given || !port.is_optional))
            arguments.inputs.push_back({port.name, graph.cube(port.name, signal)});
        else if (is_given || !port.is_optional)
            arguments.inputs.push_back({port.name, graph.picture(port.name, signal)});
    }
    for (const Pair& pair : pairs_of("--param", options.params))
        arguments.settings.push_back(setting_of(pair));
    arguments.name = pass.name;
    while (graph.find_node(arguments.name) >= 0) // an input may be called as its pass is
        arguments.name += "_pass";
    graph.add(pass.name, std::move(arguments));
    return graph;
}

/// Makes the pass's outputs that are asked for the graph's.
std::vector<OutputFile> name_ports(Graph& graph, const PassDeclaration& pass, const std::vector<std::string>& words)
{
    std::vector<OutputFile> files;
    std::vector<std::string> names;
    for (const OutputPort& port : pass.outputs)
        names.push_back(port.name);
    std::string node = pass.name;
    while (pass.find_input(node) >= 0)
        node += "_pass";
    for (const Pair& pair : pairs_of("--out", words)) {
        if (pass.find_output(pair.name) < 0) {
            graph.report({"unknown_output", fmt::format("{} has no output `{}`", pass.name, pair.name),
                          suggest(pair.name, names, "outputs"), pair.where});
            continue;
        }
        const bool is_new = std::none_of(files.begin(), files.end(), [&](const auto& file) { return file.output == pair.name; });
        if (const auto image = graph.find_image(node + "." + pair.name); image && is_new)
            graph.output(pair.name, AnyImage(*image), pair.where);
        files.push_back({pair.name, pair.text, pair.where});
    }
    return files;
}

Result<void> run(const RunOptions& options)
{
    Result<PassLibrary> library = load_library(options.library);
    if (!library)
        return tl::unexpected(library.error());
    const Result<PassPtr> pass = find_pass(options.pass, *library);
    if (!pass)
        return tl::unexpected(pass.error());
    Graph graph = graph_of(**pass, *library, options);
    const std::vector<OutputFile> outputs = name_ports(graph, **pass, options.outputs);
    const Result<Job> job = prepare(std::move(graph), options.sources, options.compiler);
    if (!job)
        return tl::unexpected(job.error());
    if (Result<void> checked = check_outputs(job->plan, outputs); !checked)
        return checked;
    const Result<std::unique_ptr<Context>> context = open_context(options.device);
    if (!context)
        return tl::unexpected(context.error());
    Result<Renderer> renderer = create_renderer(*job, job->options, {.loader = (*context)->loader()});
    if (!renderer)
        return tl::unexpected(renderer.error());
    return render_frames(*renderer, 1, outputs);
}

} // namespace

void add_run(CommandLine& line)
{
    const auto options = std::make_shared<RunOptions>();
    Command command = line.add_command("run", "Draws one pass alone");
    command.add_option("PASS", options->pass, "A pass by name, or its .glsl file").required();
    add_to(command, options->sources);
    add_pairs(command, "--param", options->params, "Sets a parameter, choice or rung").type_name("N=V");
    add_pairs(command, "--out", options->outputs, "Writes an output of the pass").required().type_name("PORT=FILE");
    add_to(command, options->library);
    add_to(command, options->compiler);
    add_to(command, options->device);
    command.footer("Inputs of signal `color` take a .png or .jpg as display when a .png or .jpg is written, else as radiance;\n"
                   "its alpha is left out.");
    command.action([options] { return run(*options); });
}

} // namespace passgraph::tool
