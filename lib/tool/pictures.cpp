// Conversions between a picture file's numbers and a signal's values.
#include "tool/pictures.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <passgraph/image/image_file.hpp>

namespace passgraph::tool {
namespace {

bool is_radiance(Signal signal) { return signal == Signal::radiance || signal == Signal::radiance_alpha; }

/// Codes of a display are shares of a largest code: these signals are, too.
bool codes_can_hold(Signal signal)
{
    switch (signal) {
    case Signal::normal:
    case Signal::position:
    case Signal::velocity:
    case Signal::exposure: return false;
    default: return true;
    }
}

void premultiply(Picture& picture)
{
    for (size_t i = 0; i + 3 < picture.texels.size(); i += 4)
        for (size_t c = 0; c < 3; ++c)
            picture.texels[i + c] *= picture.texels[i + 3];
}

void make_straight(Picture& picture)
{
    for (size_t i = 0; i + 3 < picture.texels.size(); i += 4)
        for (size_t c = 0; c < 3; ++c)
            if (picture.texels[i + 3] > 0.0f)
                picture.texels[i + c] = std::min(picture.texels[i + c] / picture.texels[i + 3], 1.0f);
}

/// Source   IEC 61966-2-1.
float srgb_from_linear(float x)
{
    if (!(x > 0.0f))
        return 0.0f;
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

} // namespace

Result<Picture> read_values(const std::string& file, Signal signal)
{
    const Result<bool> holds_codes = holds_display_codes(file);
    const bool is_coded = holds_codes && *holds_codes;
    if (is_coded && !codes_can_hold(signal))
        return fail({.code = "codes_as_values",
                     .message = fmt::format("`{}` holds codes from 0 to 1, which cannot be read as {}", file, info(signal).name),
                     .hint = "give the values in an .exr or .pfm file"});
    const bool decodes = is_radiance(signal) || signal == Signal::albedo;
    Result<Picture> picture = read_picture(file, decodes ? Transfer::decode_srgb : Transfer::as_is);
    if (picture && is_coded && info(signal).has_alpha && picture->channels == 4)
        premultiply(*picture);
    return picture;
}

Result<void> check_file_holds(const std::string& file, Signal signal)
{
    const Result<bool> holds_codes = holds_display_codes(file);
    if (!holds_codes)
        return tl::unexpected(holds_codes.error());
    if (!*holds_codes)
        return {};
    const std::string kind = file.substr(file.rfind('.'));
    if (is_radiance(signal))
        return fail({.code = "radiance_to_png",
                     .message = fmt::format("`{}`: a {} file holds display codes, and this image is {}", file, kind, info(signal).name),
                     .hint = "put a tone_map before this output, or write an .exr file"});
    const bool is_written =
        signal == Signal::display || signal == Signal::display_alpha || signal == Signal::albedo || signal == Signal::mask;
    if (!is_written)
        return fail({.code = "values_to_png",
                     .message = fmt::format("`{}`: a {} file holds display codes, and this image is {}", file, kind, info(signal).name),
                     .hint = "write an .exr file, which holds the values as they are"});
    return {};
}

Picture file_numbers(Picture values, const std::string& file, Signal signal)
{
    const Result<bool> holds_codes = holds_display_codes(file);
    if (!holds_codes || !*holds_codes)
        return values;
    if (signal == Signal::albedo)
        std::transform(values.texels.begin(), values.texels.end(), values.texels.begin(), srgb_from_linear);
    if (info(signal).has_alpha)
        make_straight(values);
    return values;
}

} // namespace passgraph::tool
