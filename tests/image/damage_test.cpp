// Cut and corrupted files of every format: an error or a picture, never a crash, and never a cut file taken for whole.
#include "support/catch.hpp"

#include <random>

#include "image/exr_files.hpp"
#include "image/scratch.hpp"

using passgraph::read_picture;
using passgraph::Transfer;

namespace
{

struct Sample {
    std::string name;
    std::vector<uint8_t> bytes;
};

std::vector<Sample> make_samples()
{
    const Scratch scratch;
    std::vector<Sample> samples;
    for (const std::string suffix : {"png", "jpg", "hdr", "exr", "pfm"}) {
        const std::string path = scratch / ("a." + suffix);
        REQUIRE(passgraph::write_picture(path, gradient({23, 19}, 3)));
        samples.push_back({"a." + suffix, read_bytes(path)});
    }
    for (const int compression : {TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_RLE,
                                  TINYEXR_COMPRESSIONTYPE_ZIP, TINYEXR_COMPRESSIONTYPE_PIZ})
        for (const int tile : {0, 8})
            samples.push_back({"b.exr", make_exr(23, 19,
                                                 {.names = {"B", "G", "R"},
                                                  .type = TINYEXR_PIXELTYPE_HALF,
                                                  .compression = compression,
                                                  .tile = tile})});
    return samples;
}

} // namespace

TEST_CASE("a file cut anywhere is an error", "[image][damage]")
{
    const Scratch scratch;
    for (const Sample& sample : make_samples()) {
        INFO(sample.name << " of " << sample.bytes.size());
        const std::string path = scratch / sample.name;
        // What may be missing at the end without any texel missing: a PNG's checksums and its end.
        const size_t spare = sample.name == "a.png" ? 20 : 0;
        const size_t step = 1 + sample.bytes.size() / 400;
        for (size_t length = 0; length < sample.bytes.size(); length += length < 600 ? 1 : step) {
            write_bytes(path, {sample.bytes.begin(), sample.bytes.begin() + static_cast<std::ptrdiff_t>(length)});
            const auto read = read_picture(path, Transfer::decode_srgb);
            if (read && length + spare < sample.bytes.size())
                FAIL(sample.name << " is read when cut to " << length << " of " << sample.bytes.size());
        }
    }
}

TEST_CASE("corrupted files do not crash", "[image][damage]")
{
    const Scratch scratch;
    std::mt19937 random(7);
    for (const Sample& sample : make_samples()) {
        const std::string path = scratch / sample.name;
        for (int i = 0; i < 300; ++i) {
            std::vector<uint8_t> bytes = sample.bytes;
            for (unsigned damage = 1 + random() % 4; damage > 0; --damage) {
                const bool is_early = random() % 2 == 0; // headers are short, and worth half of the attempts
                bytes[random() % (is_early ? std::min<size_t>(400, bytes.size()) : bytes.size())] =
                    static_cast<uint8_t>(random());
            }
            write_bytes(path, bytes);
            const auto read = read_picture(path, Transfer::decode_srgb);
            if (read && read->texels.empty())
                FAIL("a picture without texels");
        }
    }
    SUCCEED();
}
