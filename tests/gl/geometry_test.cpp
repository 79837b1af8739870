// Geometry steps: elements, depth, culling, materials, lights.
#include <glm/gtc/matrix_transform.hpp>

#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr Extent kExtent{16, 16};

/// A square of side 2 around the origin, facing +Z, in two triangles.
Mesh square(int material)
{
    Mesh mesh;
    mesh.name = "square";
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
        mesh.vertices.push_back({glm::vec3(corner, 0.0f), glm::vec3(0, 0, 1), corner * 0.5f + 0.5f});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = material;
    return mesh;
}

/// Squares of material i are mesh i. The camera looks along -Z from the origin and sees 90 degrees.
Scene scene_with(std::vector<Material> materials)
{
    Scene scene;
    scene.camera.vertical_fov = glm::radians(90.0f);
    scene.materials = std::move(materials);
    for (size_t i = 0; i < scene.materials.size(); ++i)
        scene.meshes.push_back(square(static_cast<int>(i)));
    return scene;
}

Material colored(float r, float g, float b)
{
    Material material;
    material.base_color = {r, g, b, 1.0f};
    return material;
}

void place(Scene& scene, int mesh, const glm::mat4& world_from_model)
{
    scene.elements.push_back({"element", mesh, world_from_model});
}

glm::mat4 at(float x, float y, float z)
{
    return glm::translate(glm::mat4(1.0f), {x, y, z});
}

Plan geometry_plan(const std::string& value)
{
    PlanBuilder builder(kExtent);
    const int color = builder.slot(Format::rgba32f, "surface.color");
    const int depth = builder.slot(Format::depth32f, "surface.depth");
    builder.geometry("surface",
                     "layout(location = 0) out vec4 c;\n"
                     "void main() { c = " +
                         value + "; }\n",
                     {color}, depth);
    builder.output("color", color, Signal::radiance_alpha, "rgba32f");
    builder.output("depth", depth, Signal::depth, "depth32f");
    return builder.plan;
}

Picture draw(const Scene& scene, const std::string& value = "base_color()", const std::string& output = "color")
{
    Renderer renderer = make_renderer(geometry_plan(value));
    require_ok(renderer.set_scene(scene));
    return render_and_read(renderer, output);
}

} // namespace

TEST_CASE("an element covers its part of the picture, the rest is 0", "[gl][geometry]")
{
    Scene scene = scene_with({colored(1.0f, 0.0f, 1.0f)});
    place(scene, 0, at(0, 0, -2)); // half the picture's height
    const Picture picture = draw(scene);
    CHECK(picture.at(8, 8, 0) == 1.0f);
    CHECK(picture.at(8, 8, 1) == 0.0f);
    CHECK(picture.at(1, 8, 0) == 0.0f);
    CHECK(picture.at(1, 8, 3) == 0.0f);
    CHECK(picture.at(4, 4, 0) == 1.0f);
    CHECK(picture.at(3, 8, 0) == 0.0f);
}

TEST_CASE("the nearer element is seen, in whichever order they stand in the scene", "[gl][geometry]")
{
    for (const bool nearer_first : {true, false}) {
        Scene scene = scene_with({colored(1, 0, 0), colored(0, 1, 0)});
        place(scene, nearer_first ? 0 : 1, at(0, 0, nearer_first ? -1.5f : -3.0f));
        place(scene, nearer_first ? 1 : 0, at(0, 0, nearer_first ? -3.0f : -1.5f));
        const Picture picture = draw(scene);
        CHECK(picture.at(8, 8, 0) == 1.0f);
        CHECK(picture.at(8, 8, 1) == 0.0f);
    }
}

TEST_CASE("depth is reversed: near / distance near by, 0 where nothing is", "[gl][geometry]")
{
    const float near = 0.1f;
    const float far = 1000.0f;
    Scene scene = scene_with({Material{}});
    place(scene, 0, at(0, 0, -2));
    // z/w for reversed depth: near (far - d) / (d (far - near)).
    const double expected = near * (far - 2.0) / (2.0 * (far - near));
    const auto depth_of = [&](const RendererOptions& options) {
        Renderer renderer = make_renderer(geometry_plan("vec4(1)"), options);
        require_ok(renderer.set_scene(scene));
        return render_and_read(renderer, "depth");
    };
    SECTION("with glClipControl")
    {
        const Picture depth = depth_of({});
        CHECK(depth.channels == 1);
        CHECK(depth.at(8, 8) == Approx(expected).epsilon(1e-5));
        CHECK(depth.at(0, 0) == 0.0f);
    }
    SECTION("without it, at the precision of -1..1")
    {
        const auto clip_control = gl_function<PFNGLCLIPCONTROLPROC>("glClipControl");
        clip_control(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE); // as in a context that lacks the function
        reset_spy().hidden = {"glClipControl"};
        const Picture depth = depth_of({.loader = spying_loader()});
        CHECK(depth.at(8, 8) == Approx(expected).epsilon(1e-4));
        CHECK(depth.at(0, 0) == 0.0f);
        reset_spy();
    }
}

TEST_CASE("back faces are culled unless the material is double-sided", "[gl][geometry]")
{
    Material both = colored(1, 1, 1);
    both.is_double_sided = true;
    const glm::mat4 turned = at(0, 0, -2) * glm::rotate(glm::mat4(1.0f), glm::radians(180.0f), {0, 1, 0});
    Scene single = scene_with({colored(1, 1, 1)});
    place(single, 0, turned);
    CHECK(draw(single).at(8, 8) == 0.0f);
    Scene twofold = scene_with({both});
    place(twofold, 0, turned);
    CHECK(draw(twofold).at(8, 8) == 1.0f);
    CHECK(draw(twofold, "vec4(gl_FrontFacing ? 1.0 : 0.5)").at(8, 8) == 0.5f);
}

TEST_CASE("a mirrored element still shows its front, and says that it is mirrored", "[gl][geometry]")
{
    Scene scene = scene_with({colored(1, 1, 1)});
    place(scene, 0, at(0, 0, -2) * glm::scale(glm::mat4(1.0f), {-1, 1, 1}));
    CHECK(draw(scene).at(8, 8) == 1.0f);
    CHECK(draw(scene, "vec4(gl_FrontFacing ? 1.0 : 0.5)").at(8, 8) == 1.0f);
    CHECK(draw(scene, "vec4(normalize(view_normal), texel(3).w)").texels[(8 * 16 + 8) * 4 + 2] == 1.0f);
    CHECK(draw(scene, "texel(3)").at(8, 8, 3) == 1.0f);
    // Beside one that is not mirrored, drawn before or after.
    place(scene, 0, at(0, 0, -1.5f));
    CHECK(draw(scene, "texel(3)").at(8, 8, 3) == 0.0f);
    CHECK(draw(scene).at(8, 8) == 1.0f);
}

TEST_CASE("an element's rows hold its place, normals and material as documented", "[gl][geometry]")
{
    Material material = colored(0.5f, 0.25f, 0.125f);
    material.metallic = 0.25f;
    material.roughness = 0.5f;
    material.specular = 0.75f;
    material.emissive = {3, 4, 5};
    Scene scene = scene_with({material});
    scene.camera.position = {1, 2, 3};
    place(scene, 0, at(1, 2, 1) * glm::scale(glm::mat4(1.0f), {2, 4, 1}));
    const auto texel = [&](int i) {
        const Picture picture = draw(scene, "texel(" + std::to_string(i) + ")");
        const float* found = &picture.texels[(8 * 16 + 8) * 4];
        return std::vector<float>(found, found + 4);
    };
    using V = std::vector<float>;
    CHECK(texel(0) == V{2, 0, 0, 0});
    CHECK(texel(1) == V{0, 4, 0, 0});
    CHECK(texel(2) == V{0, 0, 1, -2});
    // Cofactors of diag(2, 4, 1) are (4, 2, 8), the largest made 1.
    CHECK(texel(3) == V{0.5f, 0, 0, 0});
    CHECK(texel(4) == V{0, 0.25f, 0, 0});
    CHECK(texel(5) == V{0, 0, 1, 0});
    CHECK(texel(6) == V{1, 1, 0, 0}); // one texel, its own last level, repeated
    // The material in 8 bits, the emission in halves.
    const Picture matter = draw(scene, "in_atlas(passgraph_atlas_material, vec2(0.5))");
    for (const auto& [channel, value] : {std::pair(0, 0.75f), {1, 0.5f}, {2, 0.25f}})
        CHECK(matter.at(8, 8, channel) == Approx(value).margin(0.51 / 255));
    CHECK(draw(scene, "in_atlas(passgraph_atlas_emissive, vec2(0.5))").at(8, 8, 2) == 5.0f);
}

TEST_CASE("a million metres from the origin the picture is the same", "[gl][geometry]")
{
    const auto picture_at = [](const glm::dvec3& origin) {
        Scene scene = scene_with({colored(1, 1, 1)});
        scene.camera.position = origin;
        place(scene, 0, at(0, 0, -2));
        scene.elements[0].world_from_model[3] += glm::dvec4(origin, 0.0);
        return draw(scene, "vec4(view_position, 1.0)").texels;
    };
    CHECK(picture_at({1048576, -2097152, 524288}) == picture_at({0, 0, 0}));
}

TEST_CASE("material textures are read from the atlas, white where there is none", "[gl][geometry]")
{
    Material plain = colored(1, 1, 1);
    Material textured = plain;
    textured.base_color_texture = 0;
    Scene scene = scene_with({plain, textured});
    scene.textures = {{"two", {2, 1}, {255, 0, 0, 255, 0, 255, 0, 255}, Wrap::repeat, Wrap::repeat, true}};
    const auto seen = [&](int mesh, const std::string& u) {
        scene.elements.clear();
        place(scene, mesh, at(0, 0, -1));
        const Picture picture = draw(scene, "in_atlas(passgraph_atlas_albedo, vec2(" + u + ", 0.5))");
        return std::pair(picture.at(4, 8, 0), picture.at(4, 8, 1));
    };
    CHECK(seen(0, "0.25") == std::pair(1.0f, 1.0f));
    CHECK(seen(1, "0.25") == std::pair(1.0f, 0.0f));
    CHECK(seen(1, "0.75") == std::pair(0.0f, 1.0f));
    // At the border, half of what the wrap mode continues with.
    CHECK(seen(1, "0.0").second == Approx(0.5).margin(1e-3));
    scene.textures[0].wrap_u = Wrap::clamp;
    CHECK(seen(1, "0.0") == std::pair(1.0f, 0.0f));
}

TEST_CASE("lights arrive in view space, in any number", "[gl][geometry]")
{
    PlanBuilder builder({1, 1});
    const int slot = builder.slot(Format::rgba32f, "seen");
    Plan::Step& step =
        builder.draw("lit",
                     "uniform samplerBuffer passgraph_lights;\nuniform int row;\n"
                     "layout(std140) uniform passgraph_frame_block { float time; float delta; int index; int is_cut; "
                     "int light_count; };\n"
                     "layout(location = 0) out vec4 c;\n"
                     "void main() { c = light_count == 0 ? vec4(-1.0) : texelFetch(passgraph_lights, row); }\n",
                     {slot});
    step.host = {.camera = true, .lights = true, .frame = true, .elements = false};
    step.uniforms = {{"row", "lit.row", ParamType::int_, Value(0.0), 0.0, 100.0}};
    builder.plan.outputs = {{"color",
                             "seen",
                             Plan::Read::Source::slot,
                             slot,
                             Signal::radiance_alpha,
                             *find_codec(Signal::radiance_alpha, "rgba32f"),
                             {1, 1}}};
    Renderer renderer = make_renderer(builder.plan);
    CHECK(codes(renderer.render()) == std::vector<std::string>{"scene_missing"});
    using V = std::vector<float>;
    Scene dark;
    require_ok(renderer.set_scene(dark));
    CHECK(render_and_read(renderer).texels == V{-1, -1, -1, -1});

    Scene scene;
    scene.camera.position = {10, 0, 0};
    scene.camera.direction = {1, 0, 0}; // view +X is world +Z, view -Z is world +X
    Light sun;
    sun.color = {1, 2, 3};
    sun.direction = {0, -1, 0};
    Light lamp;
    lamp.kind = Light::Kind::point;
    lamp.color = {4, 5, 6};
    lamp.position = {14, 1, 2};
    lamp.radius = 7;
    Light torch = lamp;
    torch.kind = Light::Kind::spot;
    torch.direction = {2, 0, 0}; // of any length
    torch.inner_angle = 0.0f;
    torch.outer_angle = 1.0471976f; // 60 degrees: a ramp of 1 / (1 - 0.5)
    Light off = lamp;
    off.radius = 0;
    scene.lights = {sun, lamp, torch, off};
    require_ok(renderer.set_scene(scene));
    const std::vector<V> expected = {{1, 2, 3, 0}, {0, 1, 0, 0}, {0, 0, 0, 1},
                                     {4, 5, 6, 1.0f / 49.0f}, {2, 1, -4, 1}, {0, 0, 0, 1},
                                     {4, 5, 6, 1.0f / 49.0f}, {2, 1, -4, 1}, {0, 0, -2, -1},
                                     {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}};
    for (size_t row = 0; row < expected.size(); ++row) {
        CAPTURE(row);
        require_ok(renderer.set("lit.row", static_cast<double>(row)));
        const V seen = render_and_read(renderer).texels;
        for (size_t i = 0; i < 4; ++i)
            CHECK(seen[i] == Approx(expected[row][i]).margin(1e-6));
    }
    require_ok(renderer.set("lit.row", 3.0));
    CHECK(render_and_read(renderer).at(0, 0, 3) * 49.0f >= 1.0f); // rounded up: at the radius the light is over
}

TEST_CASE("a scene whose indices point outside is refused, naming each", "[gl][geometry]")
{
    Renderer renderer = make_renderer(geometry_plan("vec4(1)"));
    Scene scene = scene_with({Material{}});
    scene.textures = {{"small", {1, 1}, {1, 2, 3}, Wrap::repeat, Wrap::repeat, false},
                      {"huge", {1 << 20, 1}, {}, Wrap::repeat, Wrap::repeat, false}};
    scene.materials[0].emissive_texture = 2;
    scene.materials[0].specular_texture = -2;
    scene.meshes[0].indices.push_back(4);
    scene.meshes.push_back(square(1));
    place(scene, 2, glm::mat4(1.0f));
    const Result<void> result = renderer.set_scene(scene);
    CHECK(codes(result) == std::vector<std::string>{"scene_malformed", "scene_malformed", "scene_malformed",
                                                    "scene_malformed", "scene_malformed", "scene_malformed",
                                                    "texture_too_large", "scene_malformed"});
    CHECK(result.error()[6].fault == Fault::machine);
    CHECK(result.error()[6].message.find("`huge`") != std::string::npos);
    CHECK(codes(renderer.render()) == std::vector<std::string>{"scene_missing"});
}

TEST_CASE("a scene without elements draws nothing", "[gl][geometry]")
{
    Scene scene;
    CHECK(draw(scene, "vec4(1)").at(3, 3) == 0.0f);
}

TEST_CASE("a frame's own camera is used instead of the scene's, and moves the elements", "[gl][geometry]")
{
    Scene scene = scene_with({colored(1, 1, 1)});
    place(scene, 0, at(0, 0, -2));
    Renderer renderer = make_renderer(geometry_plan("base_color()"));
    require_ok(renderer.set_scene(scene));
    CHECK(render_and_read(renderer).at(8, 8) == 1.0f);
    Camera away = scene.camera;
    away.position = {100, 0, 0};
    CHECK(render_and_read(renderer, "color", {.camera = &away}).at(8, 8) == 0.0f);
    CHECK(render_and_read(renderer).at(8, 8) == 1.0f);
}

TEST_CASE("a full-screen step after a mirrored element is not culled", "[gl][geometry]")
{
    Scene scene = scene_with({colored(1, 1, 1)});
    place(scene, 0, at(0, 0, -2) * glm::scale(glm::mat4(1.0f), {-1, 1, 1}));
    PlanBuilder builder(kExtent);
    builder.plan = geometry_plan("vec4(1)");
    const int slot = builder.slot(Format::rgba32f, "after");
    builder.draw("after", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(2.0); }\n", {slot});
    builder.output("after", slot, Signal::radiance, "rgba32f");
    Renderer renderer = make_renderer(builder.plan);
    require_ok(renderer.set_scene(scene));
    CHECK(render_and_read(renderer, "after").at(8, 8) == 2.0f);
}

TEST_CASE("a plan of another aspect sees the same scene through another camera block", "[gl][geometry]")
{
    Scene scene = scene_with({colored(1, 1, 1)});
    place(scene, 0, at(0, 0, -2));
    Renderer renderer = make_renderer(geometry_plan("vec4(1)"));
    require_ok(renderer.set_scene(scene));
    CHECK(render_and_read(renderer).at(2, 8) == 0.0f);
    Plan wide = geometry_plan("vec4(1)"); // squeezed into the same texels, the square is half as wide
    wide.extent = {32, 16};
    require_ok(renderer.replace(wide));
    const Picture picture = render_and_read(renderer);
    CHECK(picture.at(8, 8) == 1.0f);
    CHECK(picture.at(5, 8) == 0.0f);
}
