// Expressions beside the functions of a common file or a pass: their scope, and how many numbers they give.
#include "passgraph/shader/expression.hpp"
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using passgraph::test::Folder;

namespace {

const ExpressionScope kNothing{"", {"generated"}};

/// Components, or 0 when the expression is refused.
int count(const std::string& expression, const ExpressionScope& scope = kNothing)
{
    return expression_components(scope, expression, {"x", "y"}).value_or(0);
}

const char* const kPass = R"(/*{ "pass": "probe", "inputs": { "image": "color" }, "outputs": { "result": "color" },
  "params": { "amount": 0.25 }, "choices": { "way": { "items": ["one", "two"], "default": "two" } } }*/
#include "halved.glsl"
#if way == way_two
vec2 chosen() { return vec2(amount); }
#else
float chosen() { return amount; }
#endif
vec3 probe(vec2 uv) { return image(uv) * halved(amount); }
)";

} // namespace

TEST_CASE("the components of an expression are counted", "[shader][expression]")
{
    CHECK(count("x + y") == 1);
    CHECK(count("vec2(x, y)") == 2);
    CHECK(count("vec3(x)") == 3);
    CHECK(count("vec4(x).wzyx") == 4);
    CHECK(count("vec4(x).zy") == 2);
    CHECK(count("3") == 1);
    CHECK(count("int(x) / 2") == 1);
    CHECK(count("uint(x)") == 1);
    CHECK(count("x < y") == 1);
    CHECK(count("x > 0.0 ? vec2(x) : vec2(y)") == 2);
}

TEST_CASE("an expression that is wrong, or no number, is told at the expression", "[shader][expression]")
{
    const char* const expression = GENERATE("x +", "nothing", "vec2(x, y) + vec3(x)", "mat2(x)", "float[2](x, y)", "sin()", "");
    CAPTURE(expression);
    const auto result = expression_components(kNothing, expression, {"x", "y"});
    REQUIRE_FALSE(result);
    CHECK(result.error().front().code == "glsl_error");
    CHECK(result.error().front().where.file == "expression");
}

TEST_CASE("a common file's functions stand before an expression, with what it includes", "[shader][expression]")
{
    Folder folder;
    folder.write("common/halved.glsl", "// Halves.\nfloat halved(float x) { return 0.5 * x; }\n");
    const auto file = folder.write("common/quartered.glsl", "// Quarters.\n#include \"halved.glsl\"\nvec2 quartered(float x) { return vec2(halved(halved(x))); }\n");
    const auto scope = load_expression_scope(file);
    REQUIRE(scope);
    CHECK(count("quartered(x)", *scope) == 2);
    CHECK(count("halved(x)", *scope) == 1);
    CHECK(count("thirded(x)", *scope) == 0);

    const auto broken = load_expression_scope(folder.write("common/broken.glsl", "// Breaks.\nfloat broken() { return nothing; }\n"));
    REQUIRE_FALSE(broken);
    CHECK(broken.error().front().code == "glsl_error");
    CHECK(broken.error().front().where.line == 2);
    CHECK(load_expression_scope(folder.path() + "/missing.glsl").error().front().code == "file_missing");
    CHECK(load_expression_scope(folder.write("common/lost.glsl", "#include \"gone.glsl\"\n")).error().front().code == "include_missing");
}

TEST_CASE("a pass's functions stand before an expression, its parameters and choices at their defaults", "[shader][expression]")
{
    Folder folder;
    folder.write("common/halved.glsl", "// Halves.\nfloat halved(float x) { return 0.5 * x; }\n");
    const auto scope = load_expression_scope(folder.write("passes/probe.glsl", kPass));
    REQUIRE(scope);
    CHECK(count("probe(vec2(x, y))", *scope) == 3);
    CHECK(count("chosen()", *scope) == 2);
    CHECK(count("amount", *scope) == 1);
    CHECK(scope->declarations.find("uniform") == std::string::npos);

    const auto fallback = load_expression_scope(folder.write("far/away/probe.glsl", kPass), folder.path() + "/common");
    CHECK(fallback);
    const auto hosted = load_expression_scope(folder.write("passes/hosted.glsl", R"(/*{ "pass": "hosted", "reads": ["frame"], "outputs": { "result": "color" } }*/
vec3 hosted(vec2 uv) { return vec3(frame_time()); }
)"));
    REQUIRE_FALSE(hosted);
    CHECK(hosted.error().front().code == "scope_needs_host");
}
