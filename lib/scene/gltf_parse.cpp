// tinygltf at arm's length: it sees checked JSON only, reads files and images through us, and may not throw past here.
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>

#include <fmt/format.h>
#include <stb_image.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

constexpr size_t kLongestMessage = 160; // tinygltf quotes whole data: uris

bool file_exists(const std::string& path, void*)
{
    std::error_code code;
    return std::filesystem::is_regular_file(path, code);
}

/// tinygltf's own runs the path through the shell's expansion.
std::string same_path(const std::string& path, void*)
{
    return path;
}

bool read_file(std::vector<unsigned char>* bytes, std::string* error, const std::string& path, void*)
{
    std::error_code code;
    const auto size = std::filesystem::file_size(path, code);
    if (code || size > Limits::kFileBytes) {
        *error += fmt::format("{} cannot be read, or has more than {} bytes", path, Limits::kFileBytes);
        return false;
    }
    bytes->resize(size);
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes->data()), static_cast<std::streamsize>(size));
    return static_cast<bool>(stream);
}

struct ImageStore {
    std::map<int, std::string>& broken;
    size_t bytes = 0;
};

struct StbFree {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// Decodes to 8-bit RGBA. A 16-bit code is rounded to the nearest 8-bit one: 65535 = 255 * 257.
std::string decode(tinygltf::Image& image, const unsigned char* bytes, int size, ImageStore& store)
{
    int width = 0;
    int height = 0;
    int channels = 0;
    if (!stbi_info_from_memory(bytes, size, &width, &height, &channels))
        return "it is no picture that can be read (PNG or JPEG)";
    if (width < 1 || height < 1 || width > Limits::kTextureSide || height > Limits::kTextureSide)
        return fmt::format("it has {} x {} texels; at most {} in a direction are read", width, height,
                           Limits::kTextureSide);
    const size_t count = static_cast<size_t>(width) * static_cast<size_t>(height) * 4;
    if (store.bytes + count > Limits::kTextureBytes)
        return fmt::format("the images have more than {} bytes together", Limits::kTextureBytes);
    if (stbi_is_16_bit_from_memory(bytes, size)) {
        const std::unique_ptr<std::uint16_t[], StbFree> pixels(
            stbi_load_16_from_memory(bytes, size, &width, &height, &channels, 4));
        if (!pixels)
            return fmt::format("it cannot be decoded: {}", stbi_failure_reason());
        image.image.resize(count);
        for (size_t i = 0; i < count; ++i)
            image.image[i] = static_cast<unsigned char>((pixels[i] + 128u) / 257u);
    } else {
        const std::unique_ptr<unsigned char[], StbFree> pixels(
            stbi_load_from_memory(bytes, size, &width, &height, &channels, 4));
        if (!pixels)
            return fmt::format("it cannot be decoded: {}", stbi_failure_reason());
        image.image.assign(pixels.get(), pixels.get() + count);
    }
    store.bytes += count;
    image.width = width;
    image.height = height;
    image.component = 4;
    return "";
}

/// Always succeeds: an image that nobody uses may be of any kind, so the reason is kept until somebody does.
bool load_image(tinygltf::Image* image, int index, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void* user)
{
    ImageStore& store = *static_cast<ImageStore*>(user);
    if (std::string reason = decode(*image, bytes, size, store); !reason.empty())
        store.broken[index] = std::move(reason);
    return true;
}

std::string one_line(std::string text)
{
    while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
        text.pop_back();
    for (char& c : text)
        if (c == '\n')
            c = ' ';
    if (text.size() > kLongestMessage) {
        text.resize(kLongestMessage);
        text.append("…");
    }
    return text;
}

} // namespace

Errors parse(File& file)
{
    ImageStore store{file.broken_images};
    std::string error;
    std::string warning;
    bool done = false;
    try {
        tinygltf::TinyGLTF reader;
        reader.SetImageLoader(load_image, &store);
        reader.SetFsCallbacks({file_exists, same_path, read_file, nullptr, nullptr});
        const std::filesystem::path path(file.path);
        const std::string folder = path.has_parent_path() ? path.parent_path().string() : std::string(".");
        const auto size = static_cast<unsigned int>(file.bytes.size());
        done = file.is_binary ? reader.LoadBinaryFromMemory(&file.model, &error, &warning,
                                                            reinterpret_cast<const unsigned char*>(file.bytes.data()),
                                                            size, folder)
                              : reader.LoadASCIIFromString(&file.model, &error, &warning, file.bytes.data(), size, folder);
    } catch (const std::exception& problem) {
        error += problem.what();
    }
    if (done)
        return {};
    return {malformed({file.path}, fmt::format("the glTF file cannot be read: {}", one_line(error.empty() ? warning : error)))};
}

} // namespace passgraph::gltf
