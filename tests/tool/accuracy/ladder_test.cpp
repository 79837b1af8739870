// Every ladder: what is derived of its errors, the order that is claimed, and the numbers that were promised.
#include <algorithm>
#include <cmath>
#include <set>

#include "support/catch.hpp"
#include "support/pass_runner.hpp"
#include "support/test_context.hpp"
#include "tool/accuracy/choose.hpp"
#include "tool/accuracy/compared.hpp"

using namespace passgraph;
using namespace passgraph::accuracy;
using namespace passgraph::test;

namespace {

/// Within its bound, in the order it claims, and finite where it is a default.
void check_ladder(const std::string& name)
{
    const std::vector<MeasuredRung> rungs = compared(ladder_called(name));
    for (const MeasuredRung& rung : rungs) {
        CAPTURE(name, rung.rung.name, rung.worst_input);
        CHECK(rung.deviation.error <= rung.rung.bound);
        if (rung.rung.is_default)
            CHECK(rung.deviation.non_finite == 0.0);
        if (!rung.rung.no_worse_than.empty())
            CHECK(rung.deviation.error <= rung_called(rungs, rung.rung.no_worse_than).deviation.error);
    }
}

} // namespace

TEST_CASE("stored normals are within their codec's bound", "[accuracy][normal_codec]")
{
    check_ladder("normal_codec");
    CHECK(rung_called(compared(ladder_called("normal_codec")), "octahedral_rg16").deviation.largest <= 0.004);
}

TEST_CASE("stored and rebuilt positions are within their bound", "[accuracy][position]") { check_ladder("position"); }
TEST_CASE("stored radiance is within its codec's bound", "[accuracy][radiance_codec]") { check_ladder("radiance_codec"); }
TEST_CASE("the Fresnel edge is within its bound, by pow and by products", "[accuracy][fresnel_power]") { check_ladder("fresnel_power"); }
TEST_CASE("Beckmann's masking is within its bound, by a rational form and by an error function", "[accuracy][beckmann_masking]") { check_ladder("beckmann_masking"); }
TEST_CASE("the filmic curve is within its bound, exact and from a table", "[accuracy][tone_curve]") { check_ladder("tone_curve"); }
TEST_CASE("the sRGB encoding is within its bound, exact and approximated", "[accuracy][srgb_transfer]") { check_ladder("srgb_transfer"); }

TEST_CASE("the Lagrange form of GGX holds 2e-5 where the textbook is percent off", "[accuracy][ggx_form]")
{
    check_ladder("ggx_form");
    const std::vector<MeasuredRung> rungs = compared(ladder_called("ggx_form"));
    CHECK(rung_called(rungs, "lagrange").deviation.error <= 2e-5);
    CHECK(rung_called(rungs, "textbook").deviation.error >= 0.01);
    CHECK(rung_called(rungs, "difference_of_squares").deviation.error >= 0.01);
}

TEST_CASE("guards keep every texel right, and without them bad ones spread", "[accuracy][guards]")
{
    check_ladder("guards");
    const std::vector<MeasuredRung> rungs = compared(ladder_called("guards"));
    // A bad texel reaches 12 to each side: 625 of the 1681 texels it has to itself, for two of three kinds.
    CHECK(rung_called(rungs, "off").deviation.error > 0.1);
    CHECK(rung_called(rungs, "off").deviation.non_finite > 0.1);
    CHECK(rung_called(rungs, "on").deviation.error == 0.0);
}

TEST_CASE("blurs are within their bound and realise the sigma that a table says", "[accuracy][blur]")
{
    check_ladder("blur");
    const std::vector<MeasuredRung> rungs = compared(ladder_called("blur"));
    const Table table = read_table("blur_truncation_error.csv");
    int checked = 0;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        if (table.rows[i][table.column("sigma")] != 3.0 || std::isnan(table.rows[i][table.column("taps")]))
            continue;
        const MeasuredRung& rung = rung_called(rungs, "nearest_" + table.text[i][table.column("taps")]);
        // Second moments of a cell of 72 texels weigh a binary32 rounding at its rim by 36^2 / 9: 144 * 2^-24.
        CHECK(figure_of(rung, "realised sigma") == Approx(table.rows[i][table.column("realised_sigma")]).epsilon(1e-5));
        ++checked;
    }
    CHECK(checked >= 3);
    CHECK(std::abs(figure_of(rung_called(rungs, "nearest_25"), "realised sigma") / 3.0 - 1.0) <= 0.01);
    for (const MeasuredRung& rung : rungs) // a smaller picture shares texels between cells: 2e-5 is one texel's sliver
        CHECK(figure_of(rung, "energy ratio") == Approx(1.0).margin(5e-5));
}

TEST_CASE("linear pairs read between texels with a linear filter, nearest taps do not", "[accuracy][blur]")
{
    const Ladder& ladder = ladder_called("blur");
    const Inputs inputs = ladder.make_inputs({72, 72});
    for (const Rung& rung : ladder.rungs) {
        if (!rung.name.starts_with("linear_") && !rung.name.starts_with("nearest_"))
            continue;
        const auto subject = make_subject(rung, inputs, {72, 72}, probed_library(), test_context().loader());
        REQUIRE(subject);
        for (const Plan::Step& step : subject->renderer.plan().steps)
            CHECK((step.reads.front().filter == Filter::linear) == rung.name.starts_with("linear_"));
    }
}

TEST_CASE("a depth buffer's place is as far off as the table's stored depth, at most twice", "[accuracy][position]")
{
    const Table table = read_table("depth_position.csv");
    const std::vector<MeasuredRung> rungs = compared(ladder_called("position"));
    const std::pair<const char*, const char*> pairs[] = {{"d24", "from_depth24"}, {"d32f", "from_depth32f"}};
    for (const auto& [format, name] : pairs) {
        double worst = 0.0;
        for (size_t i = 0; i < table.rows.size(); ++i)
            if (table.text[i][table.column("mapping")] == "reversed_0_1" && table.text[i][table.column("format")] == format)
                worst = std::max(worst, table.rows[i][table.column("rel_error")]);
        // The table rounds the depth alone; vertices, the ray and the quotient add 5 roundings of binary32.
        CAPTURE(name, worst);
        CHECK(rung_called(rungs, name).deviation.largest <= 2.0 * worst + 5.0 / 16777216.0);
    }
}

TEST_CASE("there are at least 8 ladders of 26 rungs, each with one default and names of its own", "[accuracy]")
{
    std::set<std::string> names;
    size_t rungs = 0;
    for (const Ladder& ladder : all_ladders()) {
        CAPTURE(ladder.name);
        CHECK(names.insert(ladder.name).second);
        std::set<std::string> rung_names;
        for (const Rung& rung : ladder.rungs)
            CHECK(rung_names.insert(rung.name).second);
        for (const Rung& rung : ladder.rungs)
            CHECK((rung.no_worse_than.empty() || rung_names.contains(rung.no_worse_than)));
        CHECK(std::count_if(ladder.rungs.begin(), ladder.rungs.end(), [](const Rung& rung) { return rung.is_default; }) == 1);
        rungs += ladder.rungs.size();
    }
    CHECK(names.size() >= 8);
    CHECK(rungs >= 26);
}

TEST_CASE("every ladder of a built-in pass has a reference", "[accuracy]")
{
    const auto ladders = choose_ladders({}, builtin_passes());
    if (!ladders)
        FAIL(to_text(ladders.error()));
    CHECK(ladders->size() == all_ladders().size());
}
