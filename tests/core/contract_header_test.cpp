// Contracts in pass headers: what they say, and each mistake at its place.
#include <passgraph/core/graph_file.hpp>
#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

Result<PassDeclaration> read(const std::string& text)
{
    return read_pass_header(text, "p.glsl", "test", [](std::string_view) { return std::optional<IncludedFile>(); });
}

/// A pass of two lights and a normal into a picture, with these members.
std::string with(const std::string& members, const std::string& output = "\"display\"")
{
    return "/*{ \"pass\": \"own\", \"inputs\": { \"image\": \"radiance\", \"facing\": \"normal\", \"code\": \"display\" },\n"
           "  \"outputs\": { \"color\": " + output + " },\n  " + members +
           "\n}*/\nvec3 own(vec2 uv) { return image(uv) + facing(uv) + code(uv); }\n";
}

std::string contract(const std::string& members) { return with("\"contract\": { " + members + " }"); }

struct Row {
    std::string text;
    std::string code;
    std::string message;
    std::string hint;
};

void check(const std::vector<Row>& rows)
{
    for (const Row& row : rows) {
        const MarkedText source = marked(row.text);
        INFO(source.text);
        const auto pass = read(source.text);
        CHECK(codes_of(pass) == codes_at(source, {row.code}));
        if (pass)
            continue;
        CHECK_THAT(pass.error().front().message, Contains(row.message));
        CHECK_THAT(pass.error().front().hint, Contains(row.hint));
        CHECK(pass.error().front().where.file == "p.glsl");
    }
}

} // namespace

TEST_CASE("a contract says domain, range, what non-finite values do, and laws", "[core][contract]")
{
    const auto pass = read(contract(R"("domain": { "image": [0, 100] }, "range": { "color": [0.25, 1] },
      "non_finite": { "contained": "2 * 3" }, "laws": ["black", "mirror"])"));
    REQUIRE(pass);
    const Contract& stated = pass->contract;
    CHECK(stated.is_stated);
    REQUIRE(stated.domain.size() == 1);
    CHECK(stated.domain[0].port == "image");
    CHECK(stated.domain[0].highest == 100.0);
    CHECK(stated.range[0].lowest == 0.25);
    CHECK(stated.non_finite == Contract::NonFinite::contained);
    CHECK(stated.within->text() == "2 * 3");
    CHECK(stated.laws == std::vector<Law>{Law::black, Law::mirror});
    CHECK(read(contract("\"non_finite\": \"replaced\""))->contract.non_finite == Contract::NonFinite::replaced);
    CHECK(read(contract("\"non_finite\": \"contained\""))->contract.within.has_value() == false);
    CHECK(read(contract("\"non_finite\": { \"contained\": 3 }"))->contract.within->text() == "3");
    CHECK_FALSE(read(with("\"summary\": \"none\""))->contract.is_stated);
}

TEST_CASE("radiance may be cut off by its store, which a range says", "[core][contract]")
{
    const auto pass =
        read(with("\"contract\": { \"non_finite\": \"contained\", \"range\": { \"color\": [0, \"saturated\"] } }", "\"radiance\""));
    REQUIRE(pass);
    CHECK(pass->contract.range[0].is_saturated);
    CHECK(pass->contract.range[0].highest == 65504.0);
}

TEST_CASE("a contract that contradicts the signals of its pass is refused at its place", "[core][contract]")
{
    const std::string code = "contract_contradicts_signal";
    check({
        {contract("\"non_finite\": \"contained\", \"range\": { \"color\": @[0, 2] }"), code, "leaves the domain [0, 1] of display", "keep the output inside"},
        {contract("\"non_finite\": \"contained\", \"range\": { \"color\": @[-1, 1] }"), code, "leaves the domain", "choose another signal"},
        {contract("\"non_finite\": \"contained\", \"domain\": { \"image\": @[0, 1e6] }"), code, "[0, 65504] of radiance", "an input never holds such values"},
        {contract("\"non_finite\": \"contained\", \"domain\": { \"image\": @[1, 0] }"), code, "no value lies in", "the lowest value comes first"},
        {contract("\"non_finite\": \"contained\", \"range\": { \"color\": @[0, \"saturated\"] }"), code, "display ends at 1", "write [0, 1]"},
        {"/*{ \"pass\": \"own\", \"inputs\": { \"facing\": \"normal\" }, \"outputs\": { \"color\": \"radiance\" },\n"
         "  \"contract\": { \"non_finite\": \"contained\", \"laws\": [\"mirror\", @\"energy\"] } }*/\nvec3 own(vec2 uv) { return facing(uv); }\n",
         code, "no input of the pass holds any", "leave the law out"},
    });
}

TEST_CASE("names and forms in a contract are known", "[core][contract]")
{
    check({
        {contract("\"non_finite\": \"contained\", \"laws\": [@\"monoton\"]"), "unknown_law", "no law `monoton`", "did you mean `monotone`?"},
        {contract("\"non_finite\": \"contained\", \"domain\": { @\"imag\": [0, 1] }"), "unknown_input", "no input `imag`", "did you mean `image`?"},
        {contract("\"non_finite\": \"contained\", \"range\": { @\"colour\": [0, 1] }"), "unknown_output", "no output `colour`", "did you mean `color`?"},
        {contract("\"non_finite\": @\"kept\""), "wrong_type", "", ""},
        {contract("\"non_finite\": { \"contained\": @true }"), "wrong_type", "", ""},
        {contract("\"non_finite\": \"contained\", \"range\": { \"color\": @[0] }"), "wrong_type", "", ""},
        {with("\"contract\": @{ \"laws\": [] }"), "field_missing", "non_finite", ""},
        {contract("\"non_finite\": \"contained\", @\"law\": []"), "unknown_field", "", "did you mean `laws`?"},
    });
}

TEST_CASE("an identity between unequal signals or extents is refused with what to do", "[core][contract][identity]")
{
    const std::string identity = "\"identity\": { \"when\": \"true\", \"is\": @";
    check({
        {with(identity + "\"image\" }"), "identity_mismatch", "`image` is radiance, the output `color` is display", "name an input of the output's signal"},
        {with(identity + "\"facing\" }"), "identity_mismatch", "`facing` is normal", "name an input of the output's signal"},
        {with(identity + "\"imagf\" }"), "unknown_input", "no input `imagf`", "did you mean `image`?"},
        {with(identity + "\"code\" }", "{ \"signal\": \"display\", \"size\": { \"of\": \"code\", \"scale\": [1, 2] } }"), "identity_mismatch",
         "another extent than `code`", "never its input"},
        {with(identity + "\"code\" }", "{ \"signal\": \"display\", \"size\": { \"of\": \"image\" } }"), "identity_mismatch", "another extent than `code`",
         "name `image`"},
    });
    CHECK(read(with("\"identity\": { \"when\": \"true\", \"is\": \"code\" }")));
}

TEST_CASE("a composite states a contract as a pass does, and its mistakes have a place", "[core][contract][composite]")
{
    const std::string text = R"({ "passgraph": 1, "pass": "twice", "inputs": { "image": "radiance" },
  "contract": { "non_finite": { "contained": 24 }, "laws": ["constant", @"cnstant"] },
  "passes": { "a": { "pass": "gaussian_blur", "inputs": { "image": "image" } } }, "outputs": { "blurred": "a" } })";
    const MarkedText source = marked(text);
    const auto declare = [](const std::string& file) {
        const auto description = read_graph_description(file, "c.graph.json");
        REQUIRE(description);
        return declare_composite(std::make_shared<const GraphDescription>(*description), "test", builtin_passes());
    };
    CHECK(codes_of(declare(source.text)) == codes_at(source, {"unknown_law"}));
    std::string right = source.text;
    right.replace(right.find("cnstant"), 7, "black");
    const auto pass = declare(right);
    REQUIRE(pass);
    CHECK((*pass)->contract.within->text() == "24");
    CHECK((*pass)->contract.laws == std::vector<Law>{Law::constant, Law::black});
}
