// Steps that the device leaves out by what a query has counted: what is drawn, what is cleared, and when a query decides nothing.
#include <utility>

#include "gl_support.hpp"

#include "gl/freshness.hpp"
#include "gl/queries.hpp"

using namespace passgraph;
using namespace passgraph::test;

namespace {

constexpr Extent kExtent{4, 3};

/// `key` counts where `light` is not black; `chain` doubles it on that condition; `show` adds it to 0.5, or to nothing.
Plan conditional_plan(double light, const std::string& shown = "0.5")
{
    PlanBuilder builder(kExtent);
    const int key = builder.slot(Format::rgba32f, "key");
    const int chain = builder.slot(Format::rgba32f, "chain");
    const int film = builder.slot(Format::rgba32f, "film");
    Plan::Step& counting = builder.draw("key", "uniform float light;\nlayout(location = 0) out vec4 color;\n"
                                               "void main() { if (light == 0.0) discard; color = vec4(vec3(light), 1.0); }", {key});
    counting.uniforms.push_back({.name = "light", .place = "key.light", .type = ParamType::float_, .value = Value(light), .lowest = 0.0, .highest = 9.0});
    counting.counts = 0;
    Plan::Step& doubled = builder.draw("chain", "uniform sampler2D key;\nlayout(location = 0) out vec4 color;\n"
                                                "void main() { color = 2.0 * texture(key, uv) + vec4(1.0e-3); }", {chain}); // seen if drawn when it is not to be
    doubled.reads.push_back(read_slot(key, "key"));
    doubled.skipped_by = 0;
    const std::string head = "#version 330 core\nin vec2 uv;\nuniform float gain;\nlayout(location = 0) out vec4 color;\n";
    Plan::Step& show = builder.draw("film", "uniform sampler2D chain;\nuniform float gain;\nlayout(location = 0) out vec4 color;\n"
                                            "void main() { color = gain * (vec4(" + shown + ") + texture(chain, uv)); }", {film});
    show.reads.push_back(read_slot(chain, "chain"));
    show.uniforms.push_back({.name = "gain", .place = "film.gain", .type = ParamType::float_, .value = Value(1.0), .lowest = 0.0, .highest = 9.0});
    show.skipped_by = 0;
    show.when_skipped = head + "void main() { color = gain * vec4(" + shown + " + 0.25); }"; // a quarter more, to be told apart
    for (Plan::Step& step : builder.plan.steps)
        step.targets.front().black = {0.0f, 0.0f, 0.0f, 1.0f};
    builder.plan.queries.push_back({0, "key"});
    builder.output("key", key, Signal::radiance, "rgba32f");
    builder.output("chain", chain, Signal::radiance, "rgba32f");
    builder.output("film", film, Signal::radiance, "rgba32f");
    return builder.plan;
}

float red(Renderer& renderer, const std::string& output)
{
    return render_and_read(renderer, output).at(1, 1, 0);
}

std::vector<bool> skipped(Renderer& renderer)
{
    std::vector<bool> found;
    for (const StepTime& time : renderer.step_times())
        found.push_back(time.was_skipped);
    return found;
}

} // namespace

TEST_CASE("what a query counts decides what is drawn, frame by frame", "[gl][skip]")
{
    Renderer renderer = make_renderer(conditional_plan(0.0), {.is_timed = true, .is_poisoned = true});
    CHECK(red(renderer, "film") == 0.75f); // the variant
    CHECK(red(renderer, "key") == 0.0f);   // cleared, not the poison
    CHECK(red(renderer, "chain") == 0.0f);
    for (const double light : {0.5, 0.0, 1.0, 2.0, 0.0}) {
        CAPTURE(light);
        const bool is_dark = light == 0.0;
        require_ok(renderer.set("key.light", Value(light)));
        require_ok(renderer.render());
        CHECK(skipped(renderer) == std::vector<bool>{false, is_dark, is_dark});
        CHECK(red(renderer, "chain") == (is_dark ? 0.0f : 2.0f * static_cast<float>(light) + 1.0e-3f));
        CHECK(red(renderer, "film") == Approx(is_dark ? 0.75 : 0.5 + 2.0 * light + 1.0e-3));
    }
}

// The scout of these tests finds what `hint` says, so that one can tell whether it was asked.
TEST_CASE("after a frame without a pixel a scout decides whether the step is drawn, after one with pixels it stays at home", "[gl][skip][scout]")
{
    Plan plan = conditional_plan(0.0);
    Plan::Step& key = plan.steps.front();
    key.uniforms.push_back({.name = "hint", .place = "key.hint", .type = ParamType::float_, .value = Value(0.0), .lowest = 0.0, .highest = 9.0});
    key.scout = "#version 330 core\nin vec2 uv;\nuniform float hint;\nlayout(location = 0) out vec4 color;\n"
                "void main() { if (hint == 0.0 || int(gl_FragCoord.x) != 1) discard; color = vec4(7.0); }";
    key.scout_extent = {2, 1};
    plan.steps[1].is_cleared = false; // `chain` is seen by `film` alone, which knows
    plan.outputs.erase(plan.outputs.begin() + 1);
    Renderer renderer = make_renderer(plan, {.is_timed = true, .is_poisoned = true});
    struct Case {
        double light;
        double hint;
        bool is_scouted;
        float key; ///< its value
    };
    for (const Case& now : {Case{0.0, 0.0, false, 0.0f}, // the first frame: nobody knows
                            Case{1.0, 0.0, true, 0.0f},  // scouted: left out, whatever it would have drawn
                            Case{1.0, 1.0, true, 1.0f},  // scouted and drawn
                            Case{2.0, 0.0, false, 2.0f}, // after light, not asked
                            Case{0.0, 1.0, false, 0.0f},
                            Case{0.0, 2.0, true, 0.0f},   // what it draws does not stay
                            Case{3.0, 3.0, false, 3.0f}}) { // it had found something
        CAPTURE(now.light, now.hint);
        require_ok(renderer.set("key.light", Value(now.light)));
        require_ok(renderer.set("key.hint", Value(now.hint)));
        const std::int64_t before = renderer.counters().draws;
        require_ok(renderer.render({.redraws = true}));
        renderer.finish();
        // The scout, `key`, `chain` unless the device has said by then that it is black, and the two variants of `film`.
        CHECK(renderer.counters().draws - before == (now.is_scouted && now.hint != 0.0 ? 5 : 4));
        CHECK(skipped(renderer).front() == (now.is_scouted && now.hint == 0.0));
        CHECK(renderer.read("key")->at(1, 1) == now.key);
        CHECK(renderer.read("key")->at(3, 2) == now.key);
        // By what was counted last, which is the scout's pixels if it was sent out.
        const bool is_dark = now.is_scouted ? now.hint == 0.0 : now.light == 0.0;
        CHECK(renderer.read("film")->at(1, 1) == Approx(is_dark ? 0.75 : 0.5 + 2.0 * now.light + 1.0e-3));
    }
}

TEST_CASE("a step that runs again alone goes by what was counted last", "[gl][skip]")
{
    for (const double light : {0.0, 1.0}) {
        Renderer renderer = make_renderer(conditional_plan(light));
        const float before = red(renderer, "film");
        const std::int64_t draws = renderer.counters().draws;
        require_ok(renderer.set("film.gain", Value(2.0)));
        CHECK(red(renderer, "film") == 2.0f * before);
        CHECK(renderer.counters().draws - draws == 2); // its two variants
    }
}

TEST_CASE("no object is made after the first frame, and queries are deleted with their plan", "[gl][skip]")
{
    reset_spy();
    {
        Renderer renderer = make_renderer(conditional_plan(0.0), {.loader = spying_loader()});
        const std::int64_t made = renderer.counters().objects_created;
        for (const double light : {0.0, 1.0, 0.0}) {
            require_ok(renderer.set("key.light", Value(light)));
            require_ok(renderer.render());
        }
        CHECK(renderer.counters().objects_created == made);
        require_ok(renderer.replace(conditional_plan(1.0)));
        require_ok(renderer.render());
    }
    CHECK(spy().objects_alive == 0);
}

TEST_CASE("while the host counts pixels itself everything is drawn, and the host's query goes on", "[gl][skip]")
{
    const auto gl_begin = gl_function<PFNGLBEGINQUERYPROC>("glBeginQuery");
    const auto gl_end = gl_function<PFNGLENDQUERYPROC>("glEndQuery");
    const auto gl_generate = gl_function<PFNGLGENQUERIESPROC>("glGenQueries");
    const auto gl_delete = gl_function<PFNGLDELETEQUERIESPROC>("glDeleteQueries");
    const auto gl_current = gl_function<PFNGLGETQUERYIVPROC>("glGetQueryiv");
    for (const GLenum target : {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED_CONSERVATIVE}) {
        CAPTURE(target);
        Renderer renderer = make_renderer(conditional_plan(0.0), {.is_timed = true});
        GLuint query = 0;
        gl_generate(1, &query);
        gl_begin(target, query);
        CHECK(red(renderer, "chain") == 1.0e-3f); // drawn, where the counting would have left it out
        CHECK(red(renderer, "film") == Approx(0.501));
        CHECK(skipped(renderer) == std::vector<bool>{false, false, false});
        GLint current = 0;
        gl_current(target, GL_CURRENT_QUERY, &current);
        CHECK(static_cast<GLuint>(current) == query);
        gl_end(target);
        gl_delete(1, &query);
        require_ok(renderer.set("film.gain", Value(2.0)));
        CHECK(red(renderer, "film") == 1.5f); // `film` alone was to run: what it goes by is counted first
    }
}

TEST_CASE("a plan that is prepared and exchanged decides by its own counting, or by that of the images it took over", "[gl][skip]")
{
    for (const double light : {0.0, 1.0}) {
        CAPTURE(light);
        Renderer renderer = make_renderer(conditional_plan(light));
        const float shown = red(renderer, "film");
        Result<PreparedPlan> other = renderer.prepare(conditional_plan(light, "1.0"));
        REQUIRE(other);
        while (!other->is_ready())
            require_ok(renderer.advance(*other)); // draws a pixel with each program, and counts nothing
        require_ok(renderer.set("film.gain", Value(2.0)));
        CHECK(red(renderer, "film") == 2.0f * shown);
        const std::int64_t draws = renderer.counters().draws;
        renderer.exchange(*other);
        CHECK(red(renderer, "film") == Approx(shown + 0.5f));
        CHECK(renderer.counters().draws - draws == 2); // `film` alone: the query came along
        renderer.exchange(*other);
        CHECK(red(renderer, "film") == 2.0f * shown);
        // What the first plan's query counts now is for the plan that has it.
        require_ok(renderer.set("key.light", Value(1.0 - light)));
        CHECK(red(renderer, "film") == Approx(light == 0.0 ? 2.0 * 2.501 : 2.0 * 0.75));
        renderer.exchange(*other);
        CHECK(red(renderer, "film") == Approx(shown + 0.5f));
    }
}

TEST_CASE("without inverted conditions a step of two variants is drawn as it is", "[gl][skip]")
{
    Result<gl::Driver> driver = gl::create_driver(test_loader());
    REQUIRE(driver);
    gl::PlanObjects objects;
    objects.plan = conditional_plan(0.0);
    objects.queries.push_back({gl::QueryObject(*driver)});
    for (const bool has_inverted : {true, false}) {
        driver->gl.has_inverted_conditions = has_inverted;
        const auto queries = [&](size_t step, bool answers, bool counts) { return gl::queries_of(driver->gl, objects, step, {answers}, counts); };
        CHECK(queries(0, false, true).counts != 0);
        CHECK(queries(0, false, false).counts == 0);
        CHECK(queries(1, true, true).skipped_by != 0);
        CHECK((queries(2, true, true).skipped_by != 0) == has_inverted);
        CHECK(queries(1, false, true).skipped_by == 0);
    }
}

TEST_CASE("a query that counted another image decides nothing", "[gl][skip]")
{
    const Plan plan = conditional_plan(0.0);
    gl::Freshness freshness(plan);
    const auto versions = [](std::uint64_t light, std::uint64_t gain) { return gl::Versions{.params = {light, 0, gain}}; };
    auto runs = freshness.stale(plan, versions(1, 1), false);
    CHECK(runs == std::vector<bool>{true, true, true});
    CHECK(freshness.answers(plan, runs, true) == std::vector<bool>{true});
    CHECK(freshness.answers(plan, runs, false) == std::vector<bool>{false});
    freshness.have_run(plan, runs, true);
    runs = freshness.stale(plan, versions(1, 2), false);
    CHECK(runs == std::vector<bool>{false, false, true});
    CHECK(freshness.answers(plan, runs, true) == std::vector<bool>{true});

    gl::Freshness next(plan); // takes over the images and the query with them
    const auto carried = next.carry_over(plan, versions(1, 2), freshness);
    CHECK(carried.queries.size() == 1);
    runs = next.stale(plan, versions(1, 2), false);
    CHECK(next.answers(plan, runs, true) == std::vector<bool>{true});
    freshness.stale(plan, versions(1, 2), false); // what was given away is gone
    CHECK(freshness.answers(plan, {false, false, false}, true) == std::vector<bool>{false});

    next.have_run(plan, {true, true, true}, false); // a frame that could not count
    runs = next.stale(plan, versions(1, 3), false);
    CHECK(runs == std::vector<bool>{true, false, true}); // counted anew, for `film` to go by
    next.have_run(plan, runs, true);
    next.forget();
    CHECK(next.answers(plan, {false, false, false}, true) == std::vector<bool>{false});
}
