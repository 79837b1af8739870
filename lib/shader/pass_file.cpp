// Loads pass files and folders of them.
#include "passgraph/shader/pass_file.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "passgraph/core/graph_file.hpp"
#include "passgraph/core/pass_header.hpp"
#include "shader/check.hpp"

namespace passgraph {
namespace {

namespace fs = std::filesystem;

IncludeFinder finder_in(std::vector<std::string> folders)
{
    return [folders = std::move(folders)](std::string_view name) -> std::optional<IncludedFile> {
        for (const std::string& folder : folders) {
            const std::string path = (fs::path(folder) / name).lexically_normal().string();
            if (auto text = read_text_file(path))
                return IncludedFile{path, std::move(*text)};
        }
        return std::nullopt;
    };
}

std::vector<std::string> common_folders_of(const fs::path& file, const std::string& fallback)
{
    const fs::path folder = file.parent_path();
    std::vector<std::string> folders = {(folder / "common").string(),
                                        (folder / ".." / "common").lexically_normal().string()};
    if (!fallback.empty())
        folders.push_back(fallback);
    return folders;
}

/// Composites may use one another: each is declared as soon as those it names are.
void declare_composites(std::vector<std::pair<std::string, std::shared_ptr<const GraphDescription>>> open,
                        PassLibrary& library, Errors& errors)
{
    bool has_progress = true;
    while (!open.empty() && has_progress) {
        has_progress = false;
        for (size_t i = 0; i < open.size(); ++i) {
            const auto& [family, description] = open[i];
            const bool waits =
                std::any_of(description->passes.begin(), description->passes.end(), [&](const auto& pass) {
                    return std::any_of(open.begin(), open.end(), [&](const auto& other) {
                        return other.second->composite_name == pass.pass.text;
                    });
                });
            if (waits)
                continue;
            auto declared = declare_composite(description, family, library);
            if (declared)
                library.add(*declared);
            else
                append(errors, declared.error());
            open.erase(open.begin() + static_cast<std::ptrdiff_t>(i));
            has_progress = true;
            break;
        }
    }
    for (const auto& [family, description] : open)
        errors.push_back({"cycle",
                          fmt::format("the composite `{}` contains itself", description->composite_name),
                          "cut the circle",
                          {description->file, 1, 1}});
}

/// What is missing at a text's end, glslang misses in the lines after it, which are generated: say it at the last line.
Errors within_file(Errors errors, const std::string& text, const std::string& file)
{
    const auto breaks = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    const int last = text.ends_with('\n') ? breaks : breaks + 1;
    for (Error& error : errors)
        if (error.where.file == "generated" || (error.where.file == file && error.where.line > last))
            error.where = {file, last, 0};
    return errors;
}

} // namespace

Result<PassPtr> read_pass(const std::string& text, const std::string& file, const std::string& family,
                          const std::vector<std::string>& common_folders)
{
    auto pass = read_pass_header(text, file, family, finder_in(common_folders));
    if (!pass)
        return tl::unexpected(pass.error());
    if (const auto checked = shader::check_and_derive(*pass); !checked)
        return tl::unexpected(within_file(checked.error(), text, file));
    return std::make_shared<const PassDeclaration>(std::move(*pass));
}

Result<PassPtr> load_pass_file(const std::string& path, const std::string& fallback_common)
{
    const auto text = read_text_file(path);
    if (!text)
        return tl::unexpected(text.error());
    const fs::path file = fs::absolute(path);
    return read_pass(*text, path, file.parent_path().filename().string(),
                     common_folders_of(fs::path(path), fallback_common));
}

Result<void> load_pass_folder(const std::string& folder, PassLibrary& library, const std::string& fallback_common,
                              PassFileCache* cache)
{
    std::error_code code;
    if (!fs::is_directory(folder, code))
        return fail({"file_missing", "there is no such folder", "name a folder that holds .glsl passes", {folder}});
    std::vector<fs::path> files;
    for (auto entry = fs::recursive_directory_iterator(folder, code); entry != fs::recursive_directory_iterator();
         entry.increment(code)) {
        if (entry->is_directory(code) && entry->path().filename() == "common")
            entry.disable_recursion_pending();
        else if (entry->is_regular_file(code))
            files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());

    Errors errors;
    std::vector<std::pair<std::string, std::shared_ptr<const GraphDescription>>> composites;
    for (const fs::path& file : files) {
        const std::string name = file.filename().string();
        if (name.ends_with(".glsl")) {
            auto pass = cache != nullptr ? cache->load(file.string(), fallback_common)
                                         : load_pass_file(file.string(), fallback_common);
            if (pass)
                library.add(*pass);
            else
                append(errors, pass.error());
        } else if (name.ends_with(".graph.json")) {
            const auto text = read_text_file(file.string());
            auto description = text ? read_graph_description(*text, file.string()) : tl::unexpected(text.error());
            if (!description)
                append(errors, description.error());
            else if (!description->composite_name.empty())
                composites.emplace_back(file.parent_path().filename().string(),
                                        std::make_shared<const GraphDescription>(std::move(*description)));
        }
    }
    declare_composites(std::move(composites), library, errors);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return {};
}

} // namespace passgraph
