// Scouts: what they look at, which draws have none, and how passes that look at whole texels read them.
#include <passgraph/core/graph_file.hpp>

#include "core_support.hpp"
#include "skip_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

TEST_CASE("whole texels are loaded by passes that look at nothing else, where the device does that quicker", "[core][skip]")
{
    const auto loaded = [](int most) {
        CompileOptions options;
        options.device.max_loaded_images = most;
        std::vector<std::string> names;
        for (const Plan::Step& candidate : planned(demo(), options).steps)
            for (const Plan::Read& read : candidate.reads) {
                const std::string declaration = "readonly uniform image2D " + read.sampler + ";";
                for (const std::string* text : {&candidate.fragment, &candidate.scout})
                    CHECK(((text->find(declaration) != std::string::npos) == read.is_loaded || text->empty()));
                if (read.is_loaded)
                    names.push_back(candidate.name + " loads " + read.image);
            }
        return names;
    };
    CHECK(loaded(0).empty());
    CHECK(loaded(1) == std::vector<std::string>{"bright + eighth loads view"}); // and so does its scout
}

TEST_CASE("a scout looks at all that a draw is black with, a pixel for a block of texels", "[core][skip]")
{
    const auto counting = [](const Plan& plan) { return plan.steps[static_cast<size_t>(plan.queries.front().step)]; };
    PassLibrary library = library_of();
    const auto add = [&](const std::string& name, const std::string& body, const std::string& skip, bool is_black) {
        PassMaker pass(name);
        pass.input("image", kPointwise, Signal::radiance).output("color", Signal::radiance);
        if (!body.empty())
            pass.body(body);
        pass.pass.skip_when = skip;
        if (is_black)
            pass.pass.black = {{0}};
        library.add(pass.done());
    };
    add("grade", "", "", false);
    add("checks", "vec3 checks(vec2 uv) { return image(uv) * float(pixel().x % 2); }\n", "image(uv).r <= 0.5", false);
    {
        Chain chain(library);
        const Plan plan = chain.plan(chain.add("smear", chain.add("glow", chain.add("key", chain.photo()))));
        CHECK(counting(plan).name == "key");
        CHECK_THAT(counting(plan).scout, Contains("passgraph_skips"));
        CHECK(counting(plan).scout_extent == Extent{8, 8}); // of 64 x 64
    }
    { // what the draw reads of others, once the pass itself is another draw's
        Chain chain(library);
        const AnyImage key = chain.add("key", chain.photo());
        chain.graph().output("grade", chain.add("grade", key));
        const Plan plan = chain.plan(chain.add("smear", chain.add("glow", key)));
        CHECK(plan.steps.front().name == "key + grade");
        CHECK(counting(plan).name == "glow");
        CHECK_THAT(counting(plan).scout, !Contains("passgraph_skips") && Contains("image_0(uv) == vec3(0.0)"));
        CHECK(conditional(plan) == std::vector<std::string>{"smear"});
    }
    { // a value of another pass of its draw is nowhere to be looked at
        Chain chain(library);
        const Plan plan = chain.plan(chain.add("smear", chain.add("glow", chain.add("key", chain.add("grade", chain.photo())))));
        CHECK(counting(plan).name == "grade + key");
        CHECK(counting(plan).scout.empty());
    }
    { // nor are texels of another extent where the pass looks
        Chain chain(library);
        const AnyImage key = chain.add("key", {{"image", chain.photo()}}, Ratio{2, 1});
        const Plan plan = chain.plan(chain.add("smear", chain.add("glow", key)));
        CHECK(counting(plan).name == "key");
        CHECK(counting(plan).scout.empty());
    }
    { // or images of two extents of one block
        Chain chain(library);
        const AnyImage key = chain.add("key", chain.photo());
        const AnyImage small = chain.add("glow", {{"image", key}}, Ratio{1, 2});
        chain.graph().output("grade", chain.add("grade", key));
        chain.graph().output("small", chain.add("grade", small));
        const Plan plan = chain.plan(chain.add("smear", chain.add("both", {{"image", key}, {"glow", small}})));
        CHECK(counting(plan).name == "both");
        CHECK(counting(plan).scout.empty());
    }
    { // nor is one texel enough for a pass that looks at its neighbours
        PassMaker wide("wide");
        wide.input("image", kGather, Signal::radiance).output("color", Signal::radiance);
        wide.pass.skip_when = "image(uv).r <= 0.5";
        library.add(wide.done());
        Chain chain(library);
        const Plan plan = chain.plan(chain.add("smear", chain.add("glow", chain.add("wide", chain.photo()))));
        CHECK(counting(plan).name == "wide");
        CHECK(counting(plan).scout.empty());
    }
    { // nor does a scout know where there is a surface
        PassLibrary with_depth = builtin_passes();
        PassMaker rim("rim");
        rim.input("image", kPointwise, Signal::radiance).input("depth", kPointwise, Signal::depth).output("color", Signal::radiance);
        rim.pass.skip_when = "image(uv).r <= 0.5";
        rim.pass.only_where = OnlyWhere::depth;
        with_depth.add(rim.done());
        const auto description = read_graph_description(R"({ "passgraph": 1, "inputs": { "scene": { "kind": "scene" }, "photo": "radiance" },
            "passes": {
                "surface": { "pass": "gbuffer", "inputs": { "scene": "scene" } },
                "rim": { "pass": "rim", "inputs": { "image": "photo", "depth": "surface.depth" } },
                "soft": { "pass": "gaussian_blur", "inputs": { "image": "rim" } } },
            "outputs": { "color": "soft" } })", "rim.graph.json");
        REQUIRE(description);
        const Plan plan = planned(build_graph(*description, with_depth), {.extent = {64, 64}, .picture_extents = {{"photo", {64, 64}}}});
        CHECK(counting(plan).name == "rim");
        CHECK(counting(plan).tested_depth_slot >= 0);
        CHECK(counting(plan).scout.empty());
    }
    { // nor can a pass be asked elsewhere that asks which pixel it is
        Chain chain(library);
        const Plan plan = chain.plan(chain.add("smear", chain.add("glow", chain.add("checks", chain.photo()))));
        CHECK(counting(plan).name == "checks");
        CHECK(counting(plan).scout.empty());
    }
}
