// What a report says, from measurements made by hand.
#include <algorithm>
#include <filesystem>

#include <passgraph/image/image_file.hpp>

#include "support/catch.hpp"
#include "tool/accuracy/report/chart.hpp"
#include "tool/accuracy/report/report.hpp"
#include "tool/schema.hpp"

using namespace passgraph;
using namespace passgraph::accuracy;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

const Ladder& ladder_of_three()
{
    static const Ladder ladder{.name = "speed",
                               .title = "Speed & <sense>",
                               .stage = "display",
                               .about = "About it.",
                               .passes = {"tone_map"},
                               .metric = {"difference, largest", "degrees", Distance::absolute, Summary::largest}};
    return ladder;
}

Measurements measurements_of_three()
{
    MeasuredLadder ladder{.ladder = &ladder_of_three()};
    const std::pair<const char*, double> rungs[] = {{"coarse", 0.1}, {"slow", 0.2}, {"exact", 0.0}};
    for (const auto& [name, error] : rungs) {
        MeasuredRung rung;
        rung.rung.name = name;
        rung.rung.bound = 0.5;
        rung.rung.is_default = std::string(name) == "exact";
        rung.deviation.error = error;
        rung.figures = {{"realised sigma", 2.5}};
        rung.worst_input = "here, \"there\"";
        rung.bytes_per_pixel = 4.0;
        rung.crop = Picture({2, 1}, 3);
        rung.differences = {0.1, -0.1};
        ladder.rungs.push_back(rung);
    }
    ladder.truth_crop = Picture({2, 1}, 3);
    ladder.map_limit = 0.1;
    judge(ladder, {std::vector<double>(15, 2.0), std::vector<double>(15, 4.0), std::vector<double>(15, 8.0), std::vector<double>(15, 8.0)});
    return {{std::move(ladder)}, false, "A renderer"};
}

Conditions conditions_of_a_test()
{
    Conditions conditions = conditions_now({}, "osmesa");
    complete(conditions, {{}, false, "llvmpipe (LLVM 15), OpenGL 4.5"}, 12.0);
    return conditions;
}

Json json_of(const std::string& text)
{
    const auto json = parse_json(text, "accuracy.json");
    if (!json)
        FAIL(to_text(json.error()));
    return *json;
}

} // namespace

TEST_CASE("the report's JSON keeps its schema and names ladder, rung, error, metric and milliseconds", "[accuracy][report]")
{
    const Json json = json_of(report_json(measurements_of_three(), conditions_of_a_test()));
    CHECK(test::find_schema_violations(json, test::read_schema("lib/tool/schemas/accuracy.schema.json")) == std::vector<std::string>{});
    const Json& slow = json.find("rungs")->array.at(1);
    CHECK(slow.find("ladder")->string == "speed");
    CHECK(slow.find("rung")->string == "slow");
    CHECK(slow.find("error")->number == 0.2);
    CHECK(slow.find("metric")->string == "difference, largest");
    CHECK(slow.find("ms")->number == 4.0);
    CHECK(slow.find("dominated_by")->string == "coarse");
    CHECK(json.find("conditions")->find("renderer")->string == "llvmpipe (LLVM 15), OpenGL 4.5");
    CHECK_FALSE(json.find("conditions")->find("commit")->string.empty());
}

TEST_CASE("the report's CSV has a row per rung, with texts quoted", "[accuracy][report]")
{
    const std::string text = report_csv(measurements_of_three());
    CHECK(std::count(text.begin(), text.end(), '\n') == 4);
    CHECK_THAT(text, Contains("\"here, \"\"there\"\"\"") && Contains("realised sigma=2.5"));
}

TEST_CASE("the page stands alone: charts, tables, pictures and conditions are in it, and it loads nothing", "[accuracy][report]")
{
    const std::string page = report_html(measurements_of_three(), conditions_of_a_test());
    CHECK_THAT(page, Contains("<svg") && Contains("data:image/png;base64,") && Contains("id=\"conditions\"") && Contains("Speed &amp; &lt;sense&gt;"));
    CHECK_THAT(page, Contains("<code>slow</code>") && Contains("dominated by <code>coarse</code>") && Contains("software rendering"));
    for (const char* loader : {"<script", "<link", "src=\"http", "href=\"http", "url("})
        CHECK(page.find(loader) == std::string::npos);
    CHECK(page.find("too noisy") == std::string::npos);
}

TEST_CASE("a machine too noisy to measure, and an interruption, are said at the top", "[accuracy][report]")
{
    Measurements measurements = measurements_of_three();
    measurements.ladders.front().noise_floor = 0.3;
    Conditions conditions = conditions_of_a_test();
    conditions.is_interrupted = true;
    const std::string page = report_html(measurements, conditions);
    CHECK_THAT(page, Contains("too noisy") && Contains("Interrupted"));
    CHECK(json_of(report_json(measurements, conditions)).find("ladders")->array.front().find("is_noisy")->boolean);
}

TEST_CASE("a chart rings the default, greys and names what is dominated, and gives an error of 0 its own line", "[accuracy][report]")
{
    const std::string svg = to_svg(pareto_chart(measurements_of_three().ladders.front()));
    CHECK_THAT(svg, Contains("exact (default)") && Contains("dominated by coarse") && Contains(">0</text>"));
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("a drawing's pixels are where its shapes are", "[accuracy][report]")
{
    Drawing drawing{10.0, 6.0, "", {BoxShape{0.0, 0.0, 5.0, 6.0, 0xff0000}, DiscShape{8.0, 2.0, 1.5, 0x0000ff, 0, 0.0}, LineShape{0.0, 5.0, 10.0, 5.0, 0x00ff00, 1.0}}};
    const Picture picture = to_picture(drawing, 2.0);
    REQUIRE(picture.extent == Extent{20, 12});
    const auto color = [&](int x, int y) { return std::array<float, 3>{picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)}; };
    CHECK(color(4, 8) == std::array<float, 3>{1.0f, 0.0f, 0.0f}); // rows count from below
    CHECK(color(16, 7) == std::array<float, 3>{0.0f, 0.0f, 1.0f});
    CHECK(color(12, 11) == std::array<float, 3>{1.0f, 1.0f, 1.0f});
    CHECK(color(12, 2)[1] == 1.0f);
    CHECK(color(12, 2)[0] < 0.6f);
}

TEST_CASE("a report's folder holds page, JSON, CSV and a chart as SVG and PNG; a folder that cannot be made is an error", "[accuracy][report]")
{
    const fs::path folder = fs::temp_directory_path() / "passgraph_report_test";
    fs::remove_all(folder);
    REQUIRE(write_report(folder.string(), measurements_of_three(), conditions_of_a_test()));
    for (const char* file : {"index.html", "accuracy.json", "accuracy.csv", "charts/speed.svg", "charts/speed.png"})
        CHECK(fs::file_size(folder / file) > 100);
    CHECK(read_picture((folder / "charts/speed.png").string(), Transfer::as_is)->extent.width == 1520);
    const auto failed = write_report((folder / "index.html").string(), measurements_of_three(), conditions_of_a_test());
    REQUIRE_FALSE(failed);
    CHECK(failed.error().front().code == "file_unwritable");
    fs::remove_all(folder);
}
