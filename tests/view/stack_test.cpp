// Plans of a stack: what runs alike, what has to be made anew, and the images there are to look at.
#include <algorithm>

#include "support/catch.hpp"
#include "view/small_stack.hpp"

using namespace passgraph;
using namespace passgraph::tool::view;

TEST_CASE("a live value runs with the same plan, a choice, a static and an extent do not", "[view][stack]")
{
    const PassLibrary library = test::library_with_knobs();
    Stack stack = test::small_stack();
    const auto plan = [&](Extent extent = {64, 36}) {
        const auto made = plan_of(stack, library, {.extent = extent});
        REQUIRE(made);
        return *made;
    };
    const Plan first = plan();
    CHECK(runs_alike(first, plan()));
    stack.settings["film.gain"] = {"film.gain", {2.0}, "", {}};
    CHECK(runs_alike(first, plan()));
    CHECK_FALSE(runs_alike(first, plan({65, 36})));
    stack.settings["film.shape"] = {"film.shape", {}, "round", {}};
    CHECK_FALSE(runs_alike(first, plan()));
    stack.settings.erase("film.shape");
    stack.settings["shown.white"] = {"shown.white", {4.0}, "", {}};
    CHECK_FALSE(runs_alike(first, plan()));
    stack.settings.clear();
    stack.shown = "shown";
    CHECK_FALSE(runs_alike(first, plan()));
    CHECK(plan().outputs.front().name == "shown");
}

TEST_CASE("every image of the graph is an output of the plan of all images", "[view][stack]")
{
    const PassLibrary library = test::library_with_knobs();
    const Stack stack = test::small_stack();
    const std::vector<std::string> images = images_of(stack, library);
    CHECK(images == std::vector<std::string>{"shown", "film"});
    const auto plan = plan_of_all_images(stack, library, {.extent = {8, 8}});
    REQUIRE(plan);
    REQUIRE(plan->outputs.size() == images.size());
    for (size_t i = 0; i < images.size(); ++i)
        CHECK(plan->outputs[i].name == images[i]);
}

TEST_CASE("a graph's own params are settings of its passes", "[view][stack]")
{
    const auto settings = settings_by_place({{"knob", {3.0}, "", {}}, {"film.fine", {0.5}, "", {}}}, *test::small_stack().description);
    REQUIRE(settings.size() == 3);
    CHECK(settings.at("film.gain").numbers == std::vector<double>{3.0});
    CHECK(settings.at("shown.exposure").numbers == std::vector<double>{3.0});
    CHECK(settings.at("film.fine").name == "film.fine");
}

TEST_CASE("a stack is called like its file", "[view][stack]")
{
    CHECK(stack_name("samples/demo/bloom.graph.json") == "bloom");
    CHECK(stack_name("x") == "x");
}
