// PNG and JPEG: codes, their decoding, and the rounding on the way out.
#include "support/catch.hpp"

#include <chrono>
#include <cmath>
#include <limits>

#include <stb_image_write.h>

#include "image/scratch.hpp"

using passgraph::Picture;
using passgraph::read_picture;
using passgraph::Transfer;
using passgraph::write_picture;

namespace
{

double decode_srgb(double code)
{
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

void append_u32(std::vector<uint8_t>& bytes, uint32_t value)
{
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<uint8_t>(value >> shift & 0xff));
}

/// Appends a chunk; its checksum is 0, which stb does not read.
void append_chunk(std::vector<uint8_t>& png, const std::string& name, const std::vector<uint8_t>& data)
{
    append_u32(png, static_cast<uint32_t>(data.size()));
    png.insert(png.end(), name.begin(), name.end());
    png.insert(png.end(), data.begin(), data.end());
    append_u32(png, 0);
}

/// A grey PNG of one row of 16-bit codes, stored without compression.
std::vector<uint8_t> png_of_16_bits(const std::vector<uint16_t>& codes)
{
    std::vector<uint8_t> header;
    append_u32(header, static_cast<uint32_t>(codes.size()));
    append_u32(header, 1);
    header.insert(header.end(), {16, 0, 0, 0, 0});
    const auto size = static_cast<uint16_t>(1 + 2 * codes.size());
    const auto low = static_cast<uint8_t>(size & 0xff);
    const auto high = static_cast<uint8_t>(size >> 8);
    std::vector<uint8_t> data = {0x78, 0x01, 1, low, high, static_cast<uint8_t>(~low), static_cast<uint8_t>(~high), 0};
    for (const uint16_t code : codes) {
        data.push_back(static_cast<uint8_t>(code >> 8));
        data.push_back(static_cast<uint8_t>(code & 0xff));
    }
    append_u32(data, 0);
    std::vector<uint8_t> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    append_chunk(png, "IHDR", header);
    append_chunk(png, "IDAT", data);
    append_chunk(png, "IEND", {});
    return png;
}

} // namespace

TEST_CASE("a PNG keeps every code of 1, 3 and 4 channels", "[image][png]")
{
    const Scratch scratch;
    const int channels = GENERATE(1, 3, 4);
    const Picture picture = gradient({16, 17}, channels);
    REQUIRE(write_picture(scratch / "a.png", picture));
    const auto read = read_picture(scratch / "a.png", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->extent == picture.extent);
    CHECK(read->channels == channels);
    CHECK(read->texels == picture.texels);
}

TEST_CASE("all 256 codes decode as the standard's formula says, and alpha stays", "[image][png]")
{
    const Scratch scratch;
    Picture picture({256, 1}, 4);
    for (int x = 0; x < 256; ++x)
        for (int c = 0; c < 4; ++c)
            picture.at(x, 0, c) = static_cast<float>(x) / 255.0f;
    REQUIRE(write_picture(scratch / "a.png", picture));
    const auto read = read_picture(scratch / "a.png", Transfer::decode_srgb);
    REQUIRE(read);
    for (int x = 0; x < 256; ++x) {
        CHECK(read->at(x, 0, 1) == static_cast<float>(decode_srgb(x / 255.0)));
        CHECK(read->at(x, 0, 3) == static_cast<float>(x / 255.0));
    }
}

TEST_CASE("a grey PNG is decoded too", "[image][png]")
{
    const Scratch scratch;
    Picture picture({1, 1}, 1);
    picture.texels = {128.0f / 255.0f};
    REQUIRE(write_picture(scratch / "a.png", picture));
    CHECK(read_picture(scratch / "a.png", Transfer::decode_srgb)->at(0, 0) ==
          static_cast<float>(decode_srgb(128 / 255.0)));
}

TEST_CASE("a PNG of 16 bits is read at 16 bits", "[image][png]")
{
    const Scratch scratch;
    const std::vector<uint16_t> codes = {0, 1, 255, 256, 32769, 65534, 65535};
    write_bytes(scratch / "a.png", png_of_16_bits(codes));
    const auto plain = read_picture(scratch / "a.png", Transfer::as_is);
    const auto decoded = read_picture(scratch / "a.png", Transfer::decode_srgb);
    REQUIRE(plain);
    REQUIRE(decoded);
    CHECK(plain->channels == 1);
    for (int x = 0; x < static_cast<int>(codes.size()); ++x) {
        const double code = codes[static_cast<size_t>(x)] / 65535.0;
        CHECK(plain->at(x, 0) == static_cast<float>(code));
        CHECK(decoded->at(x, 0) == static_cast<float>(decode_srgb(code)));
    }
}

TEST_CASE("a PNG of grey and alpha becomes four channels", "[image][png]")
{
    const Scratch scratch;
    const std::vector<uint8_t> codes = {10, 20, 30, 40};
    REQUIRE(stbi_write_png((scratch / "a.png").c_str(), 2, 1, 2, codes.data(), 4));
    const auto read = read_picture(scratch / "a.png", Transfer::as_is);
    REQUIRE(read);
    REQUIRE(read->channels == 4);
    CHECK(read->at(1, 0, 0) == 30.0f / 255.0f);
    CHECK(read->at(1, 0, 2) == 30.0f / 255.0f);
    CHECK(read->at(1, 0, 3) == 40.0f / 255.0f);
}

TEST_CASE("a PNG's first row is the picture's top", "[image][png]")
{
    const Scratch scratch; // written by stb alone, so that two wrong flips cannot hide
    const std::vector<uint8_t> codes = {255, 0};
    REQUIRE(stbi_write_png((scratch / "a.png").c_str(), 1, 2, 1, codes.data(), 1));
    const auto read = read_picture(scratch / "a.png", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->at(0, 1) == 1.0f);
    CHECK(read->at(0, 0) == 0.0f);
}

TEST_CASE("values are clamped and rounded to the nearest code, and NaN is 0", "[image][png]")
{
    const Scratch scratch;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Picture picture({8, 1}, 1);
    picture.texels = {-1.0f,
                      2.0f,
                      std::numeric_limits<float>::quiet_NaN(),
                      kInfinity,
                      -kInfinity,
                      0.499f / 255.0f,
                      0.501f / 255.0f,
                      254.501f / 255.0f};
    REQUIRE(write_picture(scratch / "a.png", picture));
    const auto read = read_picture(scratch / "a.png", Transfer::as_is);
    REQUIRE(read);
    CHECK(read->texels == std::vector<float>{0, 1, 0, 1, 0, 0, 1.0f / 255.0f, 1});
}

TEST_CASE("a JPEG gives back smooth color within a few codes", "[image][jpeg]")
{
    const Scratch scratch;
    const std::string suffix = GENERATE("jpg", "jpeg", "JPG");
    const int channels = GENERATE(1, 3);
    Picture picture({33, 21}, channels);
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 33; ++x)
            for (int c = 0; c < channels; ++c)
                picture.at(x, y, c) = static_cast<float>(x + y + 10 * c) / 80.0f;
    const std::string path = scratch / ("a." + suffix);
    REQUIRE(write_picture(path, picture));
    const auto read = read_picture(path, Transfer::as_is);
    REQUIRE(read);
    REQUIRE(read->extent == picture.extent);
    CHECK(read->channels == 3); // stb writes grey as color
    for (int y = 0; y < 21; ++y)
        for (int x = 0; x < 33; ++x)
            CHECK(std::abs(read->at(x, y, 0) - picture.at(x, y, 0)) < 5.0f / 255.0f);
}

TEST_CASE("stb's compression level is left as it was", "[image][png]")
{
    const Scratch scratch;
    stbi_write_png_compression_level = 7;
    REQUIRE(write_picture(scratch / "a.png", gradient({4, 4}, 3)));
    CHECK(stbi_write_png_compression_level == 7);
    stbi_write_png_compression_level = 8;
}

TEST_CASE("codes of the display are in PNG and JPEG files only", "[image]")
{
    CHECK(*passgraph::holds_display_codes("a/b.png"));
    CHECK(*passgraph::holds_display_codes("b.JPG"));
    CHECK(*passgraph::holds_display_codes("b.jpeg"));
    CHECK_FALSE(*passgraph::holds_display_codes("b.exr"));
    CHECK_FALSE(*passgraph::holds_display_codes("b.hdr"));
    CHECK_FALSE(*passgraph::holds_display_codes("b.pfm"));
    CHECK(code_of(passgraph::holds_display_codes("b.gif")) == "picture_format");
    CHECK(code_of(passgraph::holds_display_codes("png")) == "picture_format");
}
