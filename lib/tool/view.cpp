// `passgraph view`: the window.
#include <filesystem>

#include <fmt/format.h>

#include "tool/commands.hpp"
#include "tool/options.hpp"
#include "tool/view/session.hpp"

namespace passgraph::tool {
namespace {

/// The fonts of Debian's fonts-dejavu-core.
std::vector<std::string> font_files(const std::string& name)
{
    return {"/usr/share/fonts/truetype/dejavu/" + name};
}

Result<void> check_folders(const view::ViewOptions& options, const LibraryOptions& library)
{
    Errors errors;
    std::error_code failed;
    for (const std::string& folder : library.folders)
        if (!std::filesystem::is_directory(folder, failed))
            errors.push_back({.code = "file_missing",
                              .message = fmt::format("there is no folder `{}`", folder),
                              .hint = "--passes names a folder with .glsl files"});
    if (!std::filesystem::is_directory(options.pictures, failed))
        errors.push_back({.code = "file_missing",
                          .message = fmt::format("there is no folder `{}`", options.pictures),
                          .hint = fmt::format("mkdir -p {}", options.pictures)});
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

Result<void> show(view::ViewOptions options, const LibraryOptions& library)
{
    if (Result<void> checked = check_folders(options, library); !checked)
        return checked;
    // The passes' own folder, where it is still there: an edit of it is seen at once. Else those of the build.
    std::error_code failed;
    if (std::filesystem::is_directory(PASSGRAPH_PASSES_FOLDER, failed))
        options.pass_folders.emplace_back(PASSGRAPH_PASSES_FOLDER);
    options.pass_folders.insert(options.pass_folders.end(), library.folders.begin(), library.folders.end());
    Result<view::Opening> opening = view::open_files(options);
    if (!opening)
        return tl::unexpected(opening.error());
    const Extent extent = extent_of(options.size).value_or(Extent{1280, 720});
    auto window = Window::open({.width = extent.width,
                                .height = extent.height,
                                .title = "passgraph",
                                .fonts = font_files("DejaVuSans.ttf"),
                                .mono_fonts = font_files("DejaVuSansMono.ttf")});
    if (!window)
        return fail({.code = "display_missing",
                     .message = window.error().message,
                     .hint = "view needs a display with OpenGL 3.3 (X11); `passgraph render` draws without one",
                     .fault = Fault::machine});
    const Result<Device> device = query_device((*window)->loader());
    if (!device)
        return tl::unexpected(device.error());
    Result<view::Stage> stage = view::Stage::create((*window)->loader());
    if (!stage)
        return tl::unexpected(stage.error());
    view::Session session(options, std::move(*opening), std::move(*window), std::move(*stage), *device);
    session.run();
    return {};
}

} // namespace

void add_view(CommandLine& line)
{
    const auto options = std::make_shared<view::ViewOptions>();
    const auto library = std::make_shared<LibraryOptions>();
    const auto compiler = std::make_shared<CompilerOptions>();
    Command command = line.add_command("view", "Shows graphs of a scene in a window; files may be edited meanwhile");
    command.add_option("GRAPH", options->graphs, "The graph files; keys Z X C pick them in order").required();
    command.add_option("--scene", options->scene, "The scene file").type_name("FILE");
    command.add_option("--preset", options->preset, "A file of values for the graphs' settings").type_name("FILE");
    add_extent(command, "--size", options->size, "The window's extent; else 1280x720");
    command.add_option("--render-scale", options->render_scale, "Draws at this share of the window's extent, for slow machines")
        .between(0.05, 4.0)
        .type_name("X");
    command.add_option("--pictures", options->pictures, "The folder that the key P saves pictures to; else this one").type_name("DIR");
    command.add_flag("--no-panel", options->hides_panel, "Starts without the panel; Tab shows it");
    add_to(command, *library);
    add_to(command, *compiler);
    command.action([options, library, compiler] {
        compiler->apply_to(options->compiler);
        return show(*options, *library);
    });
}

} // namespace passgraph::tool
