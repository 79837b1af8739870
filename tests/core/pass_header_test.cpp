// Every mistake a pass file can hold: its code and its place, all mistakes of a file in one go.
#include <map>

#include <passgraph/core/pass_header.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

const std::map<std::string, std::string, std::less<>> kCommon = {
    {"luma.glsl", "float luma(vec3 c) { return c.g; }\n"},
    {"a.glsl", "#include \"b.glsl\"\nfloat a_(float x) { return x; }\n"},
    {"b.glsl", "\n  #include \"a.glsl\"\n"},
    {"bad.glsl", "float bad(float x)\n{ return dFdx(x); }\n"},
};

std::optional<IncludedFile> find_common(std::string_view name)
{
    const auto found = kCommon.find(name);
    return found == kCommon.end() ? std::nullopt : std::optional(IncludedFile{"common/" + found->first, found->second});
}

Result<PassDeclaration> read(const std::string& text) { return read_pass_header(text, "p.glsl", "screen", find_common); }

/// A header around one member of it, so that only what a row is about is wrong.
std::string with(const std::string& members)
{
    return "/*{ \"pass\": \"own\", \"outputs\": { \"color\": \"color\" }, \"inputs\": { \"image\": \"color\" },\n  " + members +
           "\n}*/\nvec3 own(vec2 uv) { return image(uv); }\n";
}

std::string geometry_with(const std::string& members)
{
    return "/*{ \"pass\": \"own\", \"kind\": \"geometry\", \"outputs\": { \"normal\": \"normal\", \"depth\": \"depth\" },\n  " + members + "\n}*/\n";
}

std::string with_body(const std::string& body)
{
    return "/*{ \"pass\": \"own\", \"outputs\": { \"color\": \"color\" }, \"inputs\": { \"image\": \"color\" }\n}*/\n" + body;
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
        if (!pass) {
            CHECK_THAT(pass.error().front().hint, Contains(row.hint));
            CHECK(pass.error().front().where.file == "p.glsl");
            CHECK(pass.error().front().fault == Fault::user);
        }
    }
}

} // namespace

TEST_CASE("a pass file starts with a header that is JSON", "[core][pass]")
{
    check({
        {"@", {"header_missing"}, "start it with"},
        {"@vec3 own(vec2 uv) { return vec3(0.0); }", {"header_missing"}, "start it with"},
        {"@#version 330\n/*{}*/", {"header_missing"}, "start it with"},
        {"@/*{ \"pass\": \"own\"", {"header_missing"}, "start it with"},
        {"@/*/", {"header_missing"}, "start it with"},
        {"/*{ \"pass\": \"own\",\n  @}*/", {"json_syntax"}, ""},
        {"/*{ \"pass\": \"own\",\n  @\"pass\": \"q\" }*/", {"json_duplicate_key"}, "line 1"},
        {" \n/*{ \"a\": " + std::string(99, '[') + "@[" + std::string(100, ']') + "}*/", {"json_depth"}, ""},
    });
    CHECK(codes_of(read("/*" + std::string("[1]") + "*/")) == "wrong_type 1:3\n");
}

TEST_CASE("a header's fields are known, present and of their type", "[core][pass]")
{
    check({
        {with("@\"sumary\": \"x\""), {"unknown_field"}, "did you mean `summary`?"},
        {with("\"summary\": @5"), {"wrong_type"}, ""},
        {"/*@{ \"outputs\": { \"color\": \"color\" } }*/", {"field_missing"}, ""},
        {"/*@{ \"pass\": \"own\" }*/", {"field_missing"}, ""},
        {"/*{ \"pass\": \"own\", \"outputs\": @{} }*/", {"field_missing"}, ""},
        {"/*{ \"pass\": \"own\", \"outputs\": @[] }*/", {"wrong_type"}, ""},
        {with("\"kind\": @\"geometri\""), {"unknown_item"}, "did you mean `geometry`?"},
        {with("\"reads\": [\"camera\", @\"lamps\"]"), {"unknown_item"}, "camera, lights, frame, elements"},
        {with("\"params\": { \"k\": @\"x\" }"), {"wrong_type"}, ""},
        {with("\"params\": { \"strength\": { \"type\": \"float\", @\"defualt\": 1, \"default\": 1 } }"), {"unknown_field"}, "did you mean `default`?"},
        {with("\"params\": { \"strength\": @{ \"type\": \"float\" } }"), {"field_missing"}, ""},
        {with("\"params\": { \"strength\": @{ \"default\": 1 } }"), {"field_missing"}, ""},
        {with("\"params\": { \"strength\": { \"type\": @\"flaot\", \"default\": 1 } }"), {"unknown_item"}, "did you mean `float`?"},
        {with("\"params\": { \"count\": { \"type\": \"int\", \"default\": @1.5 } }"), {"wrong_type"}, ""},
        {with("\"params\": { \"count\": { \"type\": \"int\", \"default\": @3000000000 } }"), {"wrong_type"}, ""},
        {with("\"params\": { \"tint\": { \"type\": \"color\", \"default\": @[1, 1] } }"), {"wrong_type"}, ""},
        {with("\"params\": { \"on\": { \"type\": \"bool\", \"default\": @1 } }"), {"wrong_type"}, ""},
        {with("\"params\": { \"mode\": @{ \"type\": \"enum\", \"items\": [], \"default\": @\"x\" } }"), {"field_missing", "unknown_item"}, "names its items"},
        {with("\"params\": { \"k\": { \"type\": \"float\", \"default\": 1, \"range\": @[0] } }"), {"wrong_type"}, ""},
        {with("\"params\": { \"k\": { \"type\": \"float\", \"default\": 1, \"scale\": @\"lag\" } }"), {"unknown_item"}, "did you mean `log`?"},
    });
}

TEST_CASE("ports name a signal, known ways of reading and a size", "[core][pass]")
{
    const auto input = [](const std::string& port) { return "/*{ \"pass\": \"own\", \"outputs\": { \"color\": \"color\" }, \"inputs\": { \"image\": " + port + " } }*/"; };
    const auto output = [](const std::string& port) { return "/*{ \"pass\": \"own\", \"inputs\": { \"image\": \"color\" }, \"outputs\": { \"color\": " + port + " } }*/"; };
    check({
        {input("@\"colour\""), {"unknown_signal"}, "did you mean `color`?"},
        {input("{ \"signal\": @\"radience\" }"), {"unknown_signal"}, "did you mean `radiance`?"},
        {input("@{ \"filter\": \"linear\" }"), {"field_missing"}, ""},
        {input("@7"), {"wrong_type", }, ""},
        {input("{ \"signal\": \"color\", \"filter\": @\"liner\" }"), {"unknown_item"}, "did you mean `linear`?"},
        {input("{ \"signal\": \"color\", \"wrap\": @\"clmp\" }"), {"unknown_item"}, "did you mean `clamp`?"},
        {input("{ \"signal\": \"color\", \"over\": @\"spere\" }"), {"unknown_item"}, "did you mean `sphere`?"},
        {input("{ \"signal\": \"color\", @\"lod\": true }"), {"unknown_field"}, "the fields are"},
        {input("{ \"signal\": \"color\", \"once\": @1 }"), {"wrong_type"}, ""},
        {input("{ \"signal\": \"color\", \"default\": @0 }"), {"default_unused"}, "\"optional\": true"},
        {input("{ \"signal\": \"color\", \"optional\": true, \"default\": @[0, 0] }"), {"wrong_type"}, ""},
        {output("@\"colour\""), {"unknown_signal"}, "did you mean `color`?"},
        {output("{ \"signal\": \"color\", \"size\": { \"of\": @\"imaeg\" } }"), {"unknown_input"}, "did you mean `image`?"},
        {output("{ \"signal\": \"color\", \"size\": { \"scale\": @[1, 0] } }"), {"wrong_type"}, "[1, 2] is half"},
        {output("{ \"signal\": \"color\", \"size\": { \"texels\": @[1.5, 1] } }"), {"wrong_type"}, ""},
        {output("\"color\", @\"other\": { \"signal\": \"color\", \"size\": { \"texels\": [1, 1] } }"), {"sizes_differ"}, "one pass draws one extent"},
    });
}

TEST_CASE("names that GLSL or generated code keeps are refused", "[core][pass]")
{
    for (const char* name : {"filter", "texture", "vec3", "mix", "textureLod", "xyz", "rgb", "st", "r", "my__name", "gl_x", "passgraph_x", "uv", "pixel", "pixel_count", "random", "3d", "a-b"}) {
        check({{with(std::string("\"params\": { @\"") + name + "\": 1 }"), {"reserved_name"}, "another name"}});
        CHECK(!why_reserved(name).empty());
    }
    for (const char* name : {"image", "strength", "x1", "xr", "_a", "xyzwx"})
        CHECK(why_reserved(name).empty());
    CHECK(!why_reserved("").empty());
    check({
        {"/*{ \"pass\": @\"filter\", \"outputs\": { \"color\": \"color\" } }*/", {"reserved_name"}, "another name"},
        {"/*{ \"pass\": \"own\", \"outputs\": { @\"rgb\": \"color\" } }*/", {"reserved_name"}, "another name"},
        {"/*{ \"pass\": \"own\", \"inputs\": { @\"sample\": \"color\" }, \"outputs\": { \"color\": \"color\" } }*/", {"reserved_name"}, "another name"},
        {with("\"choices\": { @\"flat\": [\"a\"] }"), {"reserved_name"}, "another name"},
        {with("\"ladders\": { @\"smooth\": [\"a\"] }"), {"reserved_name"}, "another name"},
        {with_body("float @mix(float a) { return a; }"), {"reserved_name"}, "another name"},
    });
}

TEST_CASE("ports, parameters, choices and what is made for them share one namespace", "[core][pass]")
{
    check({
        {with("\"params\": { @\"image\": 1 }"), {"duplicate_name"}, "line 1"},
        {with("\"params\": { @\"own\": 1 }"), {"duplicate_name"}, "one namespace"},
        {with("\"params\": { @\"image_texel\": 1 }"), {"duplicate_name"}, "one namespace"},
        {with("\"params\": { @\"image_size\": 1 }"), {"duplicate_name"}, "one namespace"},
        {with("\"params\": { @\"image_alpha\": 1 }"), {"duplicate_name"}, "one namespace"},
        {with("\"params\": { \"k\": 1 }, \"choices\": { @\"k\": [\"a\"] }"), {"duplicate_name"}, "one namespace"},
        {with("\"choices\": { \"k\": [\"a\", @\"a\"] }"), {"duplicate_name"}, "remove one"},
        {"/*{ \"pass\": \"own\", \"inputs\": { \"image\": \"color\" }, \"outputs\": { @\"image\": \"color\" } }*/", {"duplicate_name"}, "one namespace"},
        {geometry_with("\"inputs\": { @\"scene\": \"color\" }"), {"duplicate_name"}, "one namespace"},
    });
}

TEST_CASE("defaults lie in their range, and items exist", "[core][pass]")
{
    check({
        {with("\"params\": { \"k\": { \"type\": \"float\", \"default\": @2, \"range\": [0, 1] } }"), {"param_out_of_range"}, ""},
        {with("\"params\": { \"k\": { \"type\": \"color\", \"default\": @[0, 0, 2] } }"), {"param_out_of_range"}, ""},
        {with("\"params\": { \"k\": { \"type\": \"float\", \"default\": 1, \"range\": @[2, 0] } }"), {"range_empty"}, "swap"},
        {with("\"choices\": { \"k\": { \"items\": [\"one\", \"two\"], \"default\": @\"tow\" } }"), {"unknown_item"}, "did you mean `two`?"},
        {with("\"choices\": { @\"k\": [] }"), {"field_missing"}, ""},
        {with("\"choices\": { \"k\": @5 }"), {"wrong_type"}, ""},
        {with("\"choices\": { \"k\": [@\"a b\"] }"), {"wrong_type"}, "letters, digits"},
    });
}

TEST_CASE("an identity names an input of the output's signal", "[core][pass]")
{
    check({
        {with("\"identity\": { \"when\": \"true\", \"is\": @\"imag\" }"), {"unknown_input"}, "did you mean `image`?"},
        {with("\"identity\": @{ \"is\": \"image\" }"), {"field_missing"}, ""},
        {"/*{ \"pass\": \"own\", \"inputs\": { \"image\": \"radiance\" }, \"outputs\": { \"color\": \"display\" },\n \"identity\": { \"when\": \"true\", \"is\": @\"image\" } }*/",
         {"identity_mismatch"}, ""},
    });
}

TEST_CASE("layouts store an output that exists with a codec of its signal", "[core][pass]")
{
    check({
        {geometry_with("\"layouts\": { \"small\": { \"normal\": @\"octahedral_rg9\" } }"), {"unknown_codec"}, "did you mean `octahedral_rg8`?"},
        {geometry_with("\"layouts\": { \"small\": { @\"normla\": \"rgba16f\" } }"), {"unknown_output"}, "did you mean `normal`?"},
        {geometry_with("\"layouts\": { \"small\": { \"normal\": @5 } }"), {"wrong_type"}, ""},
        {geometry_with("\"layouts\": { \"small\": @5 }"), {"wrong_type"}, ""},
    });
}

TEST_CASE("a body declares nothing that is generated, and is a function of uv alone", "[core][pass]")
{
    check({
        {with_body("vec3 own(vec2 uv) { return @texture(t, uv).rgb; }"), {"forbidden_builtin"}, "image(uv)"},
        {with_body("vec3 own(vec2 uv) { return @texelFetch(t, ivec2(0), 0).rgb; }"), {"forbidden_builtin"}, "image(uv)"},
        {with_body("vec3 own(vec2 uv) { return @textureLod(t, uv, 0.0).rgb; }"), {"forbidden_builtin"}, "image(uv)"},
        {with_body("vec3 own(vec2 uv) { return vec3(@gl_FragCoord.x); }"), {"forbidden_builtin"}, "pixel()"},
        {with_body("@uniform float k;"), {"forbidden_builtin"}, "header"},
        {with_body("vec3 own(vec2 uv) {\n  if (uv.x > 1.0)\n    @discard;\n}"), {"forbidden_builtin"}, "uv alone"},
        {with_body("vec3 own(vec2 uv) { return vec3(@dFdx(uv.x)); }"), {"forbidden_builtin"}, "uv alone"},
        {with_body("@#version 330\n"), {"forbidden_builtin"}, "leave the line out"},
        {with_body("  @#extension GL_x : enable\n"), {"forbidden_builtin"}, "leave the line out"},
        {with_body("@layout(std140) float k;"), {"forbidden_builtin"}, "header"},
    });
    CHECK_THAT(codes_of(read(with_body("void main() {}"))), Contains("forbidden_builtin 3:6\n"));
    CHECK(codes_of(read(with_body("// texture(a), discard\n/* gl_FragCoord */ float f(float x) { return x; }"))) == "no error");
    CHECK(codes_of(read(geometry_with("\"summary\": \"\"") + "void own_surface() { if (dFdx(1.0) > 0.0) discard; }")) == "no error");
}

TEST_CASE("includes exist, stay in the common folder and do not go round", "[core][pass]")
{
    check({
        {with_body("@#include \"luna.glsl\"\n"), {"include_missing"}, "common/"},
        {with_body("@#include \"../../secret.glsl\"\n"), {"include_missing"}, "common/"},
        {with_body("@#include \"/etc/passwd\"\n"), {"include_missing"}, "common/"},
        {with_body("@#include <luma.glsl>\n"), {"include_missing"}, "\"luminance.glsl\""},
        {"/*{ \"pass\": \"own\", \"outputs\": { \"color\": \"color\" } }*/ @#include \"luna.glsl\"\n", {"include_missing"}, "common/"},
    });
    const auto cycle = read(with_body("#include \"a.glsl\"\n"));
    CHECK(codes_of(cycle) == "include_cycle 2:3\n");
    CHECK(cycle.error().front().where.file == "common/b.glsl");
    const auto bad = read(with_body("#include \"bad.glsl\"\n"));
    CHECK(codes_of(bad) == "forbidden_builtin 2:10\n");
    CHECK(bad.error().front().where.file == "common/bad.glsl");
}

TEST_CASE("all mistakes of a pass file come back at once", "[core][pass]")
{
    const MarkedText source = marked(R"(/*{
  "pass": "own",
  "inputs": { "image": @"colour" },
  "outputs": { @"rgb": "color" },
  "params": { "k": { "type": "float", "default": @2, "range": [0, 1] } },
  @"sumary": "x"
}*/
@#include "luna.glsl"
vec3 own(vec2 uv) { return @texture(t, uv).rgb; }
)");
    CHECK(codes_of(read(source.text)) == codes_at(source, {"unknown_signal", "reserved_name", "param_out_of_range", "unknown_field",
                                                           "include_missing", "forbidden_builtin"}));
}
