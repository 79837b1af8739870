// Controls are what the headers say, and hold what the graph and a person say.
#include <cmath>

#include "support/catch.hpp"
#include "view/small_stack.hpp"

using namespace passgraph;
using namespace passgraph::tool::view;

namespace {

const Control& control(const std::vector<PassControls>& all, const std::string& place)
{
    for (const PassControls& pass : all)
        for (const Control& control : pass.controls)
            if (control.place == place)
                return control;
    FAIL("no control " << place);
    throw 0;
}

} // namespace

TEST_CASE("each setting is a control with its header's range, unit and default", "[view][controls]")
{
    const PassLibrary library = test::library_with_knobs();
    const auto stack = test::small_stack();
    const auto all = controls_of(*stack.description, library, {});
    REQUIRE(all.size() == 2);
    const Control& gain = control(all, "film.gain");
    CHECK(gain.kind == Control::Kind::number);
    CHECK((gain.lowest == 0.0 && gain.highest == 4.0 && gain.unit == "stops" && gain.group == "light"));
    CHECK(gain.help.find("Brightness") != std::string::npos);
    CHECK(gain.help.find("default 1") != std::string::npos);
    CHECK(control(all, "film.tint").kind == Control::Kind::color);
    CHECK(control(all, "film.tint").components == 3);
    CHECK(control(all, "film.steps").kind == Control::Kind::whole);
    CHECK(control(all, "film.flip").kind == Control::Kind::flag);
    const Control& shape = control(all, "film.shape");
    CHECK(shape.kind == Control::Kind::item);
    CHECK(shape.items == std::vector<std::string>{"square", "round"});
    CHECK(shape.recompiles);
    CHECK(control(all, "film.taps").recompiles);
    CHECK(control(all, "shown.exposure").is_logarithmic);
    CHECK(control(all, "shown.exposure").value == Value(2.0)); // what the graph file says
    CHECK(control(all, "shown.white").recompiles);
}

TEST_CASE("a changed setting is the control's value and the file's stays to go back to", "[view][controls]")
{
    const PassLibrary library = test::library_with_knobs();
    const auto stack = test::small_stack();
    Settings settings;
    const auto before = controls_of(*stack.description, library, settings);
    settings["shown.exposure"] = setting_of(control(before, "shown.exposure"), Value(8.0));
    settings["film.shape"] = setting_of(control(before, "film.shape"), Value(1.0));
    settings["film.flip"] = setting_of(control(before, "film.flip"), Value(1.0));
    settings["film.tint"] = setting_of(control(before, "film.tint"), Value(0.25, 0.5, 1.0));
    settings["film.gone"] = {"film.gone", {1.0}, "", {}};   // of an older header
    settings["film.gain"] = {"film.gain", {99.0}, "", {}}; // of one with a wider range
    const auto after = controls_of(*stack.description, library, settings);
    CHECK(control(after, "shown.exposure").value == Value(8.0));
    CHECK(control(after, "shown.exposure").original == Value(2.0));
    CHECK(control(after, "film.shape").value == Value(1.0));
    CHECK(control(after, "film.flip").value == Value(1.0));
    CHECK(control(after, "film.tint").value == Value(0.25, 0.5, 1.0));
    CHECK(control(after, "film.gain").value == Value(1.0));
}

TEST_CASE("values are brought into range, onto steps, and made finite", "[view][controls]")
{
    const auto all = controls_of(*test::small_stack().description, test::library_with_knobs(), {});
    CHECK(fitted(control(all, "film.gain"), Value(9.0)) == Value(4.0));
    CHECK(fitted(control(all, "film.gain"), Value(-1.0)) == Value(0.0));
    CHECK(fitted(control(all, "film.gain"), Value(std::nan(""))) == Value(1.0));
    CHECK(fitted(control(all, "film.fine"), Value(0.3)) == Value(0.25));
    CHECK(fitted(control(all, "film.steps"), Value(3.4)) == Value(3.0));
    CHECK(fitted(control(all, "film.shape"), Value(7.0)) == Value(1.0));
}

TEST_CASE("a composite's parameters are controls of one pass", "[view][controls]")
{
    const auto graph = read_graph_description(
        R"({ "passgraph": 1, "inputs": { "a": "radiance" }, "passes": { "glow": { "pass": "gaussian_blur", "inputs": { "image": "a" }, "rungs": { "taps": "25" } } }, "outputs": { "color": "glow" } })",
        "g.graph.json");
    REQUIRE(graph);
    const auto all = controls_of(*graph, builtin_passes(), {});
    REQUIRE(all.size() == 1);
    CHECK(all.front().name == "glow");
    CHECK(control(all, "glow.sigma").unit == "texels");
    const Control& taps = control(all, "glow.taps");
    CHECK(taps.items[static_cast<size_t>(taps.value.v[0])] == "25");
}

TEST_CASE("a parameter is visible where its visible_if holds", "[view][controls]")
{
    const PassLibrary library = test::library_with_knobs();
    const auto stack = test::small_stack();
    CHECK_FALSE(control(controls_of(*stack.description, library, {}), "film.steps").is_visible);
    Settings settings;
    settings["film.shape"] = {"film.shape", {}, "round", {}};
    CHECK(control(controls_of(*stack.description, library, settings), "film.steps").is_visible);
}
