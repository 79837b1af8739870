// The project's own sources as lines of text.
#include "architecture/source_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>

namespace passgraph::test {
namespace {

namespace fs = std::filesystem;

const std::array<std::string, 7> kLayers = {"core", "shader", "scene", "image", "gl", "context", "tool"};

std::string part(const std::string& path, size_t start)
{
    const size_t end = path.find('/', start);
    return end == std::string::npos ? "" : path.substr(start, end - start);
}

} // namespace

std::vector<SourceFile> source_files(const std::string& folder, const std::vector<std::string>& endings)
{
    const fs::path root = PASSGRAPH_SOURCE_DIR;
    std::vector<SourceFile> files;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string path = fs::relative(entry.path(), root).generic_string();
        if (!entry.is_regular_file() || std::none_of(endings.begin(), endings.end(), [&](const std::string& end) { return path.ends_with(end); }))
            continue;
        SourceFile file{path, "", {}};
        for (const std::string prefix : {"include/passgraph/", "lib/"})
            if (path.starts_with(prefix))
                file.layer = part(path, prefix.size());
        std::ifstream stream(entry.path());
        for (std::string line; std::getline(stream, line);)
            file.lines.push_back(line);
        files.push_back(std::move(file));
    }
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

std::vector<SourceFile> library_files()
{
    std::vector<SourceFile> files = source_files("include", {".hpp"});
    for (SourceFile& file : source_files("lib", {".hpp", ".cpp"}))
        files.push_back(std::move(file));
    return files;
}

std::string included_by(const std::string& line)
{
    const size_t word = line.find_first_not_of(" \t");
    if (word == std::string::npos || line[word] != '#' || line.find("include", word) == std::string::npos)
        return "";
    const size_t open = line.find_first_of("<\"", word);
    const size_t close = open == std::string::npos ? open : line.find_first_of(">\"", open + 1);
    return close == std::string::npos ? "" : line.substr(open + 1, close - open - 1);
}

std::string layer_of(const std::string& included)
{
    const std::string layer = part(included, included.starts_with("passgraph/") ? std::string("passgraph/").size() : 0);
    return std::find(kLayers.begin(), kLayers.end(), layer) == kLayers.end() ? "" : layer;
}

std::vector<std::string> allowed_layers(const std::string& layer)
{
    static const std::map<std::string, std::vector<std::string>> kArrows = {
        {"core", {"core"}},
        {"shader", {"shader", "core"}},
        {"scene", {"scene", "core", "image"}}, // a scene's sky is a cube of pictures: read_cube
        {"image", {"image", "core"}},
        {"gl", {"gl", "core", "scene"}},
        {"context", {"context"}},
        {"tool", {kLayers.begin(), kLayers.end()}},
    };
    const auto found = kArrows.find(layer);
    return found == kArrows.end() ? std::vector<std::string>{} : found->second;
}

} // namespace passgraph::test
