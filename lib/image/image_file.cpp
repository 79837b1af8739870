// Which format a file has, and the way from a path to a picture and back.
#include "passgraph/image/image_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <new>
#include <optional>

#include <fmt/format.h>

#include "image/file_bytes.hpp"
#include "image/formats.hpp"

namespace passgraph
{

namespace image_io
{

tl::unexpected<Errors> malformed(const std::string& path, std::string_view reason, std::string hint)
{
    return fail({.code = "picture_malformed",
                 .message = fmt::format("cannot read `{}`: {}", path, reason),
                 .hint = std::move(hint)});
}

tl::unexpected<Errors> too_large(const std::string& path, int64_t width, int64_t height)
{
    return fail({.code = "picture_too_large",
                 .message = fmt::format("`{}` has {} x {} texels", path, width, height),
                 .hint = fmt::format("at most {0} x {0} are read", kLargestSide)});
}

Picture with_channels(const Picture& picture, int channels)
{
    if (picture.channels == channels)
        return picture;
    Picture result(picture.extent, channels);
    const size_t from = static_cast<size_t>(picture.channels);
    const size_t to = static_cast<size_t>(channels);
    const size_t count = picture.texels.size() / from;
    for (size_t i = 0; i < count; ++i) {
        for (size_t c = 0; c < to; ++c) {
            float value = c == 3 ? 1.0f : 0.0f;
            if (c < from)
                value = picture.texels[i * from + c];
            else if (from == 1 && c < 3)
                value = picture.texels[i];
            result.texels[i * to + c] = value;
        }
    }
    return result;
}

Picture flipped(const Picture& picture)
{
    Picture result(picture.extent, picture.channels);
    const auto row = static_cast<std::ptrdiff_t>(picture.index(0, 1));
    for (int y = 0; y < picture.extent.height; ++y)
        std::copy_n(picture.texels.begin() + (picture.extent.height - 1 - y) * row, row,
                    result.texels.begin() + y * row);
    return result;
}

} // namespace image_io

namespace
{

using image_io::Format;

constexpr std::string_view kSuffixes = ".png .jpg .jpeg .hdr .exr .pfm";

std::optional<Format> format_of_suffix(const std::string& path)
{
    std::string suffix = std::filesystem::path(path).extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (suffix == ".png")
        return Format::png;
    if (suffix == ".jpg" || suffix == ".jpeg")
        return Format::jpeg;
    if (suffix == ".hdr")
        return Format::hdr;
    if (suffix == ".exr")
        return Format::exr;
    if (suffix == ".pfm")
        return Format::pfm;
    return std::nullopt;
}

std::optional<Format> format_of_content(image_io::Bytes bytes)
{
    const auto begins_with = [&](std::string_view magic) {
        return bytes.size() >= magic.size() &&
               std::equal(magic.begin(), magic.end(), bytes.begin(),
                          [](char a, uint8_t b) { return static_cast<uint8_t>(a) == b; });
    };
    if (begins_with("\x89PNG\r\n\x1a\n"))
        return Format::png;
    if (begins_with("\xff\xd8\xff"))
        return Format::jpeg;
    if (begins_with("#?"))
        return Format::hdr;
    if (begins_with("\x76\x2f\x31\x01"))
        return Format::exr;
    if (begins_with("PF\n") || begins_with("Pf\n") || begins_with("PF\r") || begins_with("Pf\r"))
        return Format::pfm;
    return std::nullopt;
}

tl::unexpected<Errors> unknown_format(const std::string& path)
{
    return fail({.code = "picture_format",
                 .message = fmt::format("`{}` is no picture format that is known here", path),
                 .hint = fmt::format("the suffixes are: {}", kSuffixes)});
}

Result<Picture> decode(Format format, const std::string& path, image_io::Bytes bytes, Transfer transfer)
{
    switch (format) {
    case Format::png:
    case Format::jpeg:
        return image_io::decode_png_or_jpeg(path, bytes, transfer);
    case Format::hdr:
        return image_io::decode_hdr(path, bytes);
    case Format::exr:
        return image_io::decode_exr(path, bytes);
    case Format::pfm:
        return image_io::decode_pfm(path, bytes);
    }
    return unknown_format(path);
}

std::vector<uint8_t> encode(Format format, const Picture& picture)
{
    switch (format) {
    case Format::png:
        return image_io::encode_png(picture);
    case Format::jpeg:
        return image_io::encode_jpeg(picture);
    case Format::hdr:
        return image_io::encode_hdr(picture);
    case Format::exr:
        return image_io::encode_exr(picture);
    case Format::pfm:
        return image_io::encode_pfm(picture);
    }
    return {};
}

/// How many channels a format stores of a picture with `channels`.
int stored_channels(Format format, int channels)
{
    const int at_least_three = channels == 2 ? 3 : channels;
    const bool has_alpha = format == Format::png || format == Format::exr;
    return has_alpha ? at_least_three : std::min(at_least_three, 3);
}

} // namespace

Result<Picture> read_picture(const std::string& path, Transfer transfer)
{
    const Result<image_io::FileBytes> file = image_io::read_file(path);
    if (!file)
        return tl::unexpected(file.error());
    const std::optional<Format> format = format_of_content(file->content());
    if (!format && !format_of_suffix(path))
        return unknown_format(path);
    if (file->content().empty())
        return image_io::malformed(path, "it is empty");
    if (!format)
        return image_io::malformed(path, "its first bytes are those of no known picture format",
                                   fmt::format("the formats are: {}", kSuffixes));
    try {
        return decode(*format, path, file->content(), transfer);
    } catch (const std::bad_alloc&) {
        return fail({.code = "picture_too_large",
                     .message = fmt::format("`{}` does not fit into memory", path),
                     .fault = Fault::machine});
    }
}

Result<bool> holds_display_codes(const std::string& path)
{
    const std::optional<Format> format = format_of_suffix(path);
    if (!format)
        return unknown_format(path);
    return *format == Format::png || *format == Format::jpeg;
}

Result<void> write_picture(const std::string& path, const Picture& picture)
{
    const std::optional<Format> format = format_of_suffix(path);
    if (!format)
        return unknown_format(path);
    const auto [width, height] = picture.extent;
    const bool is_whole = width > 0 && height > 0 && width <= image_io::kLargestSide &&
                          height <= image_io::kLargestSide && picture.channels >= 1 && picture.channels <= 4 &&
                          picture.texels.size() == picture.index(0, height);
    if (!is_whole)
        return fail({.code = "file_unwritable",
                     .message = fmt::format("cannot write `{}`: a picture of {} x {} texels with {} channels and {} "
                                            "numbers cannot be stored",
                                            path, width, height, picture.channels, picture.texels.size()),
                     .hint = fmt::format("from 1 x 1 to {0} x {0} texels with 1 to 4 channels can be",
                                         image_io::kLargestSide)});
    const std::vector<uint8_t> bytes =
        encode(*format, image_io::with_channels(picture, stored_channels(*format, picture.channels)));
    if (bytes.empty())
        return fail({.code = "file_unwritable",
                     .message = fmt::format("cannot write `{}`: {} x {} texels cannot be encoded in this format", path,
                                            width, height)});
    return image_io::write_file(path, bytes);
}

} // namespace passgraph
