// "identity", "needs", "bound", "ignores" and formulas in other fields of a pass header: what they say, and each mistake at its place.
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

std::string with(const std::string& member, const std::string& outputs = R"("color": "radiance")")
{
    return R"(/*{ "pass": "own", "inputs": { "image": "radiance", "glow": "radiance", "facing": "normal" }, "outputs": { )" + outputs +
           R"( }, "params": { "amount": 0.5, "tint": { "type": "color", "default": [1, 1, 1], "range": [0, 1] } },
  "choices": { "shape": ["round", "square"] },
  )" + member + "\n}*/\nvec3 own(vec2 uv) { return image(uv) + glow(uv) + facing(uv); }\n";
}

struct Row {
    std::string member;
    std::string code;
    std::string hint;
    std::string outputs = R"("color": "radiance")";
};

} // namespace

TEST_CASE("a header says when work may be left out", "[core][conditions]")
{
    const auto pass = read(with(R"("identity": [ { "when": "amount == 0 || glow == 0", "is": "image" }, { "when": "amount == 1", "is": "glow" } ],
      "needs": ["lights", "sky"], "bound": "max(image, glow) * amount", "ignores": { "facing": "shape == shape_square" })"));
    REQUIRE(pass);
    REQUIRE(pass->identities.size() == 2);
    CHECK(pass->identities[0].is == "image");
    CHECK(pass->identities[1].when.text() == "amount == 1");
    CHECK(pass->needs == std::vector<std::string>{"lights", "sky"});
    CHECK(pass->outputs.front().bound->text() == "max(image, glow) * amount");
    CHECK_FALSE(pass->inputs[0].ignored_when);
    CHECK(pass->inputs[2].ignored_when->text() == "shape == shape_square");
    const auto two = read(with(R"("bound": { "right": "glow" }, "needs": "metal")", R"("left": "radiance", "right": "radiance")"));
    REQUIRE(two);
    CHECK_FALSE(two->outputs[0].bound);
    CHECK(two->outputs[1].bound);
    CHECK(two->needs == std::vector<std::string>{"metal"});
    CHECK(read(with(R"("identity": { "when": "image_behind == 0 && tint.g == 1", "is": "image" })")));
}

TEST_CASE("each mistake of a condition is an error at its place", "[core][conditions]")
{
    for (const Row& row : std::vector<Row>{
             {R"("identity": { "when": "@amuont == 0", "is": "image" })", "unknown_name", "did you mean `amount`"},
             {R"("identity": { "when": "amount @= 0", "is": "image" })", "formula_syntax", "as in GLSL"},
             {R"("identity": { "when": "amount == 0", "is": @"imige" })", "unknown_input", "did you mean `image`"},
             {R"("identity": { "when": "amount == 0", "is": @"facing" })", "identity_mismatch", "an input of the output's signal"},
             {R"("needs": @"lamps")", "unknown_fact", "facts"},
             {R"("needs": ["lights", @"spotlights"])", "unknown_fact", "did you mean `spot_lights`"},
             {R"("needs": @3)", "wrong_type", ""},
             {R"("bound": "image * @ammount")", "unknown_name", "did you mean `amount`"},
             {R"("bound": @3)", "wrong_type", ""},
             {R"("bound": { @"colour": "1" })", "unknown_output", "did you mean `color`"},
             {R"("bound": @"1")", "bound_without_black", "light", R"("color": "normal")"},
             {R"("ignores": { @"iamge": "amount == 0" })", "unknown_input", "did you mean `image`"},
             {R"("ignores": { "glow": "@shap == 0" })", "unknown_name", "did you mean `shape`"},
             {R"("ignores": { "glow": @true })", "wrong_type", ""},
             {R"("identity": [ { "when": "amount == 0", "is": "image" }, { "when": "amount == @", "is": "glow" } ])", "formula_syntax", "as in GLSL"},
             {R"("identity": [ { "when": "amount == 0", "is": "image" }, { "when": "amount == 1", "is": @"gloww" } ])", "unknown_input", "did you mean `glow`"},
             {R"("identity": @"image")", "wrong_type", ""},
             {R"("identity": { "when": @3, "is": "image" })", "wrong_type", ""},
             {R"("identity": { "when": "amount == 0", "is": @3 })", "wrong_type", ""},
             {R"("identity": @{ "when": "amount == 0" })", "field_missing", "is"},
             {R"("identity": @{ "is": "image" })", "field_missing", "when"},
             {R"("identity": { "when": "amount == 0", "is": "image", @"iss": "glow" })", "unknown_field", "did you mean `is`"},
             {R"("identity": { "when": "amount == 0", "is": @"image" })", "identity_mismatch", "one output", R"("left": "radiance", "right": "radiance")"},
             {R"("identity": { "when": "amount == 0", "is": @"image" })", "identity_mismatch", "name `glow`",
              R"("color": { "signal": "radiance", "size": { "of": "glow" } })"},
             {R"("identity": { "when": "@glow_behnd == 0", "is": "image" })", "unknown_name", ""},
             {R"("needs": ["lights", @3])", "wrong_type", "name"},
             {R"("needs": [@"lihgts"])", "unknown_fact", "did you mean `lights`"},
             {R"("needs": @{ "lights": 1 })", "wrong_type", ""},
             {R"("bound": "image * (amount@")", "formula_syntax", "as in GLSL"},
             {R"("bound": @["1"])", "wrong_type", ""},
             {R"("bound": { "color": @3 })", "wrong_type", ""},
             {R"("bound": { "left": "image", "right": "@imago" })", "unknown_name", "did you mean `image`", R"("left": "radiance", "right": "radiance")"},
             {R"("bound": @"image")", "wrong_type", "", R"("left": "radiance", "right": "radiance")"},
             {R"("bound": { "facing_out": @"1" })", "bound_without_black", "light", R"("color": "radiance", "facing_out": "normal")"},
             {R"("ignores": @["glow"])", "wrong_type", ""},
             {R"("ignores": { "glow": "amount @= 0" })", "formula_syntax", "as in GLSL"},
             {R"("ignores": { "glow": "shape == @shape_rond" })", "unknown_name", "did you mean `shape_round`"},
             {R"("contract": { "non_finite": { "contained": "2 * @" } })", "formula_syntax", "as in GLSL"},
             {R"("contract": { "non_finite": { "contained": "@image" } })", "unknown_name", "parameters and choices"},
             {R"("contract": { "non_finite": { "contained": "@lights" } })", "unknown_name", "parameters and choices"},
             {R"("contract": { "non_finite": { "contained": @[3] } })", "wrong_type", ""},
             {R"("contract": { "non_finite": { "contained": @-1 } })", "wrong_type", ""},
             {R"("contract": { "non_finite": { "contained": "@sigma" } })", "unknown_name", "parameters and choices"}}) {
        const MarkedText source = marked(with(row.member, row.outputs));
        INFO(source.text);
        const auto pass = read(source.text);
        CHECK(codes_of(pass) == codes_at(source, {row.code}));
        if (!pass)
            CHECK_THAT(pass.error().front().message + " " + pass.error().front().hint, Contains(row.hint));
    }
}

TEST_CASE("the formulas of a header are all read, and their mistakes come together", "[core][conditions]")
{
    const MarkedText source = marked(with(R"("identity": [ { "when": "@amuont == 0", "is": "image" }, { "when": "1 @1", "is": "glow" } ],
      "needs": ["lights", @"lamps"], "bound": "@imige", "ignores": { @"iamge": "amount == 0", "glow": "@shap == 0" })"));
    const auto pass = read(source.text);
    CHECK(codes_of(pass) ==
          codes_at(source, {"unknown_name", "formula_syntax", "unknown_fact", "unknown_name", "unknown_input", "unknown_name"}));
}

TEST_CASE("a formula of a header knows parameters, choices, items, inputs and facts", "[core][conditions]")
{
    for (const char* name : {"amount", "tint.b", "shape", "shape_round", "image", "glow_behind", "lights", "spot_lights", "irradiance", "highlight",
                             "metal", "emission", "sky", "surfaces"}) {
        CAPTURE(name);
        CHECK(read(with(R"("ignores": { "glow": ")" + std::string(name) + R"( == 0" })")));
    }
    const auto pass = read(with(R"("contract": { "non_finite": { "contained": "shape == shape_round ? 2 * amount : 3" } })"));
    REQUIRE(pass);
    CHECK(pass->contract.within->text() == "shape == shape_round ? 2 * amount : 3");
}
