// The bytes of a glTF file: is it one, is it whole, and where is its JSON.
#include <cstdint>
#include <filesystem>

#include <fmt/format.h>

#include "gltf.hpp"

namespace passgraph::gltf {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A; // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004E4942; // "BIN\0"
constexpr size_t kHeader = 12;
constexpr size_t kChunkHeader = 8;

/// .glb is little-endian everywhere.
std::uint32_t word_at(std::string_view bytes, size_t offset)
{
    std::uint32_t word = 0;
    for (size_t i = 0; i < 4; ++i)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[offset + i])) << (8 * i);
    return word;
}

Errors one(Error error)
{
    return {std::move(error)};
}

/// Finds the JSON and the BIN chunk. tinygltf believes a BIN length that is up to 8 bytes too long; we do not.
Errors split_binary(File& file)
{
    const std::string_view bytes = file.bytes;
    const Location where{file.path};
    if (bytes.size() < kHeader + kChunkHeader)
        return one(malformed(where, "the .glb file is truncated: it ends inside its header"));
    if (const std::uint32_t version = word_at(bytes, 4); version != 2)
        return one(malformed(where, fmt::format("this is glTF {}, only glTF 2 can be read", version)));
    const size_t length = word_at(bytes, 8);
    if (length > bytes.size()) {
        return one(malformed(where, fmt::format("the .glb file is truncated: it says it has {} bytes, but has {}",
                                                length, bytes.size())));
    }
    size_t offset = kHeader;
    for (int chunk = 0; offset < length; ++chunk) {
        if (length - offset < kChunkHeader || length - offset - kChunkHeader < word_at(bytes, offset))
            return one(malformed(where, fmt::format("chunk {} of the .glb file goes past its end", chunk)));
        const size_t size = word_at(bytes, offset);
        const std::uint32_t kind = word_at(bytes, offset + 4);
        if ((kind == kJsonChunk) != (chunk == 0))
            return one(malformed(where, "the first chunk of a .glb file, and no other, is its JSON"));
        if (size % 4 != 0)
            return one(malformed(where, fmt::format("chunk {} of the .glb file is no multiple of 4 bytes long", chunk)));
        if (kind == kJsonChunk)
            file.text = bytes.substr(offset + kChunkHeader, size);
        if (chunk == 1 && kind == kBinaryChunk)
            file.binary_size = size;
        offset += kChunkHeader + size;
    }
    if (file.text.empty())
        return one(malformed(where, "the .glb file has no JSON"));
    return {};
}

Errors read_bytes(File& file)
{
    std::error_code code;
    const auto size = std::filesystem::is_regular_file(file.path, code) ? std::filesystem::file_size(file.path, code) : 0;
    if (size > Limits::kFileBytes)
        return one(malformed({file.path}, fmt::format("the file has {} bytes; at most {} are read", size,
                                                      Limits::kFileBytes)));
    Result<std::string> bytes = read_text_file(file.path);
    if (!bytes)
        return bytes.error();
    if (bytes->empty())
        return one(malformed({file.path}, "the file is empty"));
    file.bytes = std::move(*bytes);
    return {};
}

} // namespace

Errors open_file(File& file)
{
    if (Errors errors = read_bytes(file); !errors.empty())
        return errors;
    file.is_binary = file.bytes.starts_with("glTF");
    if (file.is_binary) {
        if (Errors errors = split_binary(file); !errors.empty())
            return errors;
    } else {
        file.text = file.bytes;
        const size_t first = file.text.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos || file.text[first] != '{')
            return one(malformed({file.path}, "this is no glTF: neither a .glb file nor a JSON object"));
    }
    Result<Json> json = parse_json(file.text, file.path);
    if (!json) {
        Errors errors = std::move(json.error());
        for (Error& error : errors)
            error = malformed(error.where, "the JSON of this glTF file: " + error.message, error.hint);
        return errors;
    }
    file.json = std::move(*json);
    return {};
}

} // namespace passgraph::gltf
