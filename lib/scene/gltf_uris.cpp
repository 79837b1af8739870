// Which other files a glTF file may name: those that exist at a relative path, and data: uris.
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

int hex_digit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    const int lower = std::tolower(static_cast<unsigned char>(c));
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string percent_decoded(std::string_view uri)
{
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0) {
            text += static_cast<char>(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2]));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

/// "http:", "file:", "C:" — anything with a colon before the first slash — or an absolute path.
bool leaves_the_folder(std::string_view path)
{
    const size_t colon = path.find(':');
    return (colon != std::string_view::npos && colon < path.find_first_of("/\\")) || path.starts_with('/') ||
           path.starts_with('\\') || path.find('\0') != std::string_view::npos;
}

void check_uri(const File& file, const Json& uri, const std::string& name, Errors& errors)
{
    if (uri.string.starts_with("data:")) {
        if (!tinygltf::IsDataURI(uri.string))
            errors.push_back(unsupported(uri.where, fmt::format("{}: its data: uri is of a kind that cannot be read", name),
                                         "data:application/octet-stream;base64, data:image/png;base64, and "
                                         "data:image/jpeg;base64, can"));
        else if (uri.string.ends_with(','))
            errors.push_back(malformed(uri.where, fmt::format("{}: its data: uri holds nothing", name)));
        return;
    }
    const std::string decoded = percent_decoded(uri.string);
    if (decoded.empty() || leaves_the_folder(decoded)) {
        errors.push_back(malformed(uri.where, fmt::format("{}: the uri `{}` is no relative path", name,
                                                          uri.string.substr(0, 80)),
                                   "name a file beside the model, or use a data: uri"));
        return;
    }
    const auto path = std::filesystem::path(file.path).parent_path() / decoded;
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code)) {
        errors.push_back({"file_missing", fmt::format("{}: there is no file {}", name, path.string()), "", uri.where});
    } else if (std::filesystem::file_size(path, code) == 0) {
        errors.push_back(malformed(uri.where, fmt::format("{}: {} is empty", name, path.string())));
    }
}

} // namespace

Errors check_uris(const File& file)
{
    Errors errors;
    const auto& buffers = entries_of(file.json, "buffers");
    for (size_t i = 0; i < buffers.size(); ++i) {
        const std::string name = fmt::format("buffers[{}]", i);
        if (const Json* uri = buffers[i].find("uri"))
            check_uri(file, *uri, name, errors);
        else if (!file.is_binary)
            errors.push_back(malformed(buffers[i].where, name + " lacks a uri", "only a .glb file holds a buffer itself"));
    }
    const auto& images = entries_of(file.json, "images");
    for (size_t i = 0; i < images.size(); ++i) {
        const std::string name = fmt::format("images[{}]", i);
        const Json* uri = images[i].find("uri");
        if ((uri != nullptr) == (images[i].find("bufferView") != nullptr))
            errors.push_back(malformed(images[i].where, name + " has either a uri or a bufferView"));
        else if (uri)
            check_uri(file, *uri, name, errors);
    }
    return errors;
}

} // namespace passgraph::gltf
