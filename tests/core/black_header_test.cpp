// "black" and "skip" of a pass header: what they say, and every way to say it wrong.
#include <passgraph/core/graph.hpp>
#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

Result<PassDeclaration> read(const std::string& text)
{
    return read_pass_header(text, "p.glsl", "screen", [](std::string_view) { return std::nullopt; });
}

/// A pass of two inputs around one header member.
std::string with(const std::string& member, const std::string& outputs = R"("color": "color")", const std::string& kind = "image")
{
    const std::string inputs = kind == "image" ? R"("inputs": { "image": "color", "other": "mask" }, )" : "";
    return "/*{ \"pass\": \"own\", \"kind\": \"" + kind + "\", " + inputs + "\"outputs\": { " + outputs + " },\n  " + member +
           "\n}*/\nvec3 own(vec2 uv) { return image(uv); }\n";
}

struct Row {
    std::string text;
    std::vector<std::string> codes;
    std::string hint; ///< part of the first mistake's
};

void check(const std::vector<Row>& rows)
{
    for (const Row& row : rows) {
        const MarkedText source = marked(row.text);
        INFO(source.text);
        const auto pass = read(source.text);
        CHECK(codes_of(pass) == codes_at(source, row.codes));
        if (!pass)
            CHECK_THAT(pass.error().front().hint, Contains(row.hint));
    }
}

} // namespace

TEST_CASE("blackness is handed on by one list for all outputs, or by a list for each", "[core][pass][black]")
{
    const std::string two = R"("left": "color", "right": "color")";
    const auto black = [](const std::string& text) {
        const auto pass = read(text);
        REQUIRE(pass);
        return std::pair{pass->black_inputs(0), pass->black_inputs(1)};
    };
    CHECK(black(with(R"("black": ["image"])", two)) == std::pair{std::vector{0}, std::vector{0}});
    CHECK(black(with(R"("black": ["other", "image"])", two)) == std::pair{std::vector{1, 0}, std::vector{1, 0}});
    CHECK(black(with(R"("black": { "right": ["image"] })", two)) == std::pair{std::vector<int>{}, std::vector{0}});
    CHECK(black(with(R"("summary": "")", two)) == std::pair{std::vector<int>{}, std::vector<int>{}});
}

TEST_CASE("a mistake in \"black\" is told at its place", "[core][pass][black]")
{
    check({
        {with(R"("black": [@"imgae"])"), {"unknown_input"}, "image"},
        {with(R"("black": { @"colour": ["image"] })"), {"unknown_output"}, "color"},
        {with(R"("black": { "color": [@"imgae", @3] })"), {"unknown_input", "wrong_type"}, "image"},
        {with(R"("black": @"image")"), {"wrong_type"}, ""},
        {with(R"("black": @[])"), {"wrong_type"}, ""},
        {with(R"("black": { "color": @true })"), {"wrong_type"}, ""},
        {with(R"("black": ["image", @"image"])"), {"duplicate_name"}, "once"},
        {with(R"("black": [@"scene"])", R"("normal": "normal")", "geometry"), {"black_mismatch"}, "pictures"},
    });
}

TEST_CASE("a mistake in \"skip\" is told at its place", "[core][pass][skip]")
{
    const auto pass = read(with(R"("skip": { "when": "image(uv).r <= 0.0", "value": 0 })"));
    REQUIRE(pass);
    CHECK(pass->skip_when == "image(uv).r <= 0.0");
    CHECK(pass->skip_where.line == 2);
    check({
        {with(R"("skip": @"image(uv).r <= 0.0")"), {"wrong_type"}, ""},
        {with(R"("skip": @{ "when": "true" })"), {"field_missing"}, ""},
        {with(R"("skip": { "when": "true", "value": @1 })"), {"skip_mismatch"}, "\"value\": 0"},
        {with(R"("skip": { "when": "true", "value": @"0" })"), {"wrong_type"}, ""},
        {with(R"("skip": { "when": @" ", "value": 0 })"), {"wrong_type"}, ""},
        {with(R"("skip": { "when": "true", "value": 0, @"else": 1 })"), {"unknown_field"}, ""},
        {with(R"("skip": { "when": "@gl_FragCoord.x < 1.0", "value": 0 })"), {"forbidden_builtin"}, "pixel()"},
        {with(R"("skip": @{ "when": "true", "value": 0 })", R"("left": "color", "right": "color")"), {"skip_mismatch"}, "one output"},
        {with(R"("skip": @{ "when": "true", "value": 0 })", R"("normal": "normal")", "geometry"), {"skip_mismatch"}, "one output"},
    });
}

TEST_CASE("every built-in pass that keeps the law of black says which inputs make it so", "[core][pass][black]")
{
    for (const auto& [name, pass] : builtin_passes().passes()) {
        CAPTURE(name);
        const auto& laws = pass->contract.laws;
        const bool has_law = std::find(laws.begin(), laws.end(), Law::black) != laws.end();
        if (pass->composite || name == "pbr_surface") // a lit surface is black for more reasons than a list says
            continue;
        for (size_t output = 0; output < pass->outputs.size(); ++output)
            CHECK(pass->black_inputs(static_cast<int>(output)).empty() == !has_law);
    }
}
