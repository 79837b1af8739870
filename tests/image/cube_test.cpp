// Six files as one cube: their order, rows and channels, and what can be wrong with them.
#include "support/catch.hpp"

#include "image/scratch.hpp"

using passgraph::Picture;
using passgraph::read_cube;
using passgraph::Transfer;
using passgraph::write_picture;

namespace
{

const std::vector<std::string> kFaces = {"px", "nx", "py", "ny", "pz", "nz"};

/// Face i is i / 8 everywhere but in the top row, where it is 1.
void write_faces(const Scratch& scratch, int channels = 3)
{
    for (size_t i = 0; i < kFaces.size(); ++i) {
        Picture face({4, 4}, channels);
        std::fill(face.texels.begin(), face.texels.end(), static_cast<float>(i) / 8.0f);
        for (int x = 0; x < 4; ++x)
            for (int c = 0; c < channels; ++c)
                face.at(x, 3, c) = 1.0f;
        REQUIRE(write_picture(scratch / (kFaces[i] + (i % 2 ? ".exr" : ".pfm")), face));
    }
}

} // namespace

TEST_CASE("a cube's faces come in GL's order, with the file's top row first", "[image][cube]")
{
    const Scratch scratch;
    write_faces(scratch);
    const auto cube = read_cube(scratch.folder());
    REQUIRE(cube);
    for (size_t i = 0; i < 6; ++i) {
        CHECK((*cube)[i].extent == passgraph::Extent{4, 4});
        CHECK((*cube)[i].at(0, 0) == 1.0f);
        CHECK((*cube)[i].at(0, 3) == static_cast<float>(i) / 8.0f);
    }
}

TEST_CASE("a cube's faces have three channels whatever the files have", "[image][cube]")
{
    const Scratch scratch;
    const int channels = GENERATE(1, 4);
    write_faces(scratch, channels);
    const auto cube = read_cube(scratch.folder());
    REQUIRE(cube);
    CHECK((*cube)[2].channels == 3);
    CHECK((*cube)[2].at(1, 2, 2) == 0.25f);
}

TEST_CASE("a cube decodes display codes by default", "[image][cube]")
{
    const Scratch scratch;
    Picture half({2, 2}, 3);
    std::fill(half.texels.begin(), half.texels.end(), 128.0f / 255.0f);
    for (const std::string& face : kFaces)
        REQUIRE(write_picture(scratch / (face + ".png"), half));
    CHECK((*read_cube(scratch.folder()))[0].at(0, 0) == Approx(0.2158605));
    CHECK((*read_cube(scratch.folder(), Transfer::as_is))[0].at(0, 0) == 128.0f / 255.0f);
}

TEST_CASE("every absent or damaged face of a cube is named", "[image][cube]")
{
    const Scratch scratch;
    write_faces(scratch);
    std::filesystem::remove(scratch / "nx.exr");
    std::filesystem::remove(scratch / "nz.exr");
    write_text(scratch / "py.pfm", "PF\n4");
    const auto cube = read_cube(scratch.folder());
    REQUIRE_FALSE(cube);
    REQUIRE(cube.error().size() == 3);
    CHECK(cube.error()[0].code == "file_missing");
    CHECK_THAT(cube.error()[0].message, Catch::Contains("`nx`"));
    CHECK(cube.error()[1].code == "picture_malformed");
    CHECK_THAT(cube.error()[2].message, Catch::Contains("`nz`"));
}

TEST_CASE("a cube in a missing folder is missing", "[image][cube]")
{
    const Scratch scratch;
    const auto cube = read_cube(scratch / "sky");
    REQUIRE(code_of(cube) == "file_missing");
    CHECK_THAT(cube.error().front().message, Catch::Contains("sky"));
}

TEST_CASE("a cube's faces are square and of one size", "[image][cube]")
{
    const Scratch scratch;
    write_faces(scratch);
    REQUIRE(write_picture(scratch / "nx.exr", gradient({8, 8}, 3)));
    REQUIRE(write_picture(scratch / "pz.pfm", gradient({4, 5}, 3)));
    const auto cube = read_cube(scratch.folder());
    REQUIRE_FALSE(cube);
    REQUIRE(cube.error().size() == 2);
    CHECK(cube.error()[0].code == "cube_face_size");
    CHECK_THAT(cube.error()[0].message,
               Catch::Contains("`nx`") && Catch::Contains("8 x 8") && Catch::Contains("4 x 4"));
    CHECK(cube.error()[1].code == "cube_face_not_square");
    CHECK_THAT(cube.error()[1].message, Catch::Contains("`pz`") && Catch::Contains("4 x 5"));
}

TEST_CASE("the faces of a cube that differ from most are named, beside those that are missing", "[image][cube]")
{
    const Scratch scratch;
    write_faces(scratch);
    REQUIRE(write_picture(scratch / "px.pfm", gradient({8, 8}, 3)));
    REQUIRE(write_picture(scratch / "pz.pfm", gradient({4, 5}, 3)));
    std::filesystem::remove(scratch / "nz.exr");
    const auto cube = read_cube(scratch.folder());
    REQUIRE_FALSE(cube);
    REQUIRE(cube.error().size() == 3);
    CHECK_THAT(cube.error()[0].message, Catch::Contains("`nz`"));
    CHECK_THAT(cube.error()[1].message, Catch::Contains("`px`") && Catch::Contains("others have 4 x 4"));
    CHECK_THAT(cube.error()[2].message, Catch::Contains("`pz`"));
}
