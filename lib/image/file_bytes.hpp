// Whole files: read at once, written so that a failure changes nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "passgraph/core/error.hpp"

namespace passgraph::image_io
{

/// Zero bytes after the content that read_file allocates, so that a decoder's look-ahead stays in memory.
inline constexpr size_t kSlack = 64;

/// A file's content; `content()` leaves out the slack.
struct FileBytes {
    std::vector<uint8_t> storage;

    std::span<const uint8_t> content() const { return {storage.data(), storage.size() - kSlack}; }
};

/// Errors   file_missing (with the nearest name in the folder), file_unreadable, picture_too_large above 2 GiB - 1,
///          which is what stb and tinyexr can address.
Result<FileBytes> read_file(const std::string& path);

/// Writes beside `path` and renames.
/// Errors   file_unwritable; the old file is then still there and nothing else.
Result<void> write_file(const std::string& path, std::span<const uint8_t> bytes);

} // namespace passgraph::image_io
