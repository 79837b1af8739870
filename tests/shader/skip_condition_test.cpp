// The condition of "skip": checked by the compiler of the body, in the body's scope, and read at uv alone.
#include "passgraph/shader/pass_file.hpp"
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using namespace passgraph::test;
using Catch::Contains;
using passgraph::Error;

namespace {

/// A pass whose condition stands on line 6.
std::string pass_with(const std::string& when, const std::string& body = "vec3 probe(vec2 uv) { return image(uv) * amount; }")
{
    return R"(/*{
  "pass": "probe",
  "inputs": { "image": "radiance" },
  "outputs": { "result": "radiance" },
  "params": { "amount": 0.5 },
  "skip": { "when": ")" + when + R"(", "value": 0 },
  "choices": { "mode": ["soft", "hard"] }
}*/
)" + body + "\n";
}

} // namespace

TEST_CASE("a condition sees what the body sees: inputs at uv, parameters, choices and helpers", "[shader][skip]")
{
    for (const char* when : {"image(uv).r <= amount", "luma(image(uv)) < 1.0 && amount > 0.5", "mode == mode_hard && image(uv) == vec3(0.0)", "false",
                             "uv.x < 0.5", "image_size().x < 3", "true // always"}) {
        CAPTURE(when);
        CHECK(errors_of(pass_with(when, "float luma(vec3 c) { return c.g; }\nvec3 probe(vec2 uv) { return image(uv) * amount; }")).empty());
    }
}

TEST_CASE("a wrong condition is told at its line of the header", "[shader][skip]")
{
    for (const char* when : {"image(uv)", "amount", "image(uv).r <= ", "image(uv).r <= amuont", "true; } void other() {", "image(1.0).r < 0.0"}) {
        CAPTURE(when);
        const auto errors = errors_of(pass_with(when));
        REQUIRE_FALSE(errors.empty());
        CHECK(errors.front().code == "glsl_error");
        CHECK(errors.front().where.file == "probe.glsl");
        CHECK(errors.front().where.line == 6);
        CHECK_FALSE(errors.front().hint.empty());
    }
    const Error unknown = only(errors_of(pass_with("glow(uv).r < 1.0")), "undeclared_input");
    CHECK(unknown.where.line == 6);
}

TEST_CASE("a condition reads no other place than uv, behind calls and branches neither", "[shader][skip]")
{
    const std::string helpers = "vec3 near(vec2 p) { return image(p + image_texel()); }\nvec3 probe(vec2 uv) { return image(uv) * amount; }";
    for (const char* when : {"image(uv + image_texel()).r < 0.5", "near(uv).r < 0.5", "image(vec2(0.5)).r < 0.5", "amount > 0.5 ? true : image(uv * 2.0).r < 1.0"}) {
        CAPTURE(when);
        const Error error = only(errors_of(pass_with(when, helpers)), "skip_reads_elsewhere");
        CHECK(error.where.line == 6);
        CHECK_THAT(error.hint, Contains("image(uv)"));
    }
}

TEST_CASE("what a condition reads counts as read by the pass", "[shader][skip]")
{
    CHECK(access_in(pass_with("image(uv).r < 0.5"), "image") == "pointwise");
    CHECK(access_in(pass_with("image(uv).r < 0.5", "vec3 probe(vec2 uv) { return vec3(amount); }"), "image") == "pointwise"); // read there alone
    CHECK(access_in(pass_with("image(uv).r < 0.5", "vec3 probe(vec2 uv) { return image(uv + vec2(2.0, 0.0) * image_texel()); }"), "image") == "gather(2)");
    CHECK(access_in(pass_with("image(uv).r < 0.5", "vec3 probe(vec2 uv) { return image(vec2(amount)); }"), "image") == "gather(radius unknown)"); // a warp, and its own place
}
