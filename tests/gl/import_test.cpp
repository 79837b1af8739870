// Imports: pictures, cube maps and textures of the host.
#include <limits>

#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Kind = Plan::Import::Kind;

namespace {

/// Copies the import `picture` to the output "color", which has an alpha.
Plan copy_plan(Extent extent, Signal signal = Signal::radiance)
{
    PlanBuilder builder(extent);
    const int import = builder.import(Kind::picture, "picture", signal, extent);
    const int slot = builder.slot(Format::rgba32f, "copy");
    builder
        .draw("copy",
              "uniform sampler2D source;\nlayout(location = 0) out vec4 c;\nvoid main() { c = texture(source, uv); }\n",
              {slot})
        .reads = {read_import(import, "source")};
    builder.output("color", slot, Signal::radiance_alpha, "rgba32f");
    builder.output_import("same", import);
    return builder.plan;
}

/// Looks along `direction` into the cube map `cube` at a level.
Plan cube_plan(Kind kind, const std::string& direction, const std::string& lod = "0.0")
{
    PlanBuilder builder({1, 1});
    const int import = builder.import(kind, "cube", Signal::radiance);
    const int slot = builder.slot(Format::rgba32f, "seen");
    builder
        .draw("look",
              "uniform samplerCube cube;\nlayout(location = 0) out vec4 c;\n"
              "void main() { c = textureLod(cube, " +
                  direction + ", " + lod + "); }\n",
              {slot})
        .reads = {read_import(import, "cube", true)};
    builder.output("color", slot, Signal::radiance, "rgba32f");
    return builder.plan;
}

std::array<Picture, 6> numbered_faces(int size)
{
    std::array<Picture, 6> faces;
    for (size_t i = 0; i < faces.size(); ++i) {
        faces[i] = Picture({size, size}, 3);
        for (float& value : faces[i].texels)
            value = static_cast<float>(i + 1);
    }
    return faces;
}

Picture picture_of(Extent extent, int channels, std::vector<float> texels)
{
    Picture picture(extent, channels);
    picture.texels = std::move(texels);
    return picture;
}

} // namespace

TEST_CASE("an imported picture arrives bit for bit, the bottom row first", "[gl][import]")
{
    Renderer renderer = make_renderer(copy_plan({2, 2}));
    const Picture given = picture_of({2, 2}, 3, {0.1f, 0.2f, 0.3f, 1, 2, 3, 4, 5, 6, 7, 8, 9e-9f});
    require_ok(renderer.import_picture("picture", given));
    const Picture seen = render_and_read(renderer);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            for (int c = 0; c < 3; ++c)
                CHECK(seen.at(x, y, c) == given.at(x, y, c));
            CHECK(seen.at(x, y, 3) == 1.0f);
        }
    CHECK(renderer.read("same")->texels == given.texels);
}

TEST_CASE("values outside the signal's domain are replaced on import", "[gl][import]")
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    Renderer renderer = make_renderer(copy_plan({2, 1}));
    require_ok(renderer.import_picture("picture", picture_of({2, 1}, 3, {nan, -1, 0.5f, inf, 1e9f, -inf})));
    const Picture seen = render_and_read(renderer);
    CHECK(seen.texels == std::vector<float>{0, 0, 0.5f, 1, 65504, 65504, 0, 1});
}

TEST_CASE("channels a picture lacks are filled in", "[gl][import]")
{
    const auto imported = [](Signal signal, int channels, std::vector<float> texel) {
        Renderer renderer = make_renderer(copy_plan({1, 1}, signal));
        require_ok(renderer.import_picture("picture", picture_of({1, 1}, channels, std::move(texel))));
        return render_and_read(renderer).texels;
    };
    using V = std::vector<float>;
    CHECK(imported(Signal::radiance, 1, {0.5f}) == V{0.5f, 0.5f, 0.5f, 1});
    CHECK(imported(Signal::radiance_alpha, 1, {0.5f}) == V{0.5f, 0.5f, 0.5f, 1});
    CHECK(imported(Signal::radiance_alpha, 2, {0.5f, 0.25f}) == V{0.5f, 0.5f, 0.5f, 0.25f});
    CHECK(imported(Signal::radiance_alpha, 3, {1, 2, 3}) == V{1, 2, 3, 1});
    CHECK(imported(Signal::radiance, 4, {1, 2, 3, 0.5f}) == V{1, 2, 3, 1});
    CHECK(imported(Signal::mask, 1, {0.5f}) == V{0.5f, 0, 0, 1});
    CHECK(imported(Signal::mask, 3, {0.5f, 0.25f, 0.125f}) == V{0.5f, 0, 0, 1});
    CHECK(imported(Signal::velocity, 2, {-3, 4}) == V{-3, 4, 0, 1});
    CHECK(imported(Signal::normal, 1, {0}) == V{0, 0, 1, 1});
}

TEST_CASE("a picture imported again takes the old one's texture", "[gl][import]")
{
    Renderer renderer = make_renderer(copy_plan({1, 1}));
    require_ok(renderer.import_picture("picture", picture_of({1, 1}, 1, {1})));
    const auto before = renderer.counters().objects_created;
    require_ok(renderer.import_picture("picture", picture_of({1, 1}, 1, {2})));
    CHECK(renderer.counters().objects_created == before);
    CHECK(render_and_read(renderer).at(0, 0) == 2.0f);
}

TEST_CASE("a picture of another extent than the plan's is refused, naming both", "[gl][import]")
{
    Renderer renderer = make_renderer(copy_plan({2, 2}));
    const Result<void> result = renderer.import_picture("picture", Picture({3, 2}, 3));
    REQUIRE(codes(result) == std::vector<std::string>{"import_extent"});
    CHECK(result.error()[0].message == "`picture` has 3 x 2 texels, but the plan was compiled for 2 x 2");
    CHECK_FALSE(result.error()[0].hint.empty());
}

TEST_CASE("an unknown import, and one of the wrong kind, are refused", "[gl][import]")
{
    Renderer renderer = make_renderer(copy_plan({2, 2}));
    CHECK(codes(renderer.import_picture("pictrue", Picture({2, 2}, 3))) == std::vector<std::string>{"unknown_import"});
    CHECK(codes(renderer.import_cube("picture", numbered_faces(1))) == std::vector<std::string>{"wrong_import_kind"});
    Renderer looking = make_renderer(cube_plan(Kind::cube, "vec3(1, 0, 0)"));
    CHECK(codes(looking.import_picture("cube", Picture({1, 1}, 3))) == std::vector<std::string>{"wrong_import_kind"});
}

TEST_CASE("rendering without an import names it", "[gl][import]")
{
    Renderer renderer = make_renderer(copy_plan({2, 2}));
    const Result<void> result = renderer.render();
    REQUIRE(codes(result) == std::vector<std::string>{"import_missing"});
    CHECK(result.error()[0].message == "nothing was imported as `picture`");
    CHECK(codes(renderer.texture("same")) == std::vector<std::string>{"import_missing"});
}

TEST_CASE("a picture sampled with levels has the mean in its last one", "[gl][import]")
{
    PlanBuilder builder({4, 4});
    const int import = builder.import(Kind::picture, "picture", Signal::radiance, {4, 4});
    const int slot = builder.slot(Format::rgba32f, "mean");
    builder
        .draw("mean",
              "uniform sampler2D s;\nlayout(location = 0) out vec4 c;\nvoid main() { c = textureLod(s, uv, 2.0); }\n",
              {slot})
        .reads = {read_import(import, "s", true)};
    builder.output("color", slot, Signal::radiance, "rgba32f");
    Renderer renderer = make_renderer(builder.plan);
    for (const float height : {16.0f, 32.0f}) {
        Picture picture({4, 4}, 1);
        picture.at(1, 2) = height;
        require_ok(renderer.import_picture("picture", picture));
        CHECK(render_and_read(renderer).at(0, 0) == height / 16);
    }
}

TEST_CASE("a cube map's faces are +X -X +Y -Y +Z -Z", "[gl][import]")
{
    const std::array<const char*, 6> directions = {"vec3(1, 0, 0)",  "vec3(-1, 0, 0)", "vec3(0, 1, 0)",
                                                   "vec3(0, -1, 0)", "vec3(0, 0, 1)",  "vec3(0, 0, -1)"};
    for (size_t i = 0; i < directions.size(); ++i) {
        Renderer renderer = make_renderer(cube_plan(Kind::cube, directions[i]));
        require_ok(renderer.import_cube("cube", numbered_faces(4)));
        CHECK(render_and_read(renderer).at(0, 0) == static_cast<float>(i + 1));
    }
}

TEST_CASE("row 0 of a cube's face is OpenGL's first", "[gl][import]")
{
    // OpenGL 3.3, table 3.19: on +X, t = (-ry / |rx| + 1) / 2, so the first row (t = 0) is up.
    std::array<Picture, 6> faces = numbered_faces(2);
    faces[0].at(0, 0, 0) = faces[0].at(1, 0, 0) = 9.0f;
    Renderer up = make_renderer(cube_plan(Kind::cube, "vec3(1, 0.5, 0.5)"));
    require_ok(up.import_cube("cube", faces));
    CHECK(render_and_read(up).at(0, 0) == 9.0f);
}

TEST_CASE("a cube map's last level is what a rough surface sees around a direction", "[gl][import]")
{
    std::array<Picture, 6> faces = numbered_faces(2);
    for (float& texel : faces[0].texels)
        texel = 60.0f;
    const auto seen = [&](const char* direction) {
        Renderer renderer = make_renderer(cube_plan(Kind::cube, direction, "1.0"));
        require_ok(renderer.import_cube("cube", faces));
        return render_and_read(renderer).at(0, 0);
    };
    const float towards = seen("vec3(1, 0, 0)");
    const float beside = seen("vec3(0, 0, 1)");
    const float away = seen("vec3(-1, 0, 0)");
    CHECK(towards < 60.0f);
    CHECK(towards > beside);
    CHECK(beside > 6.0f);
    CHECK(away < 6.0f);
}

TEST_CASE("a linear read blends across the edge of two faces", "[gl][import]")
{
    Plan plan = cube_plan(Kind::cube, "vec3(1, 1, 0)");
    plan.steps[0].reads[0].filter = Filter::linear;
    Renderer renderer = make_renderer(plan);
    require_ok(renderer.import_cube("cube", numbered_faces(4))); // +X is 1, +Y is 3
    CHECK(render_and_read(renderer).at(0, 0) == Approx(2.0).epsilon(1.0 / 128));
}

TEST_CASE("faces that are not square or not equal are refused", "[gl][import]")
{
    Renderer renderer = make_renderer(cube_plan(Kind::cube, "vec3(1, 0, 0)"));
    std::array<Picture, 6> faces = numbered_faces(4);
    faces[2] = Picture({4, 3}, 3);
    faces[5] = Picture({2, 2}, 3);
    CHECK(codes(renderer.import_cube("cube", faces)) ==
          std::vector<std::string>{"cube_face_not_square", "cube_face_size"});
    CHECK(codes(renderer.render()) == std::vector<std::string>{"import_missing"});
}

TEST_CASE("an absent sky is black, the scene's is seen, and an imported one is preferred", "[gl][import]")
{
    Renderer renderer = make_renderer(cube_plan(Kind::sky, "vec3(0, 1, 0)"));
    CHECK(render_and_read(renderer).at(0, 0) == 0.0f);
    Scene scene;
    require_ok(renderer.set_scene(scene));
    CHECK(render_and_read(renderer).at(0, 0) == 0.0f);
    scene.sky.faces = numbered_faces(2);
    require_ok(renderer.set_scene(scene));
    CHECK(render_and_read(renderer).at(0, 0) == 3.0f);
    std::array<Picture, 6> faces = numbered_faces(1);
    faces[2].at(0, 0, 0) = 8.0f;
    require_ok(renderer.import_cube("cube", faces));
    CHECK(render_and_read(renderer).at(0, 0) == 8.0f);
}

TEST_CASE("a texture of the host is read in place", "[gl][import]")
{
    test_loader();
    GLuint id = 0;
    const float texels[] = {1, 2, 3, 4, 5, 6, 7, 8};
    gl_function<PFNGLGENTEXTURESPROC>("glGenTextures")(1, &id);
    gl_function<PFNGLBINDTEXTUREPROC>("glBindTexture")(GL_TEXTURE_2D, id);
    gl_function<PFNGLTEXIMAGE2DPROC>("glTexImage2D")(GL_TEXTURE_2D, 0, GL_RGBA32F, 2, 1, 0, GL_RGBA, GL_FLOAT, texels);
    {
        // Its own filter wants levels it does not have; the plan's samplers do not.
        Renderer renderer = make_renderer(copy_plan({2, 1}));
        CHECK(codes(renderer.import_texture("picture", {id, {1, 1}})) == std::vector<std::string>{"import_extent"});
        CHECK(codes(renderer.import_texture("picture", {999999, {2, 1}})) ==
              std::vector<std::string>{"texture_missing"});
        require_ok(renderer.import_texture("picture", {id, {2, 1}}));
        CHECK(render_and_read(renderer).texels == std::vector<float>(std::begin(texels), std::end(texels)));
        CHECK(renderer.read("same")->texels == std::vector<float>{1, 2, 3, 5, 6, 7});
        CHECK(renderer.texture("same")->id == id);
    }
    CHECK(gl_function<PFNGLISTEXTUREPROC>("glIsTexture")(id) == GL_TRUE);
    gl_function<PFNGLDELETETEXTURESPROC>("glDeleteTextures")(1, &id);
}

TEST_CASE("a host texture without levels is read at its only one where a step wants levels", "[gl][import]")
{
    test_loader();
    GLuint id = 0;
    const float texel[] = {1, 2, 3, 4};
    gl_function<PFNGLGENTEXTURESPROC>("glGenTextures")(1, &id);
    gl_function<PFNGLBINDTEXTUREPROC>("glBindTexture")(GL_TEXTURE_2D, id);
    gl_function<PFNGLTEXIMAGE2DPROC>("glTexImage2D")(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, texel);
    Plan plan = copy_plan({1, 1});
    plan.steps[0].reads[0].has_levels = true;
    {
        Renderer renderer = make_renderer(plan);
        require_ok(renderer.import_texture("picture", {id, {1, 1}}));
        CHECK(render_and_read(renderer).at(0, 0, 1) == 2.0f);
    }
    gl_function<PFNGLDELETETEXTURESPROC>("glDeleteTextures")(1, &id);
}
