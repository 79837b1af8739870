// Full-screen steps: what a plan draws is what is read back.
#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

TEST_CASE("a constant draw gives its constant in every texel of any extent", "[gl]")
{
    for (const Extent extent : {Extent{1, 1}, Extent{1, 7}, Extent{17, 13}}) {
        Renderer renderer = make_renderer(constant_plan(extent));
        const Picture picture = render_and_read(renderer);
        REQUIRE(picture.extent == extent);
        REQUIRE(picture.channels == 3);
        for (int y = 0; y < extent.height; ++y)
            for (int x = 0; x < extent.width; ++x) {
                CHECK(picture.at(x, y, 0) == 0.25f);
                CHECK(picture.at(x, y, 1) == 0.5f);
                CHECK(picture.at(x, y, 2) == 0.75f);
            }
    }
}

TEST_CASE("row 0 of a picture that was read is uv.y = 0", "[gl]")
{
    Renderer renderer = make_renderer(constant_plan({4, 8}, "vec4(uv, 0.0, 1.0)"));
    const Picture picture = render_and_read(renderer);
    CHECK(picture.at(0, 0, 0) == Approx(0.125));
    CHECK(picture.at(0, 0, 1) == Approx(0.0625));
    CHECK(picture.at(3, 7, 0) == Approx(0.875));
    CHECK(picture.at(3, 7, 1) == Approx(0.9375));
}

TEST_CASE("a step reads what the step before it drew, in another extent", "[gl]")
{
    PlanBuilder builder({8, 4});
    const int first = builder.slot(Format::rgba32f, "first.color");
    const int second = builder.slot(Format::rgba32f, "second.color", {4, 2});
    builder.draw("first", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(floor(uv * vec2(8, 4)), 0, 1); }\n",
                 {first});
    builder
        .draw("second",
              "uniform sampler2D source;\nlayout(location = 0) out vec4 c;\n"
              "void main() { c = texture(source, uv) * 2.0; }\n",
              {second})
        .reads = {read_slot(first, "source")};
    SECTION("nearest")
    {
        builder.output("color", second, Signal::radiance, "rgba32f");
        Renderer renderer = make_renderer(builder.plan);
        const Picture picture = render_and_read(renderer);
        CHECK(picture.extent == Extent{4, 2});
        CHECK(std::fmod(picture.at(1, 1, 0), 2.0f) == 0.0f);
    }
    SECTION("linear: the middle of four texels is their mean")
    {
        builder.plan.steps[1].reads[0].filter = Filter::linear;
        builder.output("color", second, Signal::radiance, "rgba32f");
        Renderer renderer = make_renderer(builder.plan);
        const Picture picture = render_and_read(renderer);
        CHECK(picture.at(1, 1, 0) == Approx(2.0 * 2.5).epsilon(1e-3));
        CHECK(picture.at(1, 1, 1) == Approx(2.0 * 2.5).epsilon(1e-3));
    }
}

TEST_CASE("the address mode of a read decides what lies outside", "[gl]")
{
    const auto outside = [](AddressMode wrap) {
        PlanBuilder builder({4, 1});
        const int source = builder.slot(Format::rgba32f, "source");
        const int target = builder.slot(Format::rgba32f, "target");
        builder.draw("ramp", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(floor(uv.x * 4.0)); }\n",
                     {source});
        builder
            .draw("shift",
                  "uniform sampler2D s;\nlayout(location = 0) out vec4 c;\n"
                  "void main() { c = texture(s, uv + vec2(0.5, 0.0)); }\n",
                  {target})
            .reads = {read_slot(source, "s")};
        builder.plan.steps[1].reads[0].wrap = wrap;
        builder.output("color", target, Signal::radiance, "rgba32f");
        Renderer renderer = make_renderer(builder.plan);
        return render_and_read(renderer).at(3, 0);
    };
    CHECK(outside(AddressMode::clamp) == 3.0f);
    CHECK(outside(AddressMode::mirror) == 2.0f);
    CHECK(outside(AddressMode::repeat) == 1.0f);
}

TEST_CASE("one step draws into several images of different formats", "[gl]")
{
    PlanBuilder builder({3, 3});
    const int a = builder.slot(Format::rgba32f, "a");
    const int b = builder.slot(Format::rg16, "b");
    const int c = builder.slot(Format::r8, "c");
    builder.draw(
        "split",
        "layout(location = 0) out vec4 x;\nlayout(location = 1) out vec4 y;\nlayout(location = 2) out vec4 z;\n"
        "void main() { x = vec4(1, 2, 3, 4); y = vec4(0.25, 0.5, 0, 1); z = vec4(1, 0, 0, 1); }\n",
        {a, b, c});
    builder.output("a", a, Signal::radiance_alpha, "rgba32f");
    builder.output("b", b, Signal::atlas_uv, "rg16");
    builder.output("c", c, Signal::mask, "r8");
    Renderer renderer = make_renderer(builder.plan);
    CHECK(render_and_read(renderer, "a").at(2, 2, 3) == 4.0f);
    CHECK(render_and_read(renderer, "b").at(1, 1, 1) == Approx(0.5).margin(1.0 / 65535));
    CHECK(render_and_read(renderer, "c").at(0, 0) == 1.0f);
}

TEST_CASE("every codec of every signal can be drawn into and read back", "[gl]")
{
    for (const SignalInfo& row : all_signals()) {
        for (const Codec& codec : codecs_of(row.signal)) {
            if (is_depth(codec.format) || codec.packing != Packing::plain)
                continue;
            PlanBuilder builder({2, 2});
            const int slot = builder.slot(codec.format, "image");
            builder.draw("fill", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(0.2, 0.4, 0.6, 0.8); }\n",
                         {slot});
            builder.output("color", slot, row.signal, std::string(codec.name));
            Renderer renderer = make_renderer(builder.plan);
            const Picture picture = render_and_read(renderer);
            INFO(row.name << " as " << codec.name);
            REQUIRE(picture.channels == row.components);
            // r11f_g11f_b10f keeps 5 bits of blue's mantissa; 8-bit codes are no coarser.
            for (int channel = 0; channel < row.components; ++channel)
                CHECK(picture.at(1, 1, channel) == Approx(0.2 * (channel + 1)).epsilon(1.0 / 32));
        }
    }
}

TEST_CASE("an sRGB texture gives back the linear values that were drawn", "[gl]")
{
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(Format::srgb8_a8, "albedo");
    const int plain = builder.slot(Format::rgba8, "plain");
    builder.draw("fill", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(0.02, 0.2, 0.8, 1.0); }\n", {slot});
    builder.draw("after", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(0.2); }\n", {plain});
    builder.output("albedo", slot, Signal::albedo, "srgb8_a8");
    builder.output("plain", plain, Signal::display, "rgba8");
    Renderer renderer = make_renderer(builder.plan);
    const Picture picture = render_and_read(renderer, "albedo");
    // Half a code of 255, where the sRGB curve is steepest: 2.4 / 1.055 / 255 / 2.
    const double half_code = 2.4 / 1.055 / 255.0 / 2.0;
    CHECK(picture.at(0, 0, 0) == Approx(0.02).margin(half_code));
    CHECK(picture.at(0, 0, 1) == Approx(0.2).margin(half_code));
    CHECK(picture.at(0, 0, 2) == Approx(0.8).margin(half_code));
    CHECK(render_and_read(renderer, "plain").at(0, 0) == Approx(0.2).margin(0.5 / 255));
}

TEST_CASE("a parameter set between frames changes the next frame", "[gl]")
{
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(Format::rgba32f, "image");
    Plan::Step& step =
        builder.draw("fill",
                     "uniform float gain;\nuniform vec3 tint;\nuniform int count;\nlayout(location = 0) out vec4 c;\n"
                     "void main() { c = vec4(gain * tint + float(count), 1.0); }\n",
                     {slot});
    step.uniforms = {{"gain", "fill.gain", ParamType::float_, Value(2.0), 0.0, 4.0},
                     {"tint", "fill.tint", ParamType::color, Value(0.25, 0.5, 1.0), 0.0, 1.0},
                     {"count", "fill.count", ParamType::int_, Value(0.0), 0.0, 8.0}};
    builder.output("color", slot, Signal::radiance, "rgba32f");
    Renderer renderer = make_renderer(builder.plan);
    CHECK(render_and_read(renderer).at(0, 0, 1) == 1.0f);
    require_ok(renderer.set("fill.gain", 4.0));
    require_ok(renderer.set("fill.count", 3.0));
    CHECK(render_and_read(renderer).at(0, 0, 1) == 5.0f);

    SECTION("a value outside its range is refused and changes nothing")
    {
        for (const double bad : {4.5, -1.0, std::nan(""), HUGE_VAL})
            CHECK(codes(renderer.set("fill.gain", bad)) == std::vector<std::string>{"param_out_of_range"});
        CHECK(codes(renderer.set("fill.tint", Value(0.5, 0.5, 2.0))) == std::vector<std::string>{"param_out_of_range"});
        CHECK(codes(renderer.set("fill.count", 2.5)) == std::vector<std::string>{"param_out_of_range"});
        CHECK(render_and_read(renderer).at(0, 0, 1) == 5.0f);
    }
    SECTION("an unknown name is refused with the nearest one")
    {
        const Result<void> result = renderer.set("fill.gian", 1.0);
        REQUIRE(codes(result) == std::vector<std::string>{"unknown_param"});
        CHECK(result.error()[0].hint == "did you mean `fill.gain`?");
    }
}

TEST_CASE("an unknown output is refused with the names there are", "[gl]")
{
    Renderer renderer = make_renderer(constant_plan({2, 2}));
    require_ok(renderer.render());
    const auto result = renderer.read("colour");
    REQUIRE(codes(result) == std::vector<std::string>{"unknown_output"});
    CHECK(result.error()[0].hint == "did you mean `color`?");
}

TEST_CASE("the frame block holds wrapped time, and the first frame is a cut", "[gl]")
{
    PlanBuilder builder({1, 1});
    const int slot = builder.slot(Format::rgba32f, "image");
    builder
        .draw("clock",
              "layout(std140) uniform passgraph_frame_block { float time; float delta; int index; int is_cut; int "
              "light_count; };\n"
              "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(time, delta, float(index), float(is_cut)); }\n",
              {slot})
        .host.frame = true;
    builder.output("color", slot, Signal::radiance_alpha, "rgba32f");
    Renderer renderer = make_renderer(builder.plan);
    const Picture first = render_and_read(renderer, "color", {.time = 3600.0 * 1000 + 0.5, .delta = 0.25, .index = 7});
    CHECK(first.texels == std::vector<float>{0.5f, 0.25f, 7.0f, 1.0f});
    CHECK(render_and_read(renderer).at(0, 0, 3) == 0.0f);
    CHECK(render_and_read(renderer, "color", {.is_cut = true}).at(0, 0, 3) == 1.0f);
}
