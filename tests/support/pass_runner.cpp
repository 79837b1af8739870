// Runs one pass alone, on pictures made by a test, every output stored in binary32.
#include "support/pass_runner.hpp"

#include <charconv>
#include <cstdlib>
#include <random>

#include <passgraph/gl/renderer.hpp>
#include <passgraph/shader/pass_file.hpp>

#include "support/catch.hpp"
#include "support/test_context.hpp"

namespace passgraph::test {
namespace {

template <class T>
T expect(Result<T> result)
{
    if (!result)
        FAIL(to_text(result.error()));
    if constexpr (!std::is_void_v<T>)
        return std::move(*result);
}

PassLibrary library_for(const PassRun& run)
{
    PassLibrary library = builtin_passes();
    for (const std::string& folder : run.folders)
        expect(load_pass_folder(folder, library, std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common"));
    return library;
}

/// "2", "0.4,0.8,0.1", "true" or an item.
PassArguments::Setting setting_of(const std::string& name, const std::string& text)
{
    PassArguments::Setting setting;
    setting.name = name;
    setting.item = text;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at < end) {
        double number = 0.0;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc())
            break;
        setting.numbers.push_back(number);
        at = next < end ? next + 1 : end;
    }
    return setting;
}

/// The passes of a run's own wires: each input a picture or cube, each output named.
/// The codec that stores values as they are, in binary32; depth in a color of its own.
std::string exact_codec(Signal signal)
{
    for (const char* codec : {"rgba32f", "rg32f", "r32f"})
        if (find_codec(signal, codec))
            return codec;
    return codec_names(signal).back();
}

Graph graph_for(const PassRun& run, const PassLibrary& library, const PassDeclaration& pass)
{
    Graph graph(library);
    PassArguments arguments;
    arguments.name = "pass_under_test";
    arguments.scale = run.scale;
    for (const auto& [name, picture] : run.inputs) {
        const int port = pass.find_input(name);
        REQUIRE(port >= 0);
        const Signal declared = pass.inputs[static_cast<size_t>(port)].signal;
        arguments.inputs.push_back({name, graph.picture(name, declared == Signal::color ? run.generic : declared)});
    }
    for (const auto& [name, faces] : run.cubes)
        arguments.inputs.push_back(
            {name, graph.cube(name, pass.inputs[static_cast<size_t>(pass.find_input(name))].signal)});
    for (const InputPort& port : pass.inputs)
        if (port.over == Over::scene)
            arguments.inputs.push_back({port.name, graph.scene().elements});
    for (const auto& [name, text] : run.settings)
        arguments.settings.push_back(setting_of(name, text));
    for (const OutputPort& port : pass.outputs)
        arguments.codecs.push_back(
            {port.name,
             {},
             exact_codec(port.signal),
             {}});
    const AddedPass added = graph.add(run.pass, std::move(arguments));
    for (const OutputPort& port : pass.outputs)
        graph.output(port.name, added[port.name]);
    return graph;
}

} // namespace

std::map<std::string, Picture> run_pass(const PassRun& run)
{
    Context& context = test_context();
    const PassLibrary library = library_for(run);
    const PassPtr pass = library.find(run.pass);
    REQUIRE(pass != nullptr);
    const Graph graph = graph_for(run, library, *pass);
    CompileOptions options;
    options.specialise = false; // a pass that is left out shows nothing
    if (run.extent.width > 0)
        options.extent = run.extent;
    else if (!run.inputs.empty())
        options.extent = run.inputs.front().second.extent;
    for (const auto& [name, picture] : run.inputs)
        options.picture_extents[name] = picture.extent;
    RendererOptions renderer_options;
    renderer_options.loader = context.loader();
    Renderer renderer = expect(Renderer::create(expect(compile(graph, options)), renderer_options));
    for (const auto& [name, picture] : run.inputs)
        expect(renderer.import_picture(name, picture));
    for (const auto& [name, faces] : run.cubes)
        expect(renderer.import_cube(name, faces));
    if (run.scene)
        expect(renderer.set_scene(*run.scene));
    expect(renderer.render());
    std::map<std::string, Picture> outputs;
    for (const OutputPort& port : pass->outputs)
        outputs[port.name] = expect(renderer.read(port.name));
    return outputs;
}

Picture run_for_output(const PassRun& run)
{
    const auto outputs = run_pass(run);
    REQUIRE(outputs.size() == 1);
    return outputs.begin()->second;
}

Picture constant(Extent extent, std::initializer_list<float> value)
{
    Picture picture(extent, static_cast<int>(value.size()));
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = value.begin()[i % value.size()];
    return picture;
}

Picture noise(Extent extent, int channels, float lowest, float highest, unsigned seed)
{
    // Only the engine is used: distributions differ between standard libraries.
    std::mt19937 engine(seed);
    Picture picture(extent, channels);
    for (float& value : picture.texels)
        value = lowest + (highest - lowest) * static_cast<float>(engine() >> 8) / 16777216.0f;
    return picture;
}

} // namespace passgraph::test
