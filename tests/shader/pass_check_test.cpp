// The mistakes a pass's body may hold: each is found, at its line, with the way to mend it.
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::Error;
using passgraph::Errors;
using passgraph::test::errors_of;
using passgraph::test::Folder;
using passgraph::test::only;

namespace {

const std::string kHeader = R"(/*{
  "pass": "probe",
  "inputs": { "image": "color" },
  "outputs": { "result": "color" },
  "params": { "amount": 0.5 }
}*/
)"; // the body begins on line 7

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("a GLSL mistake is told at its own line of the pass file", "[shader][check]")
{
    const Error error = only(errors_of(kHeader + "vec3 probe(vec2 uv)\n{\n    return image(uv) + vec2(1.0);\n}\n"), "glsl_error");
    CHECK(error.where.file == "probe.glsl");
    CHECK(error.where.line == 9);
}

TEST_CASE("an include above does not move a mistake's line, and its own mistakes are its own", "[shader][check]")
{
    Folder folder;
    folder.write("common/fine.glsl", "// Halves.\n\n\nfloat halved(float x) { return 0.5 * x; }\n");
    const std::string broken = folder.write("common/broken.glsl", "// Breaks.\nfloat broken(float x)\n{\n    return vec2(x);\n}\n");
    const std::string common = folder.path() + "/common";

    const Error own = only(errors_of(kHeader + "#include \"fine.glsl\"\nvec3 probe(vec2 uv) { return halved(uv); }\n", {common}), "glsl_error");
    CHECK(own.where.line == 8);
    CHECK(mentions(own.hint, "other arguments"));

    const Errors theirs = errors_of(kHeader + "#include \"broken.glsl\"\nvec3 probe(vec2 uv) { return image(uv) * broken(1.0); }\n", {common});
    REQUIRE_FALSE(theirs.empty());
    CHECK(theirs.front().where.file == broken);
    CHECK(theirs.front().where.line == 4);
}

TEST_CASE("a common file cannot read the pass's inputs or parameters", "[shader][check]")
{
    Folder folder;
    const std::string file = folder.write("common/reads.glsl", "// Reads.\nvec3 sneaky(vec2 p) { return image(p * 2.0) * amount; }\n");
    const Errors errors = errors_of(kHeader + "#include \"reads.glsl\"\nvec3 probe(vec2 uv) { return sneaky(uv) + image(uv); }\n", {folder.path() + "/common"});
    REQUIRE_FALSE(errors.empty());
    CHECK(errors.front().code == "glsl_error");
    CHECK(errors.front().where.file == file);
    CHECK(errors.front().where.line == 2);
    CHECK(mentions(errors.front().hint, "argument"));
}

TEST_CASE("two common files that include a third are one pass", "[shader][check]")
{
    Folder folder;
    folder.write("common/third.glsl", "// Third.\nfloat third(float x) { return x / 3.0; }\n");
    folder.write("common/first.glsl", "// First.\n#include \"third.glsl\"\nfloat first(float x) { return third(x); }\n");
    folder.write("common/second.glsl", "// Second.\n#include \"third.glsl\"\nfloat second(float x) { return third(x); }\n");
    CHECK(errors_of(kHeader + "#include \"first.glsl\"\n#include \"second.glsl\"\nvec3 probe(vec2 uv) { return image(uv) * first(1.0) * second(1.0); }\n",
                    {folder.path() + "/common"}).empty());
}

TEST_CASE("a call of something unknown tells how to declare it, or which name was meant", "[shader][check]")
{
    const Error unknown = only(errors_of(kHeader + "vec3 probe(vec2 uv)\n{\n    return image(uv) + glow(uv);\n}\n"), "undeclared_input");
    CHECK(unknown.where.line == 9);
    CHECK(mentions(unknown.message, "`glow`"));
    CHECK(mentions(unknown.hint, "\"inputs\": { \"glow\":"));

    const Errors typing = errors_of(kHeader + "vec3 probe(vec2 uv) { return image(uv) + imgae(uv); }\n");
    REQUIRE(typing.size() == 1);
    CHECK(typing.front().code == "undeclared_input");
    CHECK(mentions(typing.front().hint, "did you mean `image`?"));

    const Errors value = errors_of(kHeader + "vec3 probe(vec2 uv) { return image(uv) * strength; }\n");
    REQUIRE_FALSE(value.empty());
    CHECK(value.front().code == "glsl_error");
    CHECK(mentions(value.front().hint, "\"params\""));
}

TEST_CASE("an accessor of the frame without its \"reads\" names the one to add", "[shader][check]")
{
    struct Row {
        const char* call;
        const char* read;
    };
    const auto row = GENERATE(values<Row>({{"view_ray(uv)", "camera"}, {"vec3(frame_time())", "frame"}, {"vec3(light_count())", "lights"}}));
    const Errors errors = errors_of(kHeader + "vec3 probe(vec2 uv) { return image(uv) + " + row.call + "; }\n");
    REQUIRE_FALSE(errors.empty());
    CHECK(errors.front().where.line == 7);
    CHECK(errors.front().hint == std::string("add \"") + row.read + "\" to \"reads\"");
}

TEST_CASE("an input called with other arguments says how inputs are called", "[shader][check]")
{
    const Errors errors = errors_of(kHeader + "vec3 probe(vec2 uv) { return image(uv.x); }\n");
    REQUIRE_FALSE(errors.empty());
    CHECK(errors.front().code == "glsl_error");
    CHECK(mentions(errors.front().hint, "one vec2"));
}

TEST_CASE("a file without its entry function is told which to write", "[shader][check]")
{
    const Error error = only(errors_of(kHeader + "vec3 prove(vec2 uv) { return image(uv); }\n"), "entry_missing");
    CHECK(error.where.file == "probe.glsl");
    CHECK(error.hint == "write: vec3 probe(vec2 uv)");
}

TEST_CASE("an entry of another shape is told the right one", "[shader][check]")
{
    const char* const entry = GENERATE("vec4 probe(vec2 uv) { return vec4(image(uv), 1.0); }", "float probe(vec2 uv) { return image(uv).x; }",
                                       "vec3 probe() { return image(vec2(0.5)); }", "vec3 probe(vec2 uv, float x) { return image(uv); }",
                                       "void probe(vec2 uv, out vec3 result) { result = image(uv); }", "ivec3 probe(vec2 uv) { return ivec3(image(uv)); }",
                                       "vec3 probe(inout vec2 uv) { uv = vec2(0.5); return image(uv); }", "vec3 probe(out vec2 uv) { uv = vec2(0.5); return image(uv); }",
                                       "mat3 probe(vec2 uv) { return mat3(image(uv).x); }");
    CAPTURE(entry);
    const Error error = only(errors_of(kHeader + "\n" + entry + "\n"), "entry_signature");
    CHECK(error.where.line == 8);
    CHECK(error.hint == "write: vec3 probe(vec2 uv)");
}

TEST_CASE("several outputs are out parameters, named as the outputs and in their order", "[shader][check]")
{
    const std::string header = R"(/*{ "pass": "probe", "inputs": { "image": "color" }, "outputs": { "first": "color", "second": "color", "far": "depth" } }*/)";
    const std::string hint = "write: void probe(vec2 uv, out vec3 first, out vec3 second, out float far)";
    const std::string assigned = " { first = image(uv); second = first; far = 1.0; }\n";
    CHECK(errors_of(header + "\nvoid probe(vec2 uv, out vec3 first, out vec3 second, out float far)" + assigned).empty());
    const char* const entry = GENERATE("void probe(vec2 uv, out vec3 second, out vec3 first, out float far)", "void probe(vec2 uv, out vec3 first, vec3 second, out float far)",
                                       "void probe(vec2 uv, vec3 first, vec3 second, float far)", "void probe(vec2 uv, out float far, out vec3 first, out vec3 second)",
                                       "void probe(vec2 uv, out vec3 first, inout vec3 second, out float far)");
    CAPTURE(entry);
    CHECK(only(errors_of(header + "\n" + entry + assigned), "entry_signature").hint == hint);
    CHECK(only(errors_of(header + "\nvec3 probe(vec2 uv, out vec3 first, out vec3 second, out float far) { first = image(uv); second = first; far = 1.0; return first; }\n"),
               "entry_signature").hint == hint);
}

TEST_CASE("an input that is never read is told at its place in the header", "[shader][check]")
{
    const Error error = only(errors_of(kHeader + "vec3 probe(vec2 uv) { return vec3(uv, amount); }\n"), "input_unused");
    CHECK(error.where.line == 3);
    CHECK(mentions(error.hint, "call image(uv), or remove it"));
    // Called only by a function that nobody calls.
    only(errors_of(kHeader + "vec3 unused(vec2 p) { return image(p); }\nvec3 probe(vec2 uv) { return vec3(uv, amount); }\n"), "input_unused");
}

TEST_CASE("asking for an input's extent alone counts as using it", "[shader][check]")
{
    CHECK(errors_of(kHeader + "vec3 probe(vec2 uv) { return vec3(image_size(), 0.0); }\n").empty());
    CHECK(errors_of(kHeader + "vec3 probe(vec2 uv) { return vec3(image_texel(), 0.0); }\n").empty());
    CHECK(errors_of(R"(/*{ "pass": "probe", "inputs": { "image": "color" }, "outputs": { "result": { "signal": "color", "size": { "of": "image" } } } }*/
vec3 probe(vec2 uv) { return vec3(uv, 0.0); }
)").empty());
}

TEST_CASE("a mistake that only one choice, rung or static value has is found", "[shader][check]")
{
    const std::string chosen = R"(/*{ "pass": "probe", "inputs": { "image": "color" }, "outputs": { "result": "color" },
  "choices": { "way": { "items": ["fine", "broken"], "default": "fine" } }, "ladders": { "taps": { "items": ["5", "9"], "default": "5" } },
  "params": { "on": { "type": "bool", "default": false, "static": true } } }*/
vec3 probe(vec2 uv)
{
)";
    CHECK(only(errors_of(chosen + "#if way == way_broken\n    return image(uv) + 1;\n    wrong;\n#endif\n    return image(uv);\n}\n"), "glsl_error").where.line == 8);
    CHECK(only(errors_of(chosen + "#if taps == taps_9\n    wrong;\n#endif\n    return image(uv);\n}\n"), "glsl_error").where.line == 7);
    CHECK(only(errors_of(chosen + "    float table[2];\n    table[on ? 2 : 0] = 1.0;\n    return table[0] * image(uv);\n}\n"), "glsl_error").where.line == 7);
}

TEST_CASE("every mistake of a body is told at once", "[shader][check]")
{
    const Errors errors = errors_of(kHeader + "vec3 probe(vec2 uv)\n{\n    float a = missing;\n    vec3 b = glow(uv);\n    vec3 c = uv;\n    return image(uv) + view_ray(uv);\n}\n");
    INFO(passgraph::to_text(errors));
    std::vector<int> lines;
    for (const Error& error : errors)
        if (lines.empty() || lines.back() != error.where.line)
            lines.push_back(error.where.line);
    CHECK(lines == std::vector<int>{9, 10, 11, 12});
    // Header and choices, each unused input: not the first alone.
    CHECK(errors_of(R"(/*{ "pass": "probe", "inputs": { "a": "color", "b": "color" }, "outputs": { "result": "color" } }*/
vec3 probe(vec2 uv) { return vec3(uv, 0.0); }
)").size() == 2);
}

TEST_CASE("a function that calls itself is refused, not followed for ever", "[shader][check]")
{
    const Errors direct = errors_of(kHeader + "vec3 around(vec2 p)\n{\n    return p.x > 1.0 ? image(p) : around(p + 0.1);\n}\nvec3 probe(vec2 uv) { return around(uv); }\n");
    REQUIRE_FALSE(direct.empty());
    CHECK(mentions(direct.front().message, "`around` calls itself"));
    CHECK(direct.front().where.line == 7);
    const Errors mutual = errors_of(kHeader + "vec3 ping(vec2 p);\nvec3 pong(vec2 p) { return ping(p); }\nvec3 ping(vec2 p) { return pong(p) + image(p); }\n"
                                              "vec3 probe(vec2 uv) { return ping(uv); }\n");
    CHECK_FALSE(mutual.empty());
    CHECK_FALSE(errors_of(kHeader + "vec3 probe(vec2 uv) { return image(uv) + probe(uv); }\n").empty());
}

TEST_CASE("a geometry pass has a vertex and a surface function", "[shader][check]")
{
    const std::string header = R"(/*{ "pass": "probe", "kind": "geometry", "reads": ["elements"], "outputs": { "albedo": "albedo", "depth": "depth" },
  "layouts": { "one": { "albedo": "srgb8_a8", "depth": "depth32f" } } }*/)";
    const std::string vertex = "\nvoid probe_vertex(vec3 position, vec3 normal, vec2 texcoord, out vec3 placed, out vec3 facing, out vec2 uv)\n"
                               "{ placed = position; facing = normal; uv = texcoord; }";
    const std::string surface = "\nvoid probe_surface(vec3 placed, vec3 facing, vec2 uv, out vec3 albedo) { albedo = placed; }\n";
    CHECK(errors_of(header + vertex + surface).empty());
    CHECK(mentions(only(errors_of(header + surface), "entry_missing").hint, "void probe_vertex("));
    CHECK(mentions(only(errors_of(header + vertex), "entry_missing").hint, "void probe_surface(vec3 placed, vec3 facing, vec2 uv, out vec3 albedo)"));
    only(errors_of(header + vertex + "\nvoid probe_surface(vec3 placed, vec3 facing, vec2 uv, vec3 albedo) { }\n"), "entry_signature");
    only(errors_of(header + vertex + "\nvoid probe_surface(vec3 placed, vec3 facing, vec2 uv, out vec3 albedo) { albedo.x = 1.0; }\n"), "output_unwritten");
    only(errors_of(header + "\nvoid probe_vertex(vec3 position, vec3 normal, vec2 texcoord, out vec3 placed, out vec3 facing, out vec2 uv) { placed = position; facing = normal; }" +
                   surface), "output_unwritten");
}

TEST_CASE("what is missing at a pass's end is told at its last line", "[shader][check]")
{
    const Error error = only(errors_of(kHeader + "vec3 probe(vec2 uv)\n{\n    return image(uv) * amount;\n}\n#if 1\n"), "glsl_error");
    CHECK_THAT(error.message, Catch::Contains("#endif"));
    CHECK(error.where.line == 11);
}
