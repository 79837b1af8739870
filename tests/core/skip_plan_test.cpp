// Which steps a plan lets the device leave out: those that are black where no pixel is bright, and no others.
#include <nlohmann/json.hpp>

#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "skip_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

/// The demo, with its bright part to be looked at: that must be stored, by the draw that lights.
Graph demo_that_shows_bright()
{
    Graph graph = demo();
    graph.output("bright", AnyImage(*graph.find_image("bright")));
    return graph;
}

const Plan::Step& step(const Plan& plan, const std::string& name)
{
    for (const Plan::Step& candidate : plan.steps)
        if (candidate.name == name)
            return candidate;
    FAIL("no step " << name);
    return plan.steps.front();
}

bool leaves_nothing_out(const Plan& plan)
{
    return plan.queries.empty() && std::all_of(plan.steps.begin(), plan.steps.end(), [](const Plan::Step& candidate) {
               return candidate.counts < 0 && candidate.skipped_by < 0 && candidate.when_skipped.empty() &&
                      candidate.fragment.find("discard") == std::string::npos;
           });
}

} // namespace

TEST_CASE("the demo's bloom runs only if a pixel is bright, and film has a variant without it", "[core][skip]")
{
    const bool shows_bright = GENERATE(false, true);
    const Plan plan = planned(shows_bright ? demo_that_shows_bright() : demo());
    REQUIRE(plan.queries.size() == 1);
    CHECK(plan.queries.front().images == "eighth");
    const Plan::Step& counting = plan.steps[static_cast<size_t>(plan.queries.front().step)];
    CHECK(counting.name == (shows_bright ? "eighth" : "bright + eighth"));
    CHECK(counting.reads.front().image == (shows_bright ? "bright" : "view")); // what is called has no texels
    CHECK(counting.scout_extent == Extent{160, 90});
    CHECK(counting.scout.empty() == false);
    CHECK(counting.counts == 0);
    CHECK(counting.extent == Extent{160, 90});
    CHECK_THAT(counting.fragment, Contains("discard"));
    CHECK(conditional(plan) == std::vector<std::string>{"glow.horizontal", "glow.vertical"});
    const Plan::Step& film = step(plan, "film + shown");
    CHECK(film.skipped_by == 0);
    CHECK(film.black_images == "glow.vertical");
    // The reads keep their samplers, and so their units; the variant never fetches the glow.
    const auto glow = std::find_if(film.reads.begin(), film.reads.end(), [](const Plan::Read& read) { return read.image == "glow.vertical"; });
    REQUIRE(glow != film.reads.end());
    CHECK_THAT(film.fragment, Contains("texture(" + glow->sampler));
    CHECK_THAT(film.when_skipped, !Contains("texture(" + glow->sampler));
}

TEST_CASE("a plan that is to draw everything leaves nothing out", "[core][skip]")
{
    for (const bool specialises : {true, false})
        for (const bool guards : {true, false})
            for (const Skipping skipping : {Skipping::as_needed, Skipping::never, Skipping::always}) {
                CAPTURE(specialises, guards, static_cast<int>(skipping));
                CompileOptions options;
                options.specialise = specialises;
                options.guards = guards;
                options.skipping = skipping;
                // Without guards a stored zero may be -0, which a cleared one is not.
                CHECK(leaves_nothing_out(planned(demo(), options)) == !(specialises && guards && skipping == Skipping::as_needed));
            }
}

TEST_CASE("a pass that has its draw to itself counts there, at no cost", "[core][skip]")
{
    const PassLibrary library = library_of();
    Chain chain(library);
    const AnyImage key = chain.add("key", chain.photo());
    const Plan plan = chain.plan(chain.add("lift", chain.add("glow", key)));
    REQUIRE(plan.queries.size() == 1);
    CHECK(plan.queries.front().images == "key");
    CHECK(plan.steps.size() == 3);
    CHECK(step(plan, "key").counts == 0);
    CHECK(conditional(plan) == std::vector<std::string>{"glow"});
    CHECK(step(plan, "lift").black_images == "glow"); // it is not black, but simpler
}

TEST_CASE("what is not declared to hand black on is drawn, and so is what follows from it", "[core][skip]")
{
    const PassLibrary library = library_of();
    Chain chain(library);
    const AnyImage lifted = chain.add("lift", chain.add("key", chain.photo()));
    const AnyImage glow = chain.add("glow", lifted);
    const Plan plan = chain.plan(chain.add("smear", glow));
    CHECK(conditional(plan).empty());
    CHECK(step(plan, "glow").skipped_by == -1);
    CHECK(step(plan, "smear").skipped_by == -1);
}

TEST_CASE("an image is black when all of its inputs are, not when one of them is", "[core][skip]")
{
    const PassLibrary library = library_of();
    Chain one(library);
    const AnyImage photo = one.photo();
    const Plan half = one.plan(one.add("smear", one.add("both", {{"image", photo}, {"glow", one.add("key", photo)}})));
    CHECK(conditional(half).empty());
    CHECK(step(half, "both").black_images == "key");
    Chain two(library);
    const AnyImage key = two.add("key", two.photo());
    const Plan all = two.plan(two.add("smear", two.add("both", {{"image", key}, {"glow", two.add("glow", key)}})));
    CHECK(conditional(all) == std::vector<std::string>{"glow", "both", "smear"});
}

TEST_CASE("a picture whose alpha comes from another input is not black", "[core][skip]")
{
    PassLibrary library = library_of(Signal::color);
    for (const bool lists_image : {false, true}) {
        PassMaker veil("veil"); // its alpha is carried from `image`, the first of its colors
        veil.input("image", kPointwise).input("glow", kGather).output("color");
        veil.pass.black = {lists_image ? std::vector{0, 1} : std::vector{1}};
        library.add(veil.done());
        for (const bool has_alpha : {false, true}) {
            CAPTURE(lists_image, has_alpha);
            Chain chain(library);
            const AnyImage photo = has_alpha ? AnyImage(chain.graph().picture<RadianceAlpha>("photo")) : chain.photo();
            const AnyImage veiled = chain.add("veil", {{"image", photo}, {"glow", chain.add("key", photo)}});
            const Plan plan = chain.plan(chain.add("smear", veiled));
            CHECK(conditional(plan).empty() == (lists_image || has_alpha));
        }
    }
}

TEST_CASE("a draw in two parts by depth has no variant", "[core][skip]")
{
    // The sky over the surfaces is drawn in two parts; where it reads what may be black, it stays as it is.
    const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" }, "photo": "radiance" },
        "passes": {
            "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } },
            "bright": { "pass": "bright", "inputs": { "image": "photo" } },
            "half": { "pass": "downsample", "inputs": { "image": "bright" } },
            "soft": { "pass": "gaussian_blur", "inputs": { "image": "half" } },
            "double": { "pass": "upsample", "inputs": { "image": "soft" } },
            "view": { "pass": "sky", "inputs": { "image": "double", "depth": "surface.depth", "sky": "scene.sky" } } },
        "outputs": { "color": "view" } })", "parts.graph.json");
    REQUIRE(description);
    const Plan plan = planned(build_graph(*description, builtin_passes()), {.extent = {64, 64}, .picture_extents = {{"photo", {64, 64}}}});
    CHECK_FALSE(conditional(plan).empty());
    for (const Plan::Step& row : plan.steps)
        CHECK((row.background.empty() || row.when_skipped.empty()));
    CHECK(std::any_of(plan.steps.begin(), plan.steps.end(), [](const Plan::Step& row) { return !row.background.empty(); }));
}

TEST_CASE("a signal whose zero may have a sign, or that knows none, is always drawn", "[core][skip]")
{
    for (const Signal signal : {Signal::position, Signal::normal, Signal::exposure}) {
        const PassLibrary library = library_of(signal);
        Graph graph(library);
        PassArguments arguments;
        const AnyImage photo = signal == Signal::position ? AnyImage(graph.picture<Position>("photo"))
                               : signal == Signal::normal ? AnyImage(graph.picture<Normal>("photo"))
                                                          : AnyImage(graph.picture<Exposure>("photo"));
        arguments.inputs.push_back({"image", photo});
        const AnyImage key = graph.add("key", arguments)[""];
        arguments.inputs = {{"image", key}};
        graph.output("color", graph.add("glow", arguments)[""]);
        CHECK(leaves_nothing_out(planned(graph, {.extent = {8, 8}})));
    }
}

TEST_CASE("a step has one condition, and its query is answered before", "[core][skip]")
{
    const PassLibrary library = library_of();
    Chain chain(library);
    const AnyImage key = chain.add("key", chain.photo());
    const AnyImage again = chain.add("key", chain.add("glow", key)); // black by the first: it counts nothing of its own
    const AnyImage other = chain.add("key", chain.add("lift", chain.add("smear", again)));
    const Plan plan = chain.plan(chain.add("both", {{"image", chain.add("glow", other)}, {"glow", other}}));
    REQUIRE_FALSE(plan.queries.empty());
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        const Plan::Step& row = plan.steps[i];
        CHECK((row.counts < 0 || row.skipped_by < 0));
        if (row.counts >= 0)
            CHECK(plan.queries[static_cast<size_t>(row.counts)].step == static_cast<int>(i));
        if (row.skipped_by >= 0)
            CHECK(plan.queries[static_cast<size_t>(row.skipped_by)].step < static_cast<int>(i));
    }
}

TEST_CASE("of two glows in one step a variant takes only the one for black that its own query counted", "[core][skip]")
{
    PassLibrary library = library_of();
    library.add(PassMaker("sum").input("image", kGather, Signal::radiance).input("glow", kGather, Signal::radiance).output("color", Signal::radiance).done());
    Chain chain(library);
    const AnyImage photo = chain.photo();
    const AnyImage first = chain.add("glow", chain.add("key", photo));
    const AnyImage second = chain.add("smear", chain.add("key", chain.add("lift", photo)));
    const Plan plan = chain.plan(chain.add("sum", {{"image", first}, {"glow", second}}));
    CHECK(plan.queries.size() == 2);
    CHECK(conditional(plan) == std::vector<std::string>{"glow", "smear"});
    CHECK(step(plan, "glow").skipped_by != step(plan, "smear").skipped_by);
    CHECK(step(plan, "sum").skipped_by == step(plan, "glow").skipped_by);
    CHECK(step(plan, "sum").black_images == "glow");
}

TEST_CASE("nothing is counted where nothing depends on it", "[core][skip]")
{
    const PassLibrary library = library_of();
    Chain chain(library);
    CHECK(leaves_nothing_out(chain.plan(chain.add("key", chain.photo()))));
}

TEST_CASE("what is cleared is what black is stored as, alpha and all", "[core][skip]")
{
    const Plan plan = planned(demo_that_shows_bright());
    CHECK(step(plan, "eighth").targets.front().black == std::array{0.0f, 0.0f, 0.0f, 1.0f});
    const auto with_alpha = read_graph_description(R"({ "passgraph": 1, "inputs": { "photo": "radiance_alpha" },
        "passes": { "half": { "pass": "downsample", "inputs": { "image": "photo" } } }, "outputs": { "color": "half" } })", "alpha.graph.json");
    REQUIRE(with_alpha);
    CHECK(planned(build_graph(*with_alpha, builtin_passes())).steps.front().targets.front().black == std::array{0.0f, 0.0f, 0.0f, 0.0f});
}

TEST_CASE("a plan says in words what is left out when", "[core][skip][plan]")
{
    const Plan plan = planned(demo_that_shows_bright());
    const std::string text = to_text(plan);
    CHECK_THAT(text, Contains("asks    is any pixel of eighth not black?"));
    CHECK_THAT(text, Contains("runs    only if eighth has a pixel that is not black; else it is black too"));
    CHECK_THAT(text, Contains("variant without glow.vertical, unless eighth has a pixel that is not black"));
    CHECK_THAT(text, Contains("scouts  after a frame without any, 160x90 pixels look first whether there is anything to draw"));
    const auto json = nlohmann::json::parse(to_json(plan, true));
    CHECK(json["queries"].size() == 1);
    CHECK(json["queries"][0]["images"] == "eighth");
    for (size_t i = 0; i < plan.steps.size(); ++i) {
        CHECK(json["steps"][i]["skipped_by"].is_null() == (plan.steps[i].skipped_by < 0));
        CHECK(json["steps"][i]["counts"].is_null() == (plan.steps[i].counts < 0));
        CHECK(json["steps"][i]["scout_extent"].is_null() == plan.steps[i].scout.empty());
        CHECK(json["steps"][i].contains("scout") == !plan.steps[i].scout.empty());
        CHECK(json["steps"][i].contains("when_skipped") == !plan.steps[i].when_skipped.empty());
    }
    CHECK_THAT(to_dot(plan), Contains("only if not black") && Contains("simpler if black") && Contains("style=dashed"));
}
