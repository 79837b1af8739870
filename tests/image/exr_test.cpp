// EXR files made elsewhere: tiles, binary16, compressions, channel names, row orders, data windows.
#include "support/catch.hpp"

#include <cstring>

#include "image/exr_files.hpp"
#include "image/scratch.hpp"

using passgraph::Picture;
using passgraph::read_picture;
using passgraph::Transfer;

namespace
{

passgraph::Result<Picture> read_exr(const std::vector<uint8_t>& bytes)
{
    const Scratch scratch;
    write_bytes(scratch / "a.exr", bytes);
    return read_picture(scratch / "a.exr", Transfer::as_is);
}

/// Checks that channel `channel` of the picture is channel `stored` of the file.
void check_channel(const Picture& picture, int channel, size_t stored)
{
    for (int y = 0; y < picture.extent.height; ++y)
        for (int x = 0; x < picture.extent.width; ++x)
            if (picture.at(x, y, channel) != exr_value(stored, x, picture.extent.height - 1 - y)) {
                FAIL("channel " << channel << " at " << x << ", " << y << " is " << picture.at(x, y, channel));
            }
}

void put_i32(std::vector<uint8_t>& bytes, size_t at, int32_t value)
{
    std::memcpy(&bytes[at], &value, sizeof value);
}

} // namespace

TEST_CASE("EXR files in rows and in tiles are read with each lossless compression", "[image][exr]")
{
    const int compression =
        GENERATE(TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_RLE, TINYEXR_COMPRESSIONTYPE_ZIPS,
                 TINYEXR_COMPRESSIONTYPE_ZIP, TINYEXR_COMPRESSIONTYPE_PIZ);
    const int type = GENERATE(TINYEXR_PIXELTYPE_HALF, TINYEXR_PIXELTYPE_FLOAT);
    const int tile = GENERATE(0, 8, 16);
    const auto read = read_exr(
        make_exr(21, 43, {.names = {"A", "B", "G", "R"}, .type = type, .compression = compression, .tile = tile}));
    INFO((read ? std::string() : to_text(read.error())));
    REQUIRE(read);
    REQUIRE(read->extent == passgraph::Extent{21, 43});
    REQUIRE(read->channels == 4);
    for (int c = 0; c < 4; ++c)
        check_channel(*read, c, static_cast<size_t>(c == 3 ? 0 : 3 - c));
}

TEST_CASE("an EXR's row order is that of the file, not of the picture", "[image][exr]")
{
    std::vector<uint8_t> bytes = make_exr(5, 7, {.names = {"Y"}});
    bytes[exr_attribute(bytes, "lineOrder")] = 1;
    const auto read = read_exr(bytes);
    REQUIRE(read);
    check_channel(*read, 0, 0);
}

TEST_CASE("an EXR's data window may begin anywhere", "[image][exr]")
{
    std::vector<uint8_t> bytes = make_exr(4, 1, {.names = {"Y"}});
    const size_t window = exr_attribute(bytes, "dataWindow");
    put_i32(bytes, window, -3);
    put_i32(bytes, window + 8, 0);
    const auto read = read_exr(bytes);
    REQUIRE(read);
    CHECK(read->extent == passgraph::Extent{4, 1});
    check_channel(*read, 0, 0);
}

TEST_CASE("EXR channels are found by name", "[image][exr]")
{
    const auto read_named = [](const std::vector<std::string>& names) {
        return read_exr(make_exr(3, 2, {.names = names}));
    };
    CHECK(read_named({"Z"})->channels == 1);
    CHECK(read_named({"G", "R"})->channels == 2);
    const auto grey = read_named({"A", "Y"});
    REQUIRE(grey);
    REQUIRE(grey->channels == 4);
    check_channel(*grey, 0, 1);
    check_channel(*grey, 2, 1);
    check_channel(*grey, 3, 0);
}

TEST_CASE("an EXR of other channels is refused by their names", "[image][exr]")
{
    const auto names = GENERATE(std::vector<std::string>{"B", "G", "R", "Z"}, std::vector<std::string>{"X", "Y"},
                                std::vector<std::string>{"A", "B", "G", "R", "Z"},
                                std::vector<std::string>{"left.B", "left.G", "left.R"});
    const auto read = read_exr(make_exr(3, 2, {.names = names}));
    REQUIRE(code_of(read) == "picture_malformed");
    CHECK_THAT(read.error().front().message, Catch::Contains(names.front()) && Catch::Contains(names.back()));
    CHECK_THAT(read.error().front().hint, Catch::Contains("R, G, B and A"));
}

TEST_CASE("an EXR of integers or of coarser channels is refused", "[image][exr]")
{
    std::vector<uint8_t> bytes = make_exr(4, 2, {.names = {"Y"}});
    const size_t channels = exr_attribute(bytes, "channels");
    std::vector<uint8_t> of_integers = bytes;
    put_i32(of_integers, channels + 2, TINYEXR_PIXELTYPE_UINT);
    CHECK_THAT(read_exr(of_integers).error().front().message, Catch::Contains("integers"));
    put_i32(bytes, channels + 10, 2);
    CHECK_THAT(read_exr(bytes).error().front().message, Catch::Contains("lower resolution"));
}

TEST_CASE("an EXR that lies about its blocks is malformed", "[image][exr]")
{
    const int tile = GENERATE(0, 8);
    const std::vector<uint8_t> good = make_exr(16, 16, {.names = {"Y"}, .tile = tile});
    REQUIRE(read_exr(good));
    const size_t table = exr_table(good);
    const size_t block = static_cast<size_t>(good[table]) | static_cast<size_t>(good[table + 1]) << 8;
    const auto check_malformed = [&](size_t at, int32_t value, const std::string& part) {
        std::vector<uint8_t> bytes = good;
        put_i32(bytes, at, value);
        const auto read = read_exr(bytes);
        REQUIRE(code_of(read) == "picture_malformed");
        CHECK_THAT(read.error().front().message, Catch::Contains(part));
    };
    check_malformed(table, 0, "not written to its end");
    check_malformed(table, 0x7fffffff, "ends before");
    check_malformed(block, 5, "block");
    const size_t size = block + (tile == 0 ? 4u : 16u);
    check_malformed(size, 3, "block");
    check_malformed(size, -1, "ends before");
    check_malformed(size, 0x7fffffff, "ends before");
}

TEST_CASE("an EXR of several parts, unknown version, compression or shape is refused with a reason", "[image][exr]")
{
    const std::vector<uint8_t> good = make_exr(4, 4, {.names = {"Y"}, .tile = 4});
    const auto message_with = [&](size_t at, uint8_t value) {
        std::vector<uint8_t> bytes = good;
        bytes[at] = value;
        const auto read = read_exr(bytes);
        REQUIRE(code_of(read) == "picture_malformed");
        return read.error().front().message;
    };
    CHECK_THAT(message_with(4, 3), Catch::Contains("version 3"));
    CHECK_THAT(message_with(5, 0x12), Catch::Contains("several parts"));
    CHECK_THAT(message_with(5, 0x0a), Catch::Contains("deep"));
    CHECK_THAT(message_with(exr_attribute(good, "compression"), 7), Catch::Contains("compression 7"));
    CHECK_THAT(message_with(exr_attribute(good, "tiles"), 0), Catch::Contains("tiles"));
    CHECK_THAT(message_with(exr_attribute(good, "dataWindow") + 8, 0xff), Catch::Contains("not written to its end"));
    CHECK_THAT(message_with(exr_attribute(good, "dataWindow") + 11, 0x80), Catch::Contains("window"));
    CHECK_THAT(message_with(exr_attribute(good, "channels") - 4, 17), Catch::Contains("channels"));
}
