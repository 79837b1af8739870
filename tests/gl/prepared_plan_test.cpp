// Plans made bit by bit while another runs, and programs that outlive their plans.
#include <algorithm>
#include <array>
#include <random>
#include <utility>

#include "gl_support.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr Extent kExtent{4, 3};

/// Two steps: the first fills, the second shows the first times a live `gain`.
Plan two_steps(const std::string& color, const std::string& shown = "texture(first, uv) * gain")
{
    PlanBuilder builder(kExtent);
    const int first = builder.slot(Format::rgba32f, "first");
    const int second = builder.slot(Format::rgba32f, "second");
    builder.draw("fill", "layout(location = 0) out vec4 color;\nvoid main() { color = " + color + "; }", {first});
    Plan::Step& show = builder.draw("show", "uniform sampler2D first;\nuniform float gain;\nlayout(location = 0) out vec4 color;\nvoid main() { color = " + shown + "; }", {second});
    show.reads.push_back(read_slot(first, "first"));
    show.uniforms.push_back({.name = "gain", .place = "show.gain", .type = ParamType::float_, .value = Value(1.0), .lowest = 0.0, .highest = 9.0});
    builder.output("color", second, Signal::radiance, "rgba32f");
    return builder.plan;
}

float red(Renderer& renderer) { return render_and_read(renderer).at(1, 1, 0); }

PreparedPlan prepared(Renderer& renderer, Plan plan)
{
    Result<PreparedPlan> made = renderer.prepare(std::move(plan));
    REQUIRE(made);
    while (!made->is_ready())
        require_ok(renderer.advance(*made));
    return std::move(*made);
}

} // namespace

TEST_CASE("a plan is prepared while another runs, and the two change places", "[gl][plan]")
{
    Renderer renderer = make_renderer(two_steps("vec4(0.25)"));
    CHECK(red(renderer) == 0.25f);
    Result<PreparedPlan> other = renderer.prepare(two_steps("vec4(0.5)"));
    REQUIRE(other);
    CHECK_FALSE(other->is_ready());
    CHECK(other->steps_made() == 0);
    CHECK(red(renderer) == 0.25f);
    require_ok(renderer.advance(*other));
    CHECK(other->steps_made() == 1);
    CHECK(red(renderer) == 0.25f);
    require_ok(renderer.advance(*other));
    REQUIRE(other->is_ready());
    CHECK(red(renderer) == 0.25f);
    renderer.exchange(*other);
    CHECK(red(renderer) == 0.5f);
    renderer.exchange(*other);
    CHECK(red(renderer) == 0.25f);
}

TEST_CASE("live values of plans that share a program do not mix", "[gl][plan]")
{
    Renderer renderer = make_renderer(two_steps("vec4(0.25)"));
    require_ok(renderer.set("show.gain", Value(2.0)));
    CHECK(red(renderer) == 0.5f);
    PreparedPlan other = prepared(renderer, two_steps("vec4(0.125)")); // its `show` is the same program, at gain 1
    CHECK(red(renderer) == 0.5f);
    renderer.exchange(other);
    CHECK(red(renderer) == 0.125f);
    require_ok(renderer.set("show.gain", Value(4.0)));
    CHECK(red(renderer) == 0.5f);
    renderer.exchange(other);
    CHECK(red(renderer) == 0.5f); // 2 * 0.25 still
}

TEST_CASE("only programs whose text changed are compiled again", "[gl][plan]")
{
    reset_spy();
    RendererOptions options;
    options.loader = spying_loader();
    Renderer renderer = make_renderer(two_steps("vec4(0.25)"), options);
    const auto links = [] { return spy().calls["glLinkProgram"]; };
    const std::int64_t before = links();
    require_ok(renderer.replace(two_steps("vec4(0.25)")));
    CHECK(links() == before);
    require_ok(renderer.replace(two_steps("vec4(0.5)")));
    CHECK(links() == before + 1);
    require_ok(renderer.replace(two_steps("vec4(0.25)"))); // and back: the pool still has it
    CHECK(links() == before + 1);
    CHECK(red(renderer) == 0.25f);
}

TEST_CASE("steps that share a program draw with their own values", "[gl][plan]")
{
    PlanBuilder builder(kExtent);
    const std::vector<int> slots = {builder.slot(Format::rgba32f, "a"), builder.slot(Format::rgba32f, "b")};
    for (const int slot : slots) {
        Plan::Step& step = builder.draw("step", "uniform float gain;\nlayout(location = 0) out vec4 color;\nvoid main() { color = vec4(gain); }", {slot});
        step.uniforms.push_back({.name = "gain", .place = "gain" + std::to_string(slot), .type = ParamType::float_, .value = Value(slot + 1.0), .lowest = 0.0, .highest = 9.0});
        builder.output("o" + std::to_string(slot), slot, Signal::radiance, "rgba32f");
    }
    Renderer renderer = make_renderer(builder.plan);
    for (int frame = 0; frame < 2; ++frame) {
        CHECK(render_and_read(renderer, "o0").at(0, 0, 0) == 1.0f);
        CHECK(render_and_read(renderer, "o1").at(0, 0, 0) == 2.0f);
    }
}

TEST_CASE("a plan that cannot be made leaves the one that runs", "[gl][plan]")
{
    Renderer renderer = make_renderer(two_steps("vec4(0.25)"));
    Result<PreparedPlan> broken = renderer.prepare(two_steps("vec4(0.5)", "vec4(nothing)"));
    REQUIRE(broken);
    require_ok(renderer.advance(*broken));
    CHECK(codes(renderer.advance(*broken)) == std::vector<std::string>{"shader_failed"});
    CHECK(red(renderer) == 0.25f);
    Plan wide = two_steps("vec4(1)");
    wide.slots.front().extent = {1 << 20, 1};
    const Result<PreparedPlan> too_wide = renderer.prepare(wide);
    CHECK(codes(too_wide) == std::vector<std::string>{"extent_too_large"});
}

TEST_CASE("imports go with the plan that runs", "[gl][plan]")
{
    const auto reading = [](const std::string& factor) {
        PlanBuilder builder(kExtent);
        const int import = builder.import(Plan::Import::Kind::picture, "photo", Signal::radiance, kExtent);
        const int slot = builder.slot(Format::rgba32f, "out");
        Plan::Step& step = builder.draw("read", "uniform sampler2D photo;\nlayout(location = 0) out vec4 color;\nvoid main() { color = texture(photo, uv) * " + factor + "; }", {slot});
        step.reads.push_back(read_import(import, "photo"));
        builder.output("color", slot, Signal::radiance, "rgba32f");
        return builder.plan;
    };
    Renderer renderer = make_renderer(reading("1.0"));
    Picture photo(kExtent, 3);
    std::fill(photo.texels.begin(), photo.texels.end(), 0.5f);
    require_ok(renderer.import_picture("photo", photo));
    PreparedPlan other = prepared(renderer, reading("0.5"));
    CHECK(red(renderer) == 0.5f);
    renderer.exchange(other);
    CHECK(red(renderer) == 0.25f);
    std::fill(photo.texels.begin(), photo.texels.end(), 1.0f);
    require_ok(renderer.import_picture("photo", photo));
    CHECK(red(renderer) == 0.5f);
    renderer.exchange(other);
    CHECK(red(renderer) == 1.0f);
}

TEST_CASE("after an edit only the steps that changed are drawn", "[gl][plan]")
{
    Renderer renderer = make_renderer(two_steps("vec4(0.25)"));
    CHECK(red(renderer) == 0.25f);
    std::int64_t before = renderer.counters().draws;
    const auto draws = [&] { return renderer.counters().draws - std::exchange(before, renderer.counters().draws); };
    PreparedPlan edited = prepared(renderer, two_steps("vec4(0.25)", "texture(first, uv) * gain * 2.0"));
    renderer.exchange(edited);
    CHECK(red(renderer) == 0.5f);
    CHECK(draws() == 1); // `show` alone
    renderer.exchange(edited);
    CHECK(red(renderer) == 0.25f);
    CHECK(draws() == 0); // `fill` came back, and `show` was there still
    require_ok(renderer.replace(two_steps("vec4(0.125)")));
    CHECK(red(renderer) == 0.125f);
    CHECK(draws() == 2);
}

TEST_CASE("a plan that gave its image away draws it again", "[gl][plan]")
{
    Renderer renderer = make_renderer(two_steps("vec4(0.25)"));
    CHECK(red(renderer) == 0.25f);
    PreparedPlan edited = prepared(renderer, two_steps("vec4(0.25)", "texture(first, uv) * gain * 2.0"));
    renderer.exchange(edited);
    CHECK(red(renderer) == 0.5f);
    require_ok(renderer.replace(two_steps("vec4(0.75)"))); // the edited plan, and the image with it, are gone
    renderer.exchange(edited);
    require_ok(renderer.set("show.gain", Value(2.0)));
    CHECK(red(renderer) == 0.5f);
}

TEST_CASE("plans that change places at random always show their own picture", "[gl][plan]")
{
    const auto plan = [](int which) {
        PlanBuilder builder(kExtent);
        const int import = builder.import(Plan::Import::Kind::picture, "photo", Signal::radiance, kExtent);
        const int first = builder.slot(Format::rgba32f, "first");
        const int second = builder.slot(Format::rgba32f, "second");
        const int third = which == 2 ? first : builder.slot(Format::rgba32f, "third"); // the last plan's slots are shared over time
        const std::string head = "layout(location = 0) out vec4 color;\n";
        Plan::Step& read = builder.draw("read", "uniform sampler2D photo;\nuniform float gain;\n" + head + "void main() { color = texture(photo, uv) * gain; }", {first});
        read.reads.push_back(read_import(import, "photo"));
        read.uniforms.push_back({.name = "gain", .place = "read.gain", .type = ParamType::float_, .value = Value(1.0), .lowest = 0.0, .highest = 9.0});
        Plan::Step& show = builder.draw("show", "uniform sampler2D first;\nuniform float share;\n" + head + "void main() { color = texture(first, uv) * share * " + std::to_string(which + 1) + ".0; }", {second});
        show.uniforms.push_back({.name = "share", .place = "show.share", .type = ParamType::float_, .value = Value(1.0), .lowest = 0.0, .highest = 9.0});
        show.reads.push_back(read_slot(first, "first"));
        builder.draw("last", "uniform sampler2D second;\n" + head + "void main() { color = texture(second, uv) + 1.0; }", {third}).reads.push_back(read_slot(second, "second"));
        builder.output("color", third, Signal::radiance, "rgba32f");
        return builder.plan;
    };
    std::array<float, 3> gains = {1.0f, 1.0f, 1.0f};
    std::array<float, 3> shares = {1.0f, 1.0f, 1.0f};
    float photo_value = 0.5f;
    Picture photo(kExtent, 3);
    std::fill(photo.texels.begin(), photo.texels.end(), photo_value);
    Renderer renderer = make_renderer(plan(0));
    require_ok(renderer.import_picture("photo", photo));
    std::vector<PreparedPlan> others;
    others.push_back(prepared(renderer, plan(1)));
    others.push_back(prepared(renderer, plan(2)));
    std::array<size_t, 3> which = {0, 1, 2}; // the running one first, then the prepared ones
    std::minstd_rand random(7);
    for (int i = 0; i < 200; ++i) {
        switch (random() % 5) {
        case 0: {
            const size_t other = random() % 2;
            renderer.exchange(others[other]);
            std::swap(which[0], which[other + 1]);
            break;
        }
        case 1:
            gains[which[0]] = static_cast<float>(random() % 3 + 1);
            require_ok(renderer.set("read.gain", Value(static_cast<double>(gains[which[0]]))));
            break;
        case 2:
            photo_value = static_cast<float>(random() % 8) / 8.0f;
            std::fill(photo.texels.begin(), photo.texels.end(), photo_value);
            require_ok(renderer.import_picture("photo", photo));
            break;
        case 3:
            shares[which[0]] = static_cast<float>(random() % 3 + 1);
            require_ok(renderer.set("show.share", Value(static_cast<double>(shares[which[0]]))));
            break;
        default: break;
        }
        CAPTURE(i);
        CHECK(red(renderer) == photo_value * gains[which[0]] * shares[which[0]] * static_cast<float>(which[0] + 1) + 1.0f);
    }
}

TEST_CASE("one texel is read as the whole picture has it", "[gl][read]")
{
    Renderer renderer = make_renderer(two_steps("vec4(gl_FragCoord.xy, 0.0, 1.0)"));
    const Picture whole = render_and_read(renderer);
    for (int y = 0; y < kExtent.height; ++y)
        for (int x = 0; x < kExtent.width; ++x) {
            const Result<Picture> texel = renderer.read_texel("color", x, y);
            REQUIRE(texel);
            CHECK(texel->extent == Extent{1, 1});
            CHECK(texel->at(0, 0, 0) == whole.at(x, y, 0));
            CHECK(texel->at(0, 0, 1) == whole.at(x, y, 1));
        }
}
