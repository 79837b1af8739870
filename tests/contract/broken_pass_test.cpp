// Passes broken on purpose: each is caught, by the check that is meant for its kind of mistake.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "support/catch.hpp"
#include "tool/program.hpp"
#include "tool/schema.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

struct Broken {
    std::string check; ///< that catches it
    std::string hint;  ///< part of what it says: the cause
};

const std::map<std::string, Broken>& table()
{
    static const std::map<std::string, Broken> rows = {
        {"acos_above_one", {"finite", "`acos` undefined"}},
        {"adds_a_floor", {"law_scale", "a constant is added"}},
        {"angle_of_nothing", {"finite", "`atan` undefined"}},
        {"center_counted_twice", {"law_constant", "the middle one counted twice"}},
        {"clamp_as_guard", {"replaced", "clamp of NaN are undefined"}},
        {"clamp_as_guard_unstated", {"bound_as_guard", "clamp is undefined for NaN"}},
        {"darker_when_brighter", {"law_monotone", "less come out"}},
        {"gains_energy", {"law_energy", "a factor of pi"}},
        {"glows_in_the_dark", {"black", "correct \"black\""}},
        {"lit_without_lamps", {"needs", "correct \"needs\""}},
        {"log_of_zero", {"finite", "`log2` undefined"}},
        {"naive_ggx", {"finite", "0 / 0"}},
        {"normalize_zero", {"finite", "`normalize` undefined"}},
        {"not_its_input", {"identity", "correct \"identity\""}},
        {"output_above_range", {"range", "cut it off unseen"}},
        {"pow_of_negative", {"finite", "`pow` undefined"}},
        {"reads_beyond_its_reach", {"contained", "correct \"contained\""}},
        {"replaces_by_max", {"replaced", "ordered select"}},
        {"sky_over_everything", {"only_where", "correct \"only_where\""}},
        {"skips_too_much", {"skip", "correct \"skip\""}},
        {"slightly_negative", {"range", "cut it off unseen"}},
        {"smoothstep_equal_edges", {"finite", "`smoothstep` undefined"}},
        {"sqrt_of_negative", {"finite", "`sqrt` undefined"}},
        {"unbounded_attenuation", {"finite", "x / 0"}},
        {"unguarded_division", {"finite", "0 / 0"}},
        {"wrong_mirror", {"law_mirror", "sign wrong"}},
    };
    return rows;
}

std::string path_of(const std::string& name) { return std::string(PASSGRAPH_SOURCE_DIR) + "/tests/contract/broken/" + name + ".glsl"; }

/// The reports of all broken passes, from one run of the program.
const Json& reports()
{
    static const Json json = [] {
        const Workplace place;
        std::vector<std::string> words = {"test", "--json"};
        for (const auto& [name, broken] : table())
            words.push_back(path_of(name));
        const Outcome outcome = place.run(words);
        CHECK(outcome.code == 1);
        CHECK_THAT(outcome.err, Contains("error[contract_broken] 26 of 26 passes"));
        return json_of(outcome.out);
    }();
    return json;
}

const Json& report_of(const std::string& name)
{
    for (const Json& report : reports().find("passes")->array)
        if (report.find("pass")->string == name)
            return report;
    FAIL("no report of " << name);
    return reports();
}

} // namespace

TEST_CASE("every broken pass is caught by the check that is meant for it", "[contract][broken]")
{
    for (const auto& [name, broken] : table()) {
        INFO(name);
        std::string failed;
        std::string hints;
        for (const Json& check : report_of(name).find("checks")->array) {
            if (check.find("faults")->number == 0.0)
                continue;
            failed += check.find("check")->string + " ";
            for (const Json& finding : check.find("findings")->array)
                if (check.find("check")->string == broken.check)
                    hints += finding.find("hint")->string;
        }
        CHECK_THAT(failed, Contains(broken.check + " "));
        CHECK_THAT(hints, Contains(broken.hint));
    }
}

TEST_CASE("a mistake is caught by its own check and by few others", "[contract][broken]")
{
    for (const auto& [name, broken] : table()) {
        INFO(name);
        std::set<std::string> failed;
        for (const Json& check : report_of(name).find("checks")->array)
            if (check.find("faults")->number > 0.0)
                failed.insert(check.find("check")->string);
        failed.erase(broken.check);
        if (name == "adds_a_floor")
            failed.erase("law_black"); // the other law that a constant breaks
        CHECK(failed == std::set<std::string>{});
    }
}

TEST_CASE("every file of broken passes is in the table", "[contract][broken]")
{
    std::set<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(PASSGRAPH_SOURCE_DIR) + "/tests/contract/broken"))
        files.insert(entry.path().stem().string());
    std::set<std::string> named;
    for (const auto& [name, broken] : table())
        named.insert(name);
    CHECK(files == named);
    CHECK(files.size() >= 12);
}

TEST_CASE("a finding says with what, where, what came and what should have", "[contract][broken]")
{
    CHECK(find_schema_violations(reports(), read_schema("lib/tool/schemas/test.schema.json")) == std::vector<std::string>{});
    const Workplace place;
    const Outcome outcome = place.run({"test", path_of("reads_beyond_its_reach")});
    CHECK(outcome.code == 1);
    CHECK_THAT(outcome.out, Contains("FAIL  reads_beyond_its_reach contained"));
    CHECK_THAT(outcome.out, Contains("fed with NaN in `image` at (8, 6)"));
    CHECK_THAT(outcome.out, Contains("`color` at (3, 6) of 17x13: got nan, nan, nan, expected"));
    CHECK_THAT(outcome.out, Contains("1 texels away at most"));
}
