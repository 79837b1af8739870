// What can go wrong with a plan, a driver or a frame is an error value that names the culprit.
#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

Result<Renderer> create_spied(Plan plan)
{
    return Renderer::create(std::move(plan), {.loader = spying_loader()});
}

using Codes = std::vector<std::string>;

} // namespace

TEST_CASE("a shader error names the file and the line", "[gl][failure]")
{
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(Format::rgba8, "image");
    Plan::Step& step = builder.draw("glow",
                                    "layout(location = 0) out vec4 c;\n#line 40 2\nfloat f() { return 1.0; }\n"
                                    "float g() { return undeclared; }\n#line 2 0\nvoid main() { c = vec4(missing); }\n",
                                    {slot});
    step.sources = {"glow.glsl", "other.glsl", "common/noise.glsl"};
    const auto result = Renderer::create(builder.plan, {.loader = test_loader()});
    REQUIRE(codes(result) == Codes{"shader_failed", "shader_failed"});
    const Error& first = result.error()[0];
    CHECK(first.where.file == "common/noise.glsl");
    CHECK(first.where.line == 41);
    CHECK(first.message.find("undeclared") != std::string::npos);
    CHECK(first.message.find("step `glow`, fragment stage") != std::string::npos);
    CHECK(result.error()[1].where.file == "glow.glsl");
    CHECK(result.error()[1].where.line == 2);
}

TEST_CASE("shader errors of all steps and both stages come together", "[gl][failure]")
{
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(Format::rgba8, "image");
    builder.draw("a", "out vec4 c;\nvoid main() { c = 1; }\n", {slot}).vertex =
        "#version 330 core\nvoid main() { x; }\n";
    builder.draw("b", "out vec4 c;\nvoid main() { c = ; }\n", {slot});
    const auto result = Renderer::create(builder.plan, {.loader = test_loader()});
    CHECK(codes(result) == Codes{"shader_failed", "shader_failed", "shader_failed"});
}

TEST_CASE("stages that do not fit together fail to link, naming the step", "[gl][failure]")
{
    PlanBuilder builder({2, 2});
    const int slot = builder.slot(Format::rgba8, "image");
    Plan::Step& step = builder.draw("lost", "out vec4 c;\nvoid main() { c = vec4(uv, 0.0, 1.0); }\n", {slot});
    step.vertex = "#version 330 core\nout vec3 uv;\nvoid main() { uv = vec3(0.0); gl_Position = vec4(0.0); }\n";
    const auto result = Renderer::create(builder.plan, {.loader = test_loader()});
    REQUIRE(codes(result) == Codes{"shader_failed"});
    CHECK(result.error()[0].message.find("step `lost`, linking") != std::string::npos);
}

TEST_CASE("an extent beyond the device's, or of nothing, is refused", "[gl][failure]")
{
    const auto device = query_device(test_loader());
    REQUIRE(device);
    CHECK(device->max_texture_size >= 1024);
    CHECK(device->max_texture_units >= 16);
    CHECK(device->max_color_targets >= 8);
    Plan plan = constant_plan({2, 2});
    plan.slots[0].extent = {device->max_texture_size + 1, 2};
    const auto large = Renderer::create(plan, {.loader = test_loader()});
    REQUIRE(codes(large) == Codes{"extent_too_large"});
    CHECK(large.error()[0].fault == Fault::machine);
    CHECK(large.error()[0].message.find("fill.color") != std::string::npos);
    plan.slots[0].extent = {2, 0};
    CHECK(codes(Renderer::create(plan, {.loader = test_loader()})) == Codes{"extent_empty"});
}

TEST_CASE("more targets than the device has are refused", "[gl][failure]")
{
    PlanBuilder builder({2, 2});
    std::vector<int> slots;
    for (int i = 0; i < query_device(test_loader())->max_color_targets + 1; ++i)
        slots.push_back(builder.slot(Format::r8, "image"));
    builder.draw("wide", "layout(location = 0) out vec4 c;\nvoid main() { c = vec4(1); }\n", slots);
    CHECK(codes(Renderer::create(builder.plan, {.loader = test_loader()})) == Codes{"too_many_targets"});
}

TEST_CASE("more samplers than the device has units are refused", "[gl][failure]")
{
    const int count = query_device(test_loader())->max_texture_units + 1;
    PlanBuilder builder({2, 2});
    const int source = builder.slot(Format::r8, "source");
    const int slot = builder.slot(Format::r8, "image");
    std::string declarations;
    std::string sum = "vec4(0)";
    std::vector<Plan::Read> reads;
    for (int i = 0; i < count; ++i) {
        const std::string name = "s" + std::to_string(i);
        declarations += "uniform sampler2D " + name + ";\n";
        sum += " + texture(" + name + ", uv)";
        reads.push_back(read_slot(source, name));
    }
    builder.draw("greedy", declarations + "out vec4 c;\nvoid main() { c = " + sum + "; }\n", {slot}).reads = reads;
    const auto result = Renderer::create(builder.plan, {.loader = test_loader()});
    REQUIRE_FALSE(result); // the driver's linker may be first to say so
    CHECK(result.error()[0].message.find("`greedy`") != std::string::npos);
}

TEST_CASE("loads without image units are refused, and no device without them is said to load", "[gl][failure]")
{
    PlanBuilder builder({2, 2});
    const int source = builder.slot(Format::rgba8, "source");
    Plan::Step& step = builder.draw("loading",
                                    "layout(rgba8) readonly uniform image2D source;\nlayout(location = 0) out vec4 c;\n"
                                    "void main() { c = imageLoad(source, ivec2(gl_FragCoord.xy)); }\n",
                                    {builder.slot(Format::rgba8, "image")});
    step.reads = {load_slot(source, "source")};
    loads_images(step);
    CHECK(codes(Renderer::create(builder.plan, {.loader = test_loader()})).empty());
    reset_spy().hidden = {"glBindImageTexture"};
    CHECK(query_device(spying_loader())->max_loaded_images == 0);
    CHECK(codes(Renderer::create(builder.plan, {.loader = spying_loader()})) == Codes{"image_units_exceeded"});
    reset_spy();
}

TEST_CASE("a framebuffer the driver cannot draw into names the step and its images", "[gl][failure]")
{
    reset_spy().framebuffer_status = GL_FRAMEBUFFER_UNSUPPORTED;
    const auto result = create_spied(constant_plan({2, 2}));
    reset_spy();
    REQUIRE(codes(result) == Codes{"framebuffer_incomplete"});
    CHECK(result.error()[0].fault == Fault::machine);
    CHECK(result.error()[0].message.find("step `fill` cannot draw into fill.color (rgba32f)") != std::string::npos);
}

TEST_CASE("a context below 3.3 is too old", "[gl][failure]")
{
    reset_spy().version = 32;
    const auto result = create_spied(constant_plan({2, 2}));
    CHECK(codes(query_device(spying_loader())) == Codes{"gl_too_old"});
    reset_spy();
    REQUIRE(codes(result) == Codes{"gl_too_old"});
    CHECK(result.error()[0].fault == Fault::machine);
}

TEST_CASE("each missing function is named", "[gl][failure]")
{
    reset_spy().hidden = {"glBindSampler", "glQueryCounter"};
    const auto result = create_spied(constant_plan({2, 2}));
    REQUIRE(codes(result) == Codes{"gl_function_missing", "gl_function_missing"});
    CHECK(result.error()[0].message.find("glBindSampler") != std::string::npos);
    CHECK(result.error()[0].fault == Fault::machine);
    spy().hidden = {"glGetString"};
    CHECK(codes(create_spied(constant_plan({2, 2}))) == Codes{"gl_function_missing"});
    reset_spy();
    CHECK(codes(Renderer::create(constant_plan({2, 2}), {.loader = nullptr})) == Codes{"gl_function_missing"});
}

TEST_CASE("a bare 3.3 context without any extension draws the same", "[gl][failure]")
{
    reset_spy().version = 33;
    {
        Renderer renderer =
            make_renderer(constant_plan({2, 2}), {.loader = spying_loader(), .is_timed = true, .restores_state = true});
        CHECK(render_and_read(renderer).at(1, 1, 1) == 0.5f);
    }
    reset_spy();
}

TEST_CASE("memory that runs out is an error value of the machine, naming the images", "[gl][failure]")
{
    reset_spy();
    Renderer running = make_renderer(constant_plan({2, 2}), {.loader = spying_loader()});
    spy().next_error = GL_OUT_OF_MEMORY;
    const Result<void> result = running.replace(constant_plan({4, 4}));
    reset_spy();
    REQUIRE(codes(result) == Codes{"out_of_memory"});
    CHECK(result.error()[0].fault == Fault::machine);
    CHECK(result.error()[0].message.find("`fill.color`") != std::string::npos);
    CHECK(render_and_read(running).extent == Extent{2, 2}); // the old plan runs on
}

TEST_CASE("a GL error while drawing names the step and says what the driver said", "[gl][failure]")
{
    reset_spy();
    Renderer renderer = make_renderer(constant_plan({2, 2}), {.loader = spying_loader()});
    const auto render_spoiled = [&] {
        spy().spoils_draws = true;
        const Result<void> result = renderer.render();
        spy().spoils_draws = false;
        return result;
    };
    SECTION("on the first frame") {}
    SECTION("on a later frame")
    {
        require_ok(renderer.render());
    }
    const Result<void> result = render_spoiled();
    REQUIRE(codes(result) == Codes{"gl_error"});
    CHECK(result.error()[0].message.find("step `fill`: ") == 0);
    CHECK(result.error()[0].message.find("GL_INVALID_ENUM") != std::string::npos);
    CHECK(result.error()[0].fault == Fault::machine);
    CHECK(render_and_read(renderer).at(0, 0) == 0.25f); // nothing stays behind
    reset_spy();
}

TEST_CASE("without KHR_debug the first frame names the step at once, a later one after a second error", "[gl][failure]")
{
    reset_spy().hidden = {"glPushDebugGroup"};
    Renderer renderer = make_renderer(constant_plan({2, 2}), {.loader = spying_loader()});
    const auto message = [&] {
        const Result<void> result = renderer.render();
        REQUIRE(codes(result) == Codes{"gl_error"});
        return result.error()[0].message;
    };
    spy().spoils_draws = true;
    CHECK(message() == "step `fill`: GL_INVALID_ENUM");
    spy().spoils_draws = false;
    require_ok(renderer.render());
    spy().spoils_draws = true;
    CHECK(message() == "the frame: GL_INVALID_ENUM");
    CHECK(message() == "step `fill`: GL_INVALID_ENUM");
    reset_spy();
}

TEST_CASE("an error the host left behind is not ours", "[gl][failure]")
{
    Renderer renderer = make_renderer(constant_plan({2, 2}));
    gl_function<PFNGLENABLEPROC>("glEnable")(0xffff);
    require_ok(renderer.render());
}
