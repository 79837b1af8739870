// Names, checks and writes the images a user asked for.
#include "tool/outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>

#include "tool/pictures.hpp"
#include "tool/progress.hpp"

namespace passgraph::tool {
namespace {

namespace fs = std::filesystem;

/// Where `%d` or `%04d` stands in a name: its start, its end, and its digits.
struct NumberPlace {
    size_t start = 0;
    size_t end = 0;
    size_t digits = 0;
};

std::optional<NumberPlace> find_number(const std::string& file)
{
    for (size_t start = file.find('%'); start != std::string::npos; start = file.find('%', start + 1)) {
        size_t end = start + 1;
        while (end < file.size() && file[end] >= '0' && file[end] <= '9' && end - start < 3)
            ++end;
        if (end < file.size() && file[end] == 'd')
            return NumberPlace{start, end + 1, end - start > 1 ? static_cast<size_t>(std::stoi(file.substr(start + 1))) : 0};
    }
    return std::nullopt;
}

Result<void> check_folder(const OutputFile& output)
{
    const fs::path path(output.file);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code failed;
    if (fs::is_directory(folder, failed) && !fs::is_directory(path, failed))
        return {};
    const bool is_folder = fs::is_directory(path, failed);
    return fail({.code = "file_unwritable",
                 .message = is_folder ? fmt::format("`{}` is a folder", output.file) : fmt::format("there is no folder `{}`", folder.string()),
                 .hint = is_folder ? "name a file in it" : fmt::format("mkdir -p {}", folder.string()),
                 .where = output.where});
}

Result<void> write_output(Renderer& renderer, const OutputFile& output, const std::string& file, const Picture& values)
{
    for (const Plan::Output& planned : renderer.plan().outputs)
        if (planned.name == output.output)
            return write_picture(file, file_numbers(values, file, planned.signal));
    return {};
}

} // namespace

bool OutputFile::is_sequence() const { return find_number(file).has_value(); }

std::string OutputFile::file_of(int frame) const
{
    const std::optional<NumberPlace> place = find_number(file);
    if (!place)
        return file;
    return fmt::format("{}{:0{}}{}", file.substr(0, place->start), frame, place->digits, file.substr(place->end));
}

std::vector<OutputFile> name_outputs(Graph& graph, const std::vector<std::string>& words)
{
    std::vector<OutputFile> files;
    for (const Pair& pair : pairs_of("--out", words)) {
        const auto& outputs = graph.outputs();
        const bool is_output = std::any_of(outputs.begin(), outputs.end(), [&](const GraphOutput& output) { return output.name == pair.name; });
        Error why;
        if (!is_output) {
            if (const auto image = graph.find_image(pair.name, &why)) {
                graph.output(pair.name, AnyImage(*image), pair.where);
            } else {
                std::vector<std::string> names;
                for (const GraphOutput& output : outputs)
                    names.push_back(output.name);
                graph.report({"unknown_output", fmt::format("the graph has no output and no image `{}`", pair.name),
                              suggest(pair.name, names, "outputs"), pair.where});
                continue;
            }
        }
        files.push_back({pair.name, pair.text, pair.where});
    }
    return files;
}

Result<void> check_outputs(const Plan& plan, const std::vector<OutputFile>& outputs)
{
    Errors errors;
    const auto keep = [&](Result<void> checked, const Location& where) {
        if (checked)
            return;
        for (Error& error : checked.error()) {
            error.where = where;
            errors.push_back(std::move(error));
        }
    };
    std::map<fs::path, std::string> taken;
    for (const OutputFile& output : outputs) {
        for (const Plan::Output& planned : plan.outputs)
            if (planned.name == output.output)
                keep(check_file_holds(output.file, planned.signal), output.where);
        keep(check_folder(output), output.where);
        std::error_code failed;
        const auto [first, is_new] = taken.emplace(fs::weakly_canonical(fs::absolute(output.file), failed), output.output);
        if (!is_new)
            errors.push_back({"duplicate_file", fmt::format("`{}` would be written twice: by `{}` and `{}`", output.file, first->second, output.output),
                              "give each output a file of its own", output.where});
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

Result<void> render_frames(Renderer& renderer, int frames, const std::vector<OutputFile>& outputs)
{
    Progress progress(frames > 1 ? fmt::format("frame 1 of {}", frames) : "rendering");
    for (int frame = 0; frame < frames; ++frame) {
        progress.update(fmt::format("frame {} of {}", frame + 1, frames));
        if (Result<void> rendered = renderer.render({.time = frame / 60.0, .index = frame}); !rendered)
            return rendered;
        std::vector<std::pair<const OutputFile*, Picture>> read;
        for (const OutputFile& output : outputs) {
            if (!output.is_sequence() && frame + 1 < frames)
                continue;
            Result<Picture> values = renderer.read(output.output);
            if (!values)
                return tl::unexpected(values.error());
            read.emplace_back(&output, std::move(*values));
        }
        for (const auto& [output, values] : read)
            if (Result<void> written = write_output(renderer, *output, output->file_of(frame), values); !written)
                return written;
    }
    return {};
}

} // namespace passgraph::tool
