// Formulas of headers: what they are worth, and where they are wrong.
#include <cmath>
#include <map>
#include <random>

#include <passgraph/core/formula.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

double value(const std::string& text)
{
    const auto formula = Formula::parse(text, {"p.glsl", 1, 1});
    if (!formula)
        FAIL(to_text(formula.error()));
    const std::map<std::string, Formula::Number, std::less<>> names = {
        {"a", {{2.0}, 1}}, {"b", {{-0.5}, 1}}, {"zero", {{0.0}, 1}}, {"tint", {{0.25, 0.5, 1.0}, 3}}, {"white", {{1.0, 1.0, 1.0}, 3}}};
    return formula->value([&](std::string_view name) -> std::optional<Formula::Number> {
        const auto found = names.find(name);
        return found == names.end() ? std::nullopt : std::optional(found->second);
    });
}

} // namespace

TEST_CASE("formulas follow GLSL's precedence", "[core][formula]")
{
    CHECK(value("1 + 2 * 3") == 7.0);
    CHECK(value("(1 + 2) * 3") == 9.0);
    CHECK(value("8 - 4 - 2") == 2.0);
    CHECK(value("8 / 4 / 2") == 1.0);
    CHECK(value("-a * -a") == 4.0);
    CHECK(value("1 < 2 == 3 < 4") == 1.0);
    CHECK(value("1 == 2 || 1 == 1 && 2 == 3") == 0.0);
    CHECK(value("(1 == 1 || 1 == 1) && 2 == 3") == 0.0);
    CHECK(value("1 == 1 || 2 == 3 && 1 == 3") == 1.0);
    CHECK(value("a > 1 ? a > 3 ? 10 : 20 : 30") == 20.0);
    CHECK(value("!zero && !(a == 3)") == 1.0);
    CHECK(value("1.5e1f + .5") == 15.5);
    CHECK(value("true ? false : true") == 0.0);
    CHECK(value("0 ? 1 : 0 ? 2 : 3") == 3.0);
    CHECK(value("1 - 2 < 0") == 1.0);
    CHECK(value("2 * 3 - 4 / 2 == 4") == 1.0);
    CHECK(value("!zero == 2") == 0.0); // !(zero == 2) is 1
    CHECK(value("-a + 3") == 1.0);
    CHECK(value("--a") == 2.0);
    CHECK(value("a<=2&&a>=2&&!(a<2)&&!(a>2)") == 1.0);
    CHECK(value(" \t( a\n) ") == 2.0);
}

TEST_CASE("formulas compare vectors by all of their components", "[core][formula]")
{
    CHECK(value("white == 1") == 1.0);
    CHECK(value("tint == 1") == 0.0);
    CHECK(value("tint != 1") == 1.0);
    CHECK(value("white != 1") == 0.0);
    CHECK(value("tint == vec3(0.25, 0.5, 1)") == 1.0);
    CHECK(value("tint <= 1") == 1.0);
    CHECK(value("tint < 1") == 0.0);
    CHECK(value("tint.g") == 0.5);
    CHECK(value("(tint * 2).z") == 2.0);
    CHECK(value("a.y") == 0.0);
    CHECK(value("vec2(3).y") == 3.0);
    CHECK(value("vec3(1, 2, 3).y") == 2.0);
    CHECK(value("vec4(1, 2, 3, 4).a") == 4.0);
    CHECK(value("vec3(1, 2, 3).w") == 0.0);
    CHECK(value("tint > vec3(0.2, 0.4, 0.9)") == 1.0);
    CHECK(value("tint > vec3(0.2, 0.4, 1)") == 0.0);
    CHECK(value("tint >= vec3(0.2, 0.5, 1)") == 1.0);
    CHECK(value("tint < vec3(0.3, 0.6, 1)") == 0.0);
    CHECK(value("0 < tint") == 1.0);
    CHECK(value("max(tint, 0.5) == vec3(0.5, 0.5, 1)") == 1.0);
    CHECK(value("-tint == vec3(-0.25, -0.5, -1)") == 1.0);
    CHECK(value("abs(-tint) == tint") == 1.0);
    CHECK(value("(white / tint).x") == 4.0);
    for (const char* component : {"tint.x", "tint.r", "tint"}) // the value is the first component
        CHECK(value(component) == 0.25);
}

TEST_CASE("formulas know min, max and abs, and take an unknown name for 0", "[core][formula]")
{
    CHECK(value("min(a, b)") == -0.5);
    CHECK(value("max(abs(b), 0.25)") == 0.5);
    CHECK(value("nobody + a") == 2.0);
    CHECK(value("nobody == 0") == 1.0);
    CHECK(value("nobody.g") == 0.0);
    CHECK(value("max(a, b)") == 2.0);
    CHECK(value("min(b, a)") == -0.5);
    CHECK(value("abs(a)") == 2.0);
    CHECK(std::isnan(value("zero / zero")));
}

TEST_CASE("what has no value has none in min and max, from either side", "[core][formula]")
{
    for (const char* text : {"max(0, zero / zero)", "max(zero / zero, 0)", "min(0, zero / zero)", "min(zero / zero, 0)"}) {
        CAPTURE(text);
        CHECK(std::isnan(value(text)));
    }
}

TEST_CASE("a formula's mistake is found at its place", "[core][formula]")
{
    for (const auto& [text, message] : {std::pair{"a + @", "ends too early"},
                                        {"a @= 1", "does not continue"},
                                        {"(a + b@", "`)` is missing"},
                                        {"a ? b@", "`:` is missing"},
                                        {"@#", "does not begin"},
                                        {"@pow(a, 2)", "no function"},
                                        {"@max(a)", "no function"},
                                        {"tint@.q", "one component"},
                                        {"tint@.rg", "one component"},
                                        {"@1e999", "no number"}}) {
        const MarkedText source = marked(text);
        const auto formula = Formula::parse(source.text, {"p.glsl", 7, 20});
        INFO(source.text);
        REQUIRE_FALSE(formula);
        CHECK(formula.error().front().code == "formula_syntax");
        CHECK_THAT(formula.error().front().message, Contains(message));
        CHECK(formula.error().front().where.line == 7);
        CHECK(formula.error().front().where.column == 20 + source.places.front().column); // behind the quote
    }
}

TEST_CASE("a formula may be long but not deep", "[core][formula]")
{
    const auto nested = [](const std::string& before, int depth, const std::string& after) {
        std::string text;
        for (int i = 0; i < depth; ++i)
            text += before;
        text += "1";
        for (int i = 0; i < depth; ++i)
            text += after;
        return text;
    };
    CHECK(value(nested("(", 20, ")")) == 1.0);
    CHECK(value(nested("-", 40, "")) == 1.0);
    CHECK(value(nested("1 +", 200, "")) == 201.0);
    for (const std::string& deep : {nested("(", 100, ")"), nested("-", 100, ""), nested("!", 100, ""), nested("abs(", 100, ")"),
                                    nested("a ? 1 : ", 100, ""), nested("a ? ", 100, " : 1"), std::string(5000, '('),
                                    std::string(5000, '-') + "1", nested("1+", 1000000, ""), nested("1||", 1000000, "")}) {
        INFO(deep.substr(0, 20));
        const auto formula = Formula::parse(deep, {"p.glsl", 7, 20});
        REQUIRE_FALSE(formula);
        REQUIRE(formula.error().size() == 1);
        CHECK(formula.error().front().code == "formula_syntax");
        CHECK(formula.error().front().where.column > 20);
        CHECK(formula.error().front().where.column <= 21 + static_cast<int>(deep.size()));
    }
}

TEST_CASE("any text is a formula or a mistake", "[core][formula]")
{
    std::mt19937 random(3);
    const std::string letters = "ab01.()?:|&=!<>+-*/, tintvecminmax";
    for (int round = 0; round < 20000; ++round) {
        std::string text;
        for (auto i = random() % 24; i > 0; --i)
            text += letters[random() % letters.size()];
        if (const auto formula = Formula::parse(text, {})) {
            formula->value([](std::string_view) { return Formula::Number{{1.0, 2.0, 3.0, 4.0}, 4}; });
            CHECK(formula->text() == text);
        }
    }
}

TEST_CASE("a formula names what it uses, with places", "[core][formula]")
{
    const auto formula = Formula::parse("strength == 0 || bloom == 0", {"p.glsl", 3, 10});
    REQUIRE(formula);
    REQUIRE(formula->names().size() == 2);
    CHECK(formula->names()[1].text == "bloom");
    CHECK(formula->names()[1].where.column == 10 + 1 + 17);
    CHECK(formula->uses("strength"));
    CHECK_FALSE(formula->uses("tint"));
}
