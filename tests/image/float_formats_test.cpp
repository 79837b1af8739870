// .pfm, .exr and .hdr: what is written comes back, bit by bit or within the format's own rounding.
#include "support/catch.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "image/scratch.hpp"

using passgraph::Extent;
using passgraph::Picture;
using passgraph::read_picture;
using passgraph::Transfer;
using passgraph::write_picture;

namespace
{

/// Numbers that are easily lost: NaN with a payload, infinities, -0, denormals, the largest and the smallest.
Picture difficult(Extent extent, int channels)
{
    const std::vector<uint32_t> bits = {0x7fc12345, 0xffc00001, 0x7f800000, 0xff800000, 0x80000000, 0x00000000,
                                        0x00000001, 0x807fffff, 0x7f7fffff, 0xff7fffff, 0x00800000, 0x3f800001};
    Picture picture(extent, channels);
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = i % 3 == 0 ? static_cast<float>(i) * 0.7f : std::bit_cast<float>(bits[i % bits.size()]);
    return picture;
}

bool is_equal_bitwise(const Picture& a, const Picture& b)
{
    if (a.extent != b.extent || a.channels != b.channels)
        return false;
    for (size_t i = 0; i < a.texels.size(); ++i)
        if (std::bit_cast<uint32_t>(a.texels[i]) != std::bit_cast<uint32_t>(b.texels[i]))
            return false;
    return true;
}

void append_big_endian(std::string& text, float value)
{
    const auto bits = std::bit_cast<uint32_t>(value);
    for (int shift = 24; shift >= 0; shift -= 8)
        text += static_cast<char>(bits >> shift & 0xff);
}

} // namespace

TEST_CASE("an EXR gives back every bit of 1, 3 and 4 channels", "[image][exr]")
{
    const Scratch scratch;
    const int channels = GENERATE(1, 3, 4);
    const Extent extent = GENERATE(Extent{1, 1}, Extent{1, 9}, Extent{17, 13}, Extent{64, 40});
    const Picture picture = difficult(extent, channels);
    REQUIRE(write_picture(scratch / "a.exr", picture));
    const auto read = read_picture(scratch / "a.exr", Transfer::decode_srgb); // floats are never decoded
    REQUIRE(read);
    CHECK(is_equal_bitwise(*read, picture));
}

TEST_CASE("a PFM gives back every bit of 1 and 3 channels", "[image][pfm]")
{
    const Scratch scratch;
    const int channels = GENERATE(1, 3);
    const Extent extent = GENERATE(Extent{1, 1}, Extent{1, 9}, Extent{17, 13});
    const Picture picture = difficult(extent, channels);
    REQUIRE(write_picture(scratch / "a.pfm", picture));
    const auto read = read_picture(scratch / "a.pfm", Transfer::decode_srgb);
    REQUIRE(read);
    CHECK(is_equal_bitwise(*read, picture));
}

TEST_CASE("a PFM's rows run upwards and its scale's sign is the byte order", "[image][pfm]")
{
    const Scratch scratch;
    std::string text = "Pf\n1 2\n1.0\n";
    append_big_endian(text, 0.25f);
    append_big_endian(text, 7.0f);
    write_text(scratch / "big.pfm", text);
    const auto read = read_picture(scratch / "big.pfm", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->at(0, 0) == 0.25f);
    CHECK(read->at(0, 1) == 7.0f);

    Picture picture({1, 2}, 1);
    picture.texels = {0.25f, 7.0f};
    REQUIRE(write_picture(scratch / "little.pfm", picture));
    const std::vector<uint8_t> bytes = read_bytes(scratch / "little.pfm");
    CHECK(std::string(bytes.begin(), bytes.begin() + 12) == "Pf\n1 2\n-1.0\n");
    CHECK(std::vector<uint8_t>(bytes.begin() + 12, bytes.begin() + 16) == std::vector<uint8_t>{0, 0, 0x80, 0x3e});
}

TEST_CASE("an HDR gives back radiance within one percent of a texel's largest channel", "[image][hdr]")
{
    const Scratch scratch;
    const Extent extent = GENERATE(Extent{1, 1}, Extent{7, 3}, Extent{8, 2}, Extent{131, 17});
    Picture picture(extent, 3);
    for (size_t i = 0; i < picture.texels.size(); ++i)
        picture.texels[i] = static_cast<float>(std::exp2(static_cast<double>(i % 41) - 20.0)) * 1.37f;
    for (size_t i = 0; i < picture.texels.size() / 2; ++i)
        picture.texels[i] = 3.25f; // runs
    REQUIRE(write_picture(scratch / "a.hdr", picture));
    const auto read = read_picture(scratch / "a.hdr", Transfer::decode_srgb);
    REQUIRE(read);
    REQUIRE(read->extent == extent);
    REQUIRE(read->channels == 3);
    for (size_t i = 0; i < picture.texels.size(); i += 3) {
        const float largest = std::max({picture.texels[i], picture.texels[i + 1], picture.texels[i + 2]});
        for (size_t c = 0; c < 3; ++c)
            CHECK(std::abs(read->texels[i + c] - picture.texels[i + c]) <= 0.01f * largest);
    }
}

TEST_CASE("an HDR holds what RGBE cannot say as the nearest thing it can", "[image][hdr]")
{
    const Scratch scratch;
    Picture picture({4, 1}, 1);
    picture.texels = {std::numeric_limits<float>::quiet_NaN(), -2.0f, std::numeric_limits<float>::infinity(), 1.0f};
    REQUIRE(write_picture(scratch / "a.hdr", picture));
    const auto read = read_picture(scratch / "a.hdr", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->at(0, 0) == 0.0f);
    CHECK(read->at(1, 0) == 0.0f);
    CHECK(read->at(2, 0) == 0x1.fep126f);
    CHECK(read->at(3, 0) == 1.0f);
}

TEST_CASE("an HDR of the old encoding repeats texels", "[image][hdr]")
{
    const Scratch scratch;
    std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 300\n";
    text += std::string("\x80\x40\x20\x81", 4);
    text += std::string("\x01\x01\x01\x2b", 4); // 43 times
    text += std::string("\x01\x01\x01\x01", 4); // and 256 times
    write_text(scratch / "old.hdr", text);
    const auto read = read_picture(scratch / "old.hdr", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->at(299, 0, 0) == 1.0f);
    CHECK(read->at(299, 0, 1) == 0.5f);
    CHECK(read->at(0, 0, 2) == 0.25f);
}

TEST_CASE("row 0 is the bottom row in every format", "[image]")
{
    const Scratch scratch;
    const std::string suffix = GENERATE("exr", "pfm", "hdr", "png", "jpg");
    Picture picture({16, 16}, 3);
    for (int x = 0; x < 16; ++x)
        for (int y = 0; y < 8; ++y)
            picture.at(x, y, 0) = 1.0f; // the lower half is red
    const std::string path = scratch / ("a." + suffix);
    REQUIRE(write_picture(path, picture));
    const auto read = read_picture(path, Transfer::as_is);
    REQUIRE(read);
    CHECK(read->at(3, 0, 0) == Approx(1.0).margin(0.02));
    CHECK(read->at(3, 15, 0) == Approx(0.0).margin(0.02));
}

TEST_CASE("the top row of a file comes first in it", "[image][hdr]")
{
    const Scratch scratch; // an independent witness: a round trip alone would hide two wrong flips
    std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n";
    text += std::string("\x80\x80\x80\x82\x80\x80\x80\x81", 8);
    write_text(scratch / "a.hdr", text);
    const auto read = read_picture(scratch / "a.hdr", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->at(0, 1) == 2.0f);
    CHECK(read->at(0, 0) == 1.0f);
}

TEST_CASE("two channels get a third of 0, and alpha is dropped where the format has none", "[image]")
{
    const Scratch scratch;
    const std::string suffix = GENERATE("exr", "pfm", "hdr", "png", "jpg");
    const bool has_alpha = suffix == "exr" || suffix == "png";
    const std::string path = scratch / ("a." + suffix);
    Picture two({8, 8}, 2);
    std::fill(two.texels.begin(), two.texels.end(), 1.0f);
    REQUIRE(write_picture(path, two));
    auto read = read_picture(path, Transfer::as_is);
    REQUIRE(read);
    CHECK(read->channels == 3);
    CHECK(read->at(2, 2, 1) == Approx(1.0).margin(0.02));
    CHECK(read->at(2, 2, 2) == Approx(0.0).margin(0.02));
    REQUIRE(write_picture(path, gradient({8, 8}, 4)));
    read = read_picture(path, Transfer::as_is);
    REQUIRE(read);
    CHECK(read->channels == (has_alpha ? 4 : 3));
}
