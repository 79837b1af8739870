// Objects over time: none made after the first frame, none left behind, plans replaced, renderers side by side.
#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

/// Reads the import `picture`, draws the scene, reads lights and sky: some of every kind of object.
Plan full_plan(Extent extent, const std::string& gain = "1.0")
{
    PlanBuilder builder(extent);
    const int picture = builder.import(Plan::Import::Kind::picture, "picture", Signal::radiance, {2, 2});
    const int sky = builder.import(Plan::Import::Kind::sky, "scene.sky", Signal::radiance);
    const int color = builder.slot(Format::rgba16f, "surface.color");
    const int depth = builder.slot(Format::depth32f, "surface.depth");
    const int out = builder.slot(Format::rgba32f, "mix.color");
    builder.geometry("surface", "layout(location = 0) out vec4 c;\nvoid main() { c = base_color(); }\n", {color}, depth);
    builder.draw(
        "mix",
        "uniform sampler2D picture;\nuniform sampler2D surface;\nuniform samplerCube sky;\nuniform float gain;\n"
        "layout(location = 0) out vec4 c;\n"
        "void main() { c = gain * " +
            gain + " * texture(picture, uv) + texture(surface, uv) + textureLod(sky, vec3(0, 1, 0), 0.0); }\n",
        {out});
    builder.plan.steps[1].reads = {read_import(picture, "picture"), read_slot(color, "surface"),
                                   read_import(sky, "sky", true)};
    builder.plan.steps[1].uniforms = {{"gain", "mix.gain", ParamType::float_, Value(1.0), 0.0, 10.0}};
    builder.output("color", out, Signal::radiance, "rgba32f");
    return builder.plan;
}

Scene small_scene()
{
    Scene scene;
    scene.materials = {Material{}};
    Mesh mesh;
    mesh.vertices.resize(3);
    mesh.indices = {0, 1, 2};
    scene.meshes = {mesh};
    scene.elements = {Element{}};
    scene.textures = {{"t", {1, 1}, {1, 2, 3, 4}, Wrap::repeat, Wrap::repeat, true}};
    scene.lights = {Light{}};
    return scene;
}

Picture filled(Extent extent, float value)
{
    Picture picture(extent, 3);
    for (float& texel : picture.texels)
        texel = value;
    return picture;
}

} // namespace

TEST_CASE("no object is created after the first frame, whatever a frame changes", "[gl][lifetime]")
{
    Scene scene = small_scene();
    Renderer renderer = make_renderer(full_plan({8, 8}), {.is_timed = true});
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.import_picture("picture", filled({2, 2}, 0.5f)));
    require_ok(renderer.render());
    const auto created = renderer.counters().objects_created;
    for (int frame = 1; frame < 5; ++frame) {
        scene.camera.position.x += 1.0f;
        require_ok(renderer.set("mix.gain", frame));
        require_ok(renderer.import_picture("picture", filled({2, 2}, static_cast<float>(frame))));
        render_and_read(renderer, "color", {.time = frame / 60.0, .index = frame});
        CHECK(renderer.step_times().size() == 2);
        CHECK(renderer.counters().objects_created == created);
    }
    CHECK(renderer.counters().draws == 5 * 2);
}

TEST_CASE("a destroyed renderer leaves no object behind, after failures too", "[gl][lifetime]")
{
    reset_spy();
    {
        Scene scene = small_scene();
        Renderer renderer = make_renderer(full_plan({8, 8}), {.loader = spying_loader(), .is_timed = true});
        require_ok(renderer.set_scene(scene));
        require_ok(renderer.import_picture("picture", filled({2, 2}, 0.5f)));
        render_and_read(renderer);
        CHECK(spy().objects_alive > 20);
        CHECK(codes(renderer.replace(full_plan({8, 8}, "broken"))).size() == 1);
        require_ok(renderer.replace(full_plan({4, 4})));
        require_ok(renderer.set_scene(scene));
        render_and_read(renderer);
    }
    CHECK(spy().objects_alive == 0);
    CHECK(Renderer::create(full_plan({8, 8}, "broken"), {.loader = spying_loader()}).has_value() == false);
    CHECK(spy().objects_alive == 0);
    reset_spy();
}

TEST_CASE("replacing a plan and back does not heap up objects", "[gl][lifetime]")
{
    reset_spy();
    Scene scene = small_scene();
    Renderer renderer = make_renderer(full_plan({8, 8}), {.loader = spying_loader()});
    const auto alive = spy().objects_alive;
    for (int i = 0; i < 3; ++i)
        require_ok(renderer.replace(full_plan({8, 8})));
    CHECK(spy().objects_alive == alive);
    reset_spy();
}

TEST_CASE("another plan keeps the scene and the imports", "[gl][lifetime]")
{
    Scene scene = small_scene();
    scene.sky.faces.fill(filled({1, 1}, 2.0f));
    Renderer renderer = make_renderer(full_plan({8, 8}));
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.import_picture("picture", filled({2, 2}, 0.5f)));
    CHECK(render_and_read(renderer).at(0, 0) == 2.5f);
    require_ok(renderer.replace(full_plan({16, 4}, "4.0")));
    const Picture picture = render_and_read(renderer);
    CHECK(picture.extent == Extent{16, 4});
    CHECK(picture.at(15, 3) == 4.0f);
}

TEST_CASE("an import whose extent changed has to be given again", "[gl][lifetime]")
{
    Scene scene = small_scene();
    Renderer renderer = make_renderer(full_plan({8, 8}));
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.import_picture("picture", filled({2, 2}, 0.5f)));
    Plan larger = full_plan({8, 8});
    larger.imports[0].extent = {3, 3};
    require_ok(renderer.replace(larger));
    CHECK(codes(renderer.render()) == std::vector<std::string>{"import_missing"});
    require_ok(renderer.import_picture("picture", filled({3, 3}, 0.25f)));
    CHECK(render_and_read(renderer).at(0, 0) == 0.25f);
}

TEST_CASE("an import gains levels when the new plan wants them", "[gl][lifetime]")
{
    const auto plan = [](bool has_levels, const std::string& lod) {
        PlanBuilder builder({1, 1});
        const int picture = builder.import(Plan::Import::Kind::picture, "picture", Signal::radiance, {2, 2});
        const int slot = builder.slot(Format::rgba32f, "image");
        builder
            .draw("look",
                  "uniform sampler2D s;\nout vec4 c;\nvoid main() { c = textureLod(s, vec2(0.25), " + lod + "); }\n",
                  {slot})
            .reads = {read_import(picture, "s", has_levels)};
        builder.output("color", slot, Signal::radiance, "rgba32f");
        return builder.plan;
    };
    Picture picture({2, 2}, 1);
    picture.at(0, 0) = 4.0f;
    Renderer renderer = make_renderer(plan(false, "0.0"));
    require_ok(renderer.import_picture("picture", picture));
    CHECK(render_and_read(renderer).at(0, 0) == 4.0f);
    require_ok(renderer.replace(plan(true, "1.0")));
    CHECK(render_and_read(renderer).at(0, 0) == 1.0f);
}

TEST_CASE("a plan that fails to build leaves the old one running, imports and all", "[gl][lifetime]")
{
    Scene scene = small_scene();
    Renderer renderer = make_renderer(full_plan({8, 8}));
    require_ok(renderer.set_scene(scene));
    require_ok(renderer.import_picture("picture", filled({2, 2}, 0.5f)));
    CHECK(codes(renderer.replace(full_plan({4, 4}, "broken"))) == std::vector<std::string>{"shader_failed"});
    CHECK(renderer.plan().extent == Extent{8, 8});
    CHECK(render_and_read(renderer).at(7, 7) == 0.5f);
}

TEST_CASE("two renderers in one context do not disturb each other", "[gl][lifetime]")
{
    Renderer a = make_renderer(constant_plan({4, 4}, "vec4(1.0)"));
    {
        Renderer b = make_renderer(constant_plan({8, 2}, "vec4(2.0)"));
        for (int i = 0; i < 3; ++i) {
            require_ok(a.render());
            require_ok(b.render());
            CHECK(a.read("color")->at(3, 3) == 1.0f);
            CHECK(b.read("color")->at(7, 1) == 2.0f);
        }
        Renderer moved = std::move(b);
        CHECK(render_and_read(moved).at(0, 0) == 2.0f);
    }
    CHECK(render_and_read(a).at(0, 0) == 1.0f);
}

TEST_CASE("each step has a positive time, in the plan's order, after a frame", "[gl][timing]")
{
    PlanBuilder builder({256, 256});
    const int first = builder.slot(Format::rgba16f, "first");
    const int second = builder.slot(Format::rgba16f, "second");
    const std::string heavy = "layout(location = 0) out vec4 c;\nvoid main() { float x = uv.x; for (int i = 0; i < "
                              "COUNT; ++i) x = sin(x + uv.y); c = vec4(x); }\n";
    const auto repeated = [&](const char* count) {
        std::string text = heavy;
        return text.replace(text.find("COUNT"), 5, count);
    };
    builder.draw("light", repeated("4"), {first});
    builder.draw("heavy", repeated("400"), {second});
    builder.draw("last", repeated("4"), {first});
    for (Plan::Step& step : builder.plan.steps)
        step.host.frame = true; // each frame anew
    Renderer renderer = make_renderer(builder.plan, {.is_timed = true});
    CHECK(renderer.step_times().empty());
    for (int i = 0; i < 3; ++i)
        require_ok(renderer.render({.redraws = true}));
    const std::vector<StepTime> times = renderer.step_times();
    REQUIRE(times.size() == 3);
    CHECK(times[0].step == "light");
    CHECK(times[0].milliseconds > 0.0);
    CHECK(times[1].milliseconds > 3.0 * times[0].milliseconds); // 100 times the work
    CHECK(times[1].milliseconds > 3.0 * times[2].milliseconds);
    CHECK(times[2].milliseconds > 0.0);
    Renderer untimed = make_renderer(builder.plan);
    require_ok(untimed.render());
    CHECK(untimed.step_times().empty());
}
