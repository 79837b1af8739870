// From a rung's texts to a renderer.
#include "tool/accuracy/subject.hpp"

#include <charconv>

#include <passgraph/core/compile.hpp>

namespace passgraph::accuracy {
namespace {

PassArguments::Setting setting_of(const std::string& name, const std::string& text)
{
    PassArguments::Setting setting{.name = name, .numbers = {}, .item = text, .where = {}};
    double number = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure == std::errc() && end == text.data() + text.size())
        setting.numbers.push_back(number);
    return setting;
}

Result<Graph> graph_of(const Rung& rung, const PassLibrary& library)
{
    const Result<GraphDescription> description = read_graph_description(rung.graph, "rung " + rung.name);
    if (!description)
        return tl::unexpected(description.error());
    Graph graph = build_graph(*description, library);
    Errors errors;
    const auto keep = [&](const Result<void>& done) {
        if (!done)
            append(errors, done.error());
    };
    for (const auto& [place, text] : rung.settings)
        keep(graph.set(place, setting_of(place, text)));
    for (const auto& [image, codec] : rung.codecs)
        keep(graph.set_codec(image, codec));
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return graph;
}

double kept_bytes_per_pixel(const Plan& plan)
{
    const double pixels = static_cast<double>(plan.extent.width) * plan.extent.height;
    const Plan::Output& output = plan.outputs.front();
    double bytes = 0.0;
    for (size_t slot = 0; slot < plan.slots.size(); ++slot) {
        const Plan::Slot& row = plan.slots[slot];
        const double size = static_cast<double>(bytes_per_texel(row.format)) * row.extent.width * row.extent.height;
        if (output.source != Plan::Read::Source::slot || output.index != static_cast<int>(slot))
            bytes += size;
    }
    return bytes > 0.0 ? bytes / pixels : bytes_per_texel(codecs_of(output.signal).front().format);
}

} // namespace

Result<Subject> make_subject(const Rung& rung, const Inputs& inputs, Extent extent, const PassLibrary& library, GlLoader loader)
{
    const Result<Graph> graph = graph_of(rung, library);
    if (!graph)
        return tl::unexpected(graph.error());
    const Result<Device> device = query_device(loader);
    if (!device)
        return tl::unexpected(device.error());
    CompileOptions options;
    options.extent = extent;
    options.device = *device;
    options.fuse = false;
    options.alias = false; // an image shared over time would hide what is kept
    options.guards = rung.has_guards;
    Result<Plan> plan = compile(*graph, options);
    if (!plan)
        return tl::unexpected(plan.error());
    const double bytes = kept_bytes_per_pixel(*plan);
    Result<Renderer> renderer = Renderer::create(std::move(*plan), {.loader = loader});
    if (!renderer)
        return tl::unexpected(renderer.error());
    Errors errors;
    const auto keep = [&](const Result<void>& done) {
        if (!done)
            append(errors, done.error());
    };
    for (const auto& [name, picture] : inputs.pictures)
        keep(renderer->import_picture(name, picture));
    if (inputs.scene)
        keep(renderer->set_scene(*inputs.scene));
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return Subject{std::move(*renderer), bytes};
}

Result<Picture> draw_and_read(Subject& subject)
{
    if (const Result<void> drawn = subject.renderer.render(); !drawn)
        return tl::unexpected(drawn.error());
    return subject.renderer.read("result");
}

} // namespace passgraph::accuracy
