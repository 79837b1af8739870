// Collects paths from a scene file's JSON.
#include "tool/view/scene_files.hpp"

#include <filesystem>

#include <passgraph/core/json.hpp>

namespace passgraph::tool::view {
namespace {

namespace fs = std::filesystem;

void add_folder(const fs::path& folder, std::vector<std::string>& files)
{
    std::error_code failed;
    for (auto entry = fs::directory_iterator(folder, failed); !failed && entry != fs::directory_iterator(); entry.increment(failed))
        if (entry->is_regular_file(failed))
            files.push_back(entry->path().string());
}

} // namespace

std::vector<std::string> files_of_scene(const std::string& scene)
{
    std::vector<std::string> files = {scene};
    const Result<std::string> text = read_text_file(scene);
    const Result<Json> json = text ? parse_json(*text, scene) : Result<Json>(tl::unexpected(text.error()));
    if (!json)
        return files;
    const fs::path folder = fs::path(scene).parent_path();
    if (const Json* elements = json->find("elements"))
        for (const Json& element : elements->array)
            if (const Json* model = element.find("model"); model && model->is(Json::Kind::string)) {
                const fs::path path = folder / model->string;
                files.push_back(path.string());
                if (path.extension() == ".gltf") // its buffers and pictures
                    add_folder(path.parent_path(), files);
            }
    if (const Json* sky = json->find("sky"))
        if (const Json* faces = sky->find("faces"); faces && faces->is(Json::Kind::string))
            add_folder(folder / faces->string, files);
    return files;
}

} // namespace passgraph::tool::view
