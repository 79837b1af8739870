// Every error of reading and writing pictures, with the words that help.
#include "support/catch.hpp"

#include <csignal>
#include <cstring>

#include <sys/resource.h>

#include "image/exr_files.hpp"
#include "image/scratch.hpp"

using passgraph::Picture;
using passgraph::read_picture;
using passgraph::Transfer;
using passgraph::write_picture;

TEST_CASE("a missing file is named, with the nearest name in its folder", "[image][errors]")
{
    const Scratch scratch;
    REQUIRE(write_picture(scratch / "kitchen.png", gradient({2, 2}, 3)));
    const auto read = read_picture(scratch / "kitchne.png", Transfer::as_is);
    REQUIRE(code_of(read) == "file_missing");
    CHECK_THAT(read.error().front().message, Catch::Contains("kitchne.png"));
    CHECK_THAT(read.error().front().hint, Catch::Contains("`kitchen.png`"));
    const auto nowhere = read_picture(scratch / "no_folder/a.png", Transfer::as_is);
    REQUIRE(code_of(nowhere) == "file_missing");
    CHECK_THAT(nowhere.error().front().hint, Catch::Contains("no_folder"));
}

TEST_CASE("a folder is not a picture", "[image][errors]")
{
    const Scratch scratch;
    const auto read = read_picture(scratch.folder(), Transfer::as_is);
    REQUIRE(code_of(read) == "file_unreadable");
    CHECK_THAT(read.error().front().message, Catch::Contains("it is a folder"));
}

TEST_CASE("an empty file and a file of something else are malformed", "[image][errors]")
{
    const Scratch scratch;
    const std::string suffix = GENERATE("png", "jpg", "jpeg", "hdr", "exr", "pfm");
    const std::string path = scratch / ("a." + suffix);
    write_text(path, "");
    CHECK_THAT(read_picture(path, Transfer::as_is).error().front().message, Catch::Contains("it is empty"));
    write_text(path, "once upon a time");
    CHECK(code_of(read_picture(path, Transfer::as_is)) == "picture_malformed");
}

TEST_CASE("an unknown suffix is an error unless the content is known", "[image][errors]")
{
    const Scratch scratch;
    write_text(scratch / "a.gif", "GIF89a");
    const auto read = read_picture(scratch / "a.gif", Transfer::as_is);
    REQUIRE(code_of(read) == "picture_format");
    CHECK_THAT(read.error().front().hint, Catch::Contains(".png .jpg .jpeg .hdr .exr .pfm"));
    CHECK(code_of(write_picture(scratch / "b.gif", gradient({2, 2}, 3))) == "picture_format");
    CHECK(scratch.file_count() == 1);
    for (const std::string suffix : {"png", "jpg", "hdr", "exr", "pfm"}) {
        REQUIRE(write_picture(scratch / ("a." + suffix), gradient({4, 4}, 3)));
        std::filesystem::rename(scratch / ("a." + suffix), scratch / "a.unknown");
        CHECK(read_picture(scratch / "a.unknown", Transfer::as_is).has_value());
    }
}

TEST_CASE("a picture beyond 16384 texels is refused by its header alone", "[image][errors]")
{
    const Scratch scratch;
    const auto check = [&](const std::string& name, const std::vector<uint8_t>& bytes) {
        INFO(name);
        write_bytes(scratch / name, bytes);
        const auto read = read_picture(scratch / name, Transfer::as_is);
        REQUIRE(code_of(read) == "picture_too_large");
        CHECK_THAT(read.error().front().message, Catch::Contains("20000"));
    };
    const auto from_text = [](const std::string& text) { return std::vector<uint8_t>(text.begin(), text.end()); };
    check("a.pfm", from_text("PF\n20000 1\n-1\n"));
    check("a.hdr", from_text("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 4\n"));
    REQUIRE(write_picture(scratch / "a.png", gradient({4, 4}, 3)));
    std::vector<uint8_t> png = read_bytes(scratch / "a.png");
    png[18] = 20000 >> 8;
    png[19] = 20000 & 0xff;
    check("a.png", png);
    std::vector<uint8_t> exr = make_exr(4, 4, {.names = {"Y"}});
    const int32_t last = 19999;
    std::memcpy(&exr[exr_attribute(exr, "dataWindow") + 8], &last, sizeof last);
    check("a.exr", exr);
    REQUIRE(write_picture(scratch / "a.jpg", gradient({4, 4}, 3)));
    std::vector<uint8_t> jpeg = read_bytes(scratch / "a.jpg");
    const std::vector<uint8_t> frame = {0xff, 0xc0};
    auto at = std::search(jpeg.begin(), jpeg.end(), frame.begin(), frame.end());
    at[5] = 20000 >> 8;
    at[6] = 20000 & 0xff;
    check("b.jpg", jpeg);
    png[16] = 0x7f;
    write_bytes(scratch / "b.png", png);
    CHECK(code_of(read_picture(scratch / "b.png", Transfer::as_is)) == "picture_too_large");
}

TEST_CASE("a picture of no texels is malformed", "[image][errors]")
{
    const Scratch scratch;
    write_text(scratch / "a.pfm", "PF\n0 4\n-1\n");
    write_text(scratch / "a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 4\n");
    REQUIRE(write_picture(scratch / "a.png", gradient({4, 4}, 3)));
    std::vector<uint8_t> png = read_bytes(scratch / "a.png");
    png[19] = 0;
    write_bytes(scratch / "a.png", png);
    for (const std::string name : {"a.pfm", "a.hdr", "a.png"})
        CHECK(code_of(read_picture(scratch / name, Transfer::as_is)) == "picture_malformed");
}

TEST_CASE("a malformed header is refused with what should stand there", "[image][errors]")
{
    const Scratch scratch;
    const auto message = [&](const std::string& name, const std::string& text) {
        write_text(scratch / name, text);
        const auto read = read_picture(scratch / name, Transfer::as_is);
        REQUIRE(code_of(read) == "picture_malformed");
        return read.error().front().message;
    };
    CHECK_THAT(message("a.pfm", "PF\n4 x\n-1\n"), Catch::Contains("width and height"));
    CHECK_THAT(message("a.pfm", "PF\n-4 4\n-1\n"), Catch::Contains("width and height"));
    CHECK_THAT(message("a.pfm", "PF\n1 1\n0\n0123456789ab"), Catch::Contains("scale"));
    CHECK_THAT(message("a.pfm", "PF\n1 1\nnan\n0123456789ab"), Catch::Contains("scale"));
    CHECK_THAT(message("a.pfm", "PF\n1 1\n-1\n0123456789a"), Catch::Contains("12 bytes, but only 11"));
    CHECK_THAT(message("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234"), Catch::Contains("rgbe"));
    CHECK_THAT(message("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n"), Catch::Contains("no end"));
    CHECK_THAT(message("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+Y 1 +X 1\n1234"), Catch::Contains("-Y HEIGHT"));
    const std::string run_beyond_row("\2\2\0\x08\xff\1", 6);
    CHECK_THAT(message("a.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n" + run_beyond_row),
               Catch::Contains("run"));
}

TEST_CASE("a file in a missing folder cannot be written, and the hint makes the folder", "[image][errors]")
{
    const Scratch scratch;
    const auto written = write_picture(scratch / "no_folder/a.png", gradient({2, 2}, 3));
    REQUIRE(code_of(written) == "file_unwritable");
    CHECK_THAT(written.error().front().hint, Catch::Contains("mkdir -p") && Catch::Contains("no_folder"));
}

TEST_CASE("a picture that is none cannot be written", "[image][errors]")
{
    const Scratch scratch;
    const std::string suffix = GENERATE("png", "jpg", "hdr", "exr", "pfm");
    const std::string path = scratch / ("a." + suffix);
    CHECK(code_of(write_picture(path, Picture())) == "file_unwritable");
    CHECK(code_of(write_picture(path, Picture({4, 0}, 3))) == "file_unwritable");
    CHECK(code_of(write_picture(path, Picture({2, 2}, 5))) == "file_unwritable");
    CHECK(code_of(write_picture(path, Picture({16385, 1}, 1))) == "file_unwritable");
    Picture cut({2, 2}, 3);
    cut.texels.pop_back();
    CHECK(code_of(write_picture(path, cut)) == "file_unwritable");
    CHECK(scratch.file_count() == 0);
}

TEST_CASE("a failed write leaves the old file and nothing else", "[image][errors]")
{
    const Scratch scratch;
    REQUIRE(write_picture(scratch / "a.pfm", gradient({2, 2}, 3)));
    const std::vector<uint8_t> before = read_bytes(scratch / "a.pfm");
    rlimit old_limit{};
    ::getrlimit(RLIMIT_FSIZE, &old_limit);
    const rlimit limit{1000, old_limit.rlim_max};
    auto* const old_handler = std::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = write_picture(scratch / "a.pfm", gradient({64, 64}, 3));
    ::setrlimit(RLIMIT_FSIZE, &old_limit);
    std::signal(SIGXFSZ, old_handler);
    REQUIRE(code_of(written) == "file_unwritable");
    CHECK_THAT(written.error().front().message, Catch::Contains("too large"));
    CHECK(read_bytes(scratch / "a.pfm") == before);
    CHECK(scratch.file_count() == 1);
}

TEST_CASE("a folder is not overwritten", "[image][errors]")
{
    const Scratch scratch;
    std::filesystem::create_directories(scratch / "a.png");
    const auto written = write_picture(scratch / "a.png", gradient({2, 2}, 3));
    REQUIRE(code_of(written) == "file_unwritable");
    CHECK(scratch.file_count() == 1);
}

TEST_CASE("a written file replaces the old one and can be read by others", "[image]")
{
    const Scratch scratch;
    write_text(scratch / "a.png", "old");
    REQUIRE(write_picture(scratch / "a.png", gradient({2, 2}, 3)));
    CHECK(read_picture(scratch / "a.png", Transfer::as_is).has_value());
    CHECK(scratch.file_count() == 1);
    const auto permissions = std::filesystem::status(scratch / "a.png").permissions();
    CHECK((permissions & std::filesystem::perms::owner_read) != std::filesystem::perms::none);
    CHECK((permissions & std::filesystem::perms::owner_exec) == std::filesystem::perms::none);
}
