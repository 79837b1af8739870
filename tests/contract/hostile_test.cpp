// Hostile builtins: NaN where GLSL leaves a result undefined, and the builtin itself everywhere else.
#include <cmath>
#include <limits>

#include <passgraph/gl/evaluate.hpp>

#include "support/catch.hpp"
#include "support/test_context.hpp"
#include "tool/contract/hostile.hpp"

using namespace passgraph;
using namespace passgraph::test;
using namespace passgraph::tool::contract;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// The value of a GLSL expression of x, y and z with every builtin hostile.
float hostile_value(const std::string& expression, float x, float y = 0.0f, float z = 0.0f, const std::string& forgiving = "")
{
    Evaluation evaluation;
    evaluation.declarations = with_hostile("#version 330 core\n", hostile_builtins(), forgiving).substr(std::string("#version 330 core\n").size());
    evaluation.expression = expression;
    evaluation.columns = {"x", "y", "z"};
    evaluation.rows = {{x, y, z}};
    const auto values = evaluate(evaluation, test_context().loader());
    if (!values)
        FAIL(to_text(values.error()));
    return values->front().front();
}

} // namespace

TEST_CASE("hostile builtins are the builtins where GLSL defines them", "[contract][hostile]")
{
    CHECK(hostile_value("min(x, y)", 2.0f, 3.0f) == 2.0f);
    CHECK(hostile_value("max(x, y)", 2.0f, 3.0f) == 3.0f);
    CHECK(hostile_value("clamp(x, y, z)", 5.0f, 0.0f, 1.0f) == 1.0f);
    CHECK(hostile_value("smoothstep(x, y, z)", 0.0f, 1.0f, 0.5f) == 0.5f);
    CHECK(hostile_value("step(x, y)", 0.5f, 1.0f) == 1.0f);
    CHECK(hostile_value("sign(x)", -3.0f) == -1.0f);
    CHECK(hostile_value("sqrt(x)", 4.0f) == 2.0f);
    CHECK(hostile_value("mod(x, y)", 5.0f, 3.0f) == 2.0f);
    CHECK(hostile_value("pow(x, y)", 2.0f, 3.0f) == Approx(8.0f).epsilon(1e-5));
    CHECK(hostile_value("inversesqrt(x)", 4.0f) == Approx(0.5f).epsilon(1e-5));
    CHECK(hostile_value("atan(x)", 1.0f) == Approx(0.785398).epsilon(1e-4));
    CHECK(hostile_value("atan(x, y)", 1.0f, -1.0f) == Approx(2.356194).epsilon(1e-4));
    CHECK(hostile_value("atan(vec2(x, y), vec2(1.0)).y", 1.0f, 0.0f) == 0.0f);
    CHECK(hostile_value("acosh(x)", 1.0f) == Approx(0.0).margin(1e-3));
    CHECK(hostile_value("atanh(x)", 0.0f) == 0.0f);
    CHECK(hostile_value("log2(x)", 8.0f) == Approx(3.0f).epsilon(1e-5));
    CHECK(hostile_value("normalize(vec3(x, y, z)).y", 3.0f, 4.0f) == Approx(0.8f).epsilon(1e-5));
    CHECK(hostile_value("dot(clamp(vec3(x, y, z), 0.0, 1.0), vec3(1.0, 10.0, 100.0))", 2.0f, -1.0f, 0.5f) == 51.0f);
    CHECK(hostile_value("float(clamp(int(x), 0, 3) + max(2, int(y)))", 7.0f, 1.0f) == 5.0f);
}

TEST_CASE("hostile builtins give NaN where GLSL leaves their result undefined", "[contract][hostile]")
{
    for (const char* expression : {"min(x, y)", "min(y, x)", "max(x, y)", "max(y, x)", "clamp(x, 0.0, 1.0)", "clamp(y, x, 1.0)", "sign(x)",
                                   "step(x, y)", "step(y, x)", "smoothstep(0.0, 1.0, x)"}) {
        INFO(expression);
        CHECK(std::isnan(hostile_value(expression, kNan, 1.0f)));
    }
    CHECK(std::isnan(hostile_value("clamp(x, y, z)", 0.5f, 1.0f, 0.0f)));
    CHECK(std::isnan(hostile_value("smoothstep(x, y, z)", 1.0f, 1.0f, 2.0f)));
    CHECK(std::isnan(hostile_value("pow(x, y)", -1.0f, 2.0f)));
    CHECK(std::isnan(hostile_value("pow(x, y)", 0.0f, 0.0f)));
    CHECK(std::isnan(hostile_value("sqrt(x)", -1e-8f)));
    CHECK(std::isnan(hostile_value("inversesqrt(x)", 0.0f)));
    CHECK(std::isnan(hostile_value("log(x)", 0.0f)));
    CHECK(std::isnan(hostile_value("atan(x, y)", 0.0f, -0.0f)));
    CHECK(std::isnan(hostile_value("acosh(x)", 0.99f)));
    CHECK(std::isnan(hostile_value("atanh(x)", -1.0f)));
    CHECK(std::isnan(hostile_value("acos(x)", 1.0000001f)));
    CHECK(std::isnan(hostile_value("mod(x, y)", 1.0f, 0.0f)));
    CHECK(std::isnan(hostile_value("normalize(vec3(x, y, z)).x", 0.0f)));
    CHECK(std::isnan(hostile_value("normalize(vec3(x, y, z)).x", 1e-20f)));
    CHECK(std::isnan(hostile_value("normalize(vec2(x, y)).x", 1e20f, 0.0f)));
}

TEST_CASE("a forgiving builtin gives 0 for its own mistakes and passes on those of others", "[contract][hostile]")
{
    CHECK(hostile_value("sqrt(x)", -1.0f, 0.0f, 0.0f, "sqrt") == 0.0f);
    CHECK(std::isnan(hostile_value("sqrt(log(x))", -1.0f, 0.0f, 0.0f, "sqrt")));
    CHECK(hostile_value("max(x, 0.0)", kNan, 0.0f, 0.0f, "max") == 0.0f);
    CHECK(hostile_value("normalize(vec3(x)).x", 0.0f, 0.0f, 0.0f, "normalize") == 0.0f);
}

TEST_CASE("an ordered select stops NaN whatever the builtins do", "[contract][hostile]")
{
    CHECK(hostile_value("x > 0.0 ? min(x, y) : 0.0", kNan, 1.0f) == 0.0f);
    CHECK(hostile_value("x > 0.0 ? min(x, y) : 0.0", std::numeric_limits<float>::infinity(), 1.0f) == 1.0f);
}

TEST_CASE("a constant made by a hostile builtin becomes a variable, others stay constant", "[contract][hostile]")
{
    const std::string shader = "#version 330 core\nconst float a = max(1.0, 2.0);\nconst int n = 3;\nfloat b[n];\n";
    const std::string hostile = with_hostile(shader, {"max"});
    CHECK(hostile.find("\nfloat a = max(1.0, 2.0);\n") != std::string::npos);
    CHECK(hostile.find("\nconst int n = 3;\n") != std::string::npos);
}
