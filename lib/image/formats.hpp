// The readers and encoders behind read_picture and write_picture, one pair per format family; bytes in, bytes out.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "passgraph/image/image_file.hpp"

namespace passgraph::image_io
{

/// The largest width or height that is read: GL's usual limit.
inline constexpr int kLargestSide = 16384;

using Bytes = std::span<const uint8_t>;

enum class Format { png, jpeg, hdr, exr, pfm };

/// The error of a file that is not what it should be; `reason` completes "cannot read `path`: ...".
tl::unexpected<Errors> malformed(const std::string& path, std::string_view reason, std::string hint = {});

/// The error of a file whose picture has more than kLargestSide texels in a direction.
tl::unexpected<Errors> too_large(const std::string& path, int64_t width, int64_t height);

Result<Picture> decode_png_or_jpeg(const std::string& path, Bytes bytes, Transfer transfer);
Result<Picture> decode_hdr(const std::string& path, Bytes bytes);
Result<Picture> decode_exr(const std::string& path, Bytes bytes);
Result<Picture> decode_pfm(const std::string& path, Bytes bytes);

/// The encoders take 1, 3 or 4 channels and return an empty vector when they fail.
std::vector<uint8_t> encode_png(const Picture& picture);
std::vector<uint8_t> encode_jpeg(const Picture& picture);
std::vector<uint8_t> encode_hdr(const Picture& picture);
std::vector<uint8_t> encode_exr(const Picture& picture);
std::vector<uint8_t> encode_pfm(const Picture& picture);

/// The picture with `channels` channels: grey is repeated, missing color is 0, missing alpha is 1, the rest is dropped.
Picture with_channels(const Picture& picture, int channels);

/// The picture with its first row last.
Picture flipped(const Picture& picture);

} // namespace passgraph::image_io
