// How parameters, choices and ladders bound what a pass reads: the access class holds for every setting.
#include <chrono>

#include <fmt/format.h>

#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::test::access_of;

namespace {

const char* const kAnywhere = "gather(radius unknown)";
const char* const kSum = "vec3 probe(vec2 uv) { vec3 s = vec3(0.0); for (int i = -reach; i <= reach; ++i) s += image(uv + float(i) * image_texel()); return s; }";

std::string params(const std::string& reach)
{
    return R"("params": { "reach": )" + reach + " }";
}

} // namespace

TEST_CASE("a live parameter is bounded by its range, and by nothing without one", "[shader][access]")
{
    CHECK(access_of(kSum, params(R"({ "type": "int", "default": 2, "range": [0, 9] })")) == "gather(9)");
    CHECK(access_of(kSum, params(R"({ "type": "int", "default": 2 })")) == kAnywhere);
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + reach * image_texel()); }", params(R"({ "type": "float", "default": 0, "range": [-2.5, 1] })")) ==
          "gather(3)");
    CHECK(access_of("vec3 probe(vec2 uv) { float reach = 900.0 * uv.x; return image(uv + reach * image_texel()); }",
                    params(R"({ "type": "float", "default": 0, "range": [0, 1] })")) == "warp");
}

TEST_CASE("a static parameter bounds the radius at its range's ends", "[shader][access]")
{
    CHECK(access_of(kSum, params(R"({ "type": "int", "default": 2, "range": [0, 9], "static": true })")) == "gather(9)");
    const std::string scaled = R"(vec3 probe(vec2 uv) { int taps = int(ceil(3.0 * reach)); vec3 s = vec3(0.0);
        for (int i = -taps; i <= taps; ++i) s += image(uv + float(i) * image_texel()); return s; })";
    CHECK(access_of(scaled, params(R"({ "type": "float", "default": 2, "range": [0, 20], "static": true })")) == "gather(60)");
    // An array's size must be constant: then the ends of the range stand for all of it.
    const std::string sized = R"(const int taps = int(reach);
        vec3 probe(vec2 uv) { float w[taps + 1]; w[0] = 1.0; return w[0] * image(uv + float(taps) * image_texel()); })";
    CHECK(access_of(sized, params(R"({ "type": "float", "default": 2, "range": [0, 20], "static": true })")) == "gather(20)");
}

TEST_CASE("a static value inside its range may read further than the ends do", "[shader][access]")
{
    const std::string number = params(R"({ "type": "float", "default": 2, "range": [0, 20], "static": true })");
    CHECK(access_of("vec3 probe(vec2 uv) { return reach == 7.0 ? image(uv * 2.0) : image(uv); }", number) == kAnywhere);
    CHECK(access_of("vec3 probe(vec2 uv) { if (reach == 7.0) uv *= 2.0; return image(uv); }", number) == "warp");
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + reach * (20.0 - reach) * image_texel()); }", number) == "gather(400)");
    const std::string whole = params(R"({ "type": "int", "default": 2, "range": [0, 9], "static": true })");
    CHECK(access_of("const int taps = reach * (9 - reach);\nvec3 probe(vec2 uv) { return image(uv + float(taps) * image_texel()); }", whole) == "gather(20)");
    const std::string flag = R"("params": { "is_moved": { "type": "bool", "default": false, "static": true } })";
    CHECK(access_of("vec3 probe(vec2 uv) { return image(is_moved ? uv * 2.0 : uv); }", flag) == "warp");
    const std::string items = R"("params": { "way": { "type": "enum", "items": ["here", "there"], "default": "here", "static": true } })";
    CHECK(access_of("vec3 probe(vec2 uv) { if (way == way_there) return image(uv + image_texel()); return image(uv); }", items) == "gather(1)");
}

TEST_CASE("the access class holds under every choice and rung", "[shader][access]")
{
    const std::string choice = R"("choices": { "way": { "items": ["here", "near", "far"], "default": "here" } })";
    const auto body = [](const char* at) { return fmt::format("vec3 probe(vec2 uv) {{\n#if way == way_far\nreturn image({});\n#else\nreturn image(uv);\n#endif\n}}", at); };
    CHECK(access_of(body("uv"), choice) == "pointwise");
    CHECK(access_of(body("uv + 4.0 * image_texel()"), choice) == "gather(4)");
    CHECK(access_of(body("uv * 2.0"), choice) == kAnywhere);

    // 3^6 combinations are too many to look at: the one that moves is not seen, so nothing is promised.
    std::string many = R"("choices": {)";
    std::string both = "vec3 probe(vec2 uv) {\n#if ";
    for (int i = 0; i < 6; ++i) {
        many += fmt::format("{}\"way{}\": {{ \"items\": [\"here\", \"near\", \"far\"] }}", i ? ", " : "", i);
        both += fmt::format("{}way{} == way{}_far", i ? " && " : "", i, i);
    }
    CHECK(access_of(both + "\nreturn image(uv * 2.0);\n#endif\nreturn image(uv); }", many + "}") == kAnywhere);
}

TEST_CASE("a body too large to follow is given up quickly and reads anywhere", "[shader][access]")
{
    std::string body = "vec3 f0(vec2 p) { return image(p); }\n";
    for (int i = 1; i < 40; ++i)
        body += fmt::format("vec3 f{}(vec2 p) {{ return f{}(p) + f{}(p); }}\n", i, i - 1, i - 1);
    const auto start = std::chrono::steady_clock::now();
    CHECK(access_of(body + "vec3 probe(vec2 uv) { return f39(uv); }") == kAnywhere);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(30));

    std::string chain = "vec3 f0(vec2 p) { return image(p); }\n"; // one call each, but too deep for a stack
    for (int i = 1; i < 3000; ++i)
        chain += fmt::format("vec3 f{}(vec2 p) {{ return f{}(p); }}\n", i, i - 1);
    CHECK(access_of(chain + "vec3 probe(vec2 uv) { return f2999(uv); }") == kAnywhere);
}
