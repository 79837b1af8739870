// The sRGB decode as tables, and rounding to 8 bits.
#include "image/codes.hpp"

#include <cmath>

namespace passgraph::image_io
{

namespace
{

double decode_srgb(double code)
{
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

std::vector<float> make_table(int largest, Transfer transfer)
{
    std::vector<float> table;
    table.reserve(static_cast<size_t>(largest) + 1);
    for (int code = 0; code <= largest; ++code) {
        const double value = static_cast<double>(code) / largest;
        table.push_back(static_cast<float>(transfer == Transfer::decode_srgb ? decode_srgb(value) : value));
    }
    return table;
}

} // namespace

std::span<const float> code_values(int largest, Transfer transfer)
{
    static const std::vector<float> linear_8 = make_table(255, Transfer::as_is);
    static const std::vector<float> srgb_8 = make_table(255, Transfer::decode_srgb);
    if (largest == 255)
        return transfer == Transfer::decode_srgb ? srgb_8 : linear_8;
    static const std::vector<float> linear_16 = make_table(65535, Transfer::as_is);
    static const std::vector<float> srgb_16 = make_table(65535, Transfer::decode_srgb);
    return transfer == Transfer::decode_srgb ? srgb_16 : linear_16;
}

std::vector<uint8_t> to_codes(const Picture& picture)
{
    const size_t row = static_cast<size_t>(picture.extent.width) * static_cast<size_t>(picture.channels);
    std::vector<uint8_t> codes;
    codes.reserve(picture.texels.size());
    for (int y = picture.extent.height - 1; y >= 0; --y) {
        const float* values = picture.texels.data() + static_cast<size_t>(y) * row;
        for (size_t i = 0; i < row; ++i) {
            const float value = values[i] > 0 ? std::fmin(values[i], 1.0f) : 0.0f; // a NaN is not > 0
            codes.push_back(static_cast<uint8_t>(static_cast<double>(value) * 255 + 0.5));
        }
    }
    return codes;
}

} // namespace passgraph::image_io
