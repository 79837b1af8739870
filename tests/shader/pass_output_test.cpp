// Outputs must be assigned, and values returned, on every path.
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::Errors;
using passgraph::test::errors_of;
using passgraph::test::only;
using passgraph::test::probe;

namespace {

const std::string kHeader = R"(/*{ "pass": "probe", "inputs": { "image": "color" }, "outputs": { "first": "color", "second": "color" } }*/)";

/// `body` assigns `first`; helpers stand above.
Errors errors_with(const std::string& body, const std::string& helpers = "")
{
    return errors_of(kHeader + "\n" + helpers + "\nvoid probe(vec2 uv, out vec3 first, out vec3 second)\n{ second = image(uv); " + body + " }\n");
}

} // namespace

TEST_CASE("an output that some path leaves unassigned is named", "[shader][output]")
{
    const char* const body = GENERATE("", "if (uv.x > 0.5) first = second;", "if (uv.x > 0.5) return; first = second;",
                                      "for (int i = 0; i < 3; ++i) first = second;", "while (first.x < 1.0) { first = second; }", "first.xy = uv;", "first.r = 1.0; first.b = 1.0;",
                                      "switch (int(uv.x)) { case 0: first = second; break; case 1: first = uv.xyx; break; }",
                                      "switch (int(uv.x)) { case 0: break; default: first = second; }", "bool b = uv.x > 0.5 && ((first = second), true);",
                                      "uv.x > 0.5 ? (first = second) : second;", "{ vec3 first = second; first += 1.0; }",
                                      "if (uv.x > 0.5) { if (uv.y > 0.5) first = second; } else first = second;", "for (int i = 0; i < 3; ++i) first[i] = 1.0;");
    CAPTURE(body);
    const auto error = only(errors_with(body), "output_unwritten");
    CHECK(error.where.file == "probe.glsl");
    CHECK(error.where.line == 3);
    CHECK(error.message.find("`first`") != std::string::npos);
    CHECK(error.hint.find("assign first") != std::string::npos);
}

TEST_CASE("an output that every path assigns is fine", "[shader][output]")
{
    const char* const body = GENERATE("first = second;", "if (uv.x > 0.5) first = second; else first = uv.xyx;", "first = second; if (uv.x > 0.5) return; first = uv.xyx;",
                                      "if (uv.x > 0.5) { first = second; return; } first = uv.xyx;", "first.xy = uv; first.z = 1.0;", "first.bgr = second;",
                                      "first.r = 1.0; first[1] = 1.0; first.p = 1.0;", "switch (int(uv.x)) { case 0: first = second; break; default: first = uv.xyx; }",
                                      "switch (int(uv.x)) { case 0: case 1: first = second; break; default: first = uv.xyx; break; }",
                                      "switch (int(uv.x)) { case 0: first.x = 1.0; default: first = uv.xyx; }", "first = (second = image(uv));",
                                      "uv.x > 0.5 ? (first = second) : (first = uv.xyx);", "first = vec3(0.0); for (int i = 0; i < 3; ++i) first += second;");
    CAPTURE(body);
    const Errors errors = errors_with(body);
    INFO(to_text(errors));
    CHECK(errors.empty());
}

TEST_CASE("a helper writes an output through its out parameter, if it always does", "[shader][output]")
{
    CHECK(errors_with("fill(first);", "void fill(out vec3 c) { c = vec3(1.0); }").empty());
    CHECK(errors_with("fill(first.xy); first.z = 1.0;", "void fill(out vec2 c) { c = vec2(1.0); }").empty());
    CHECK(errors_with("outer(first);", "void fill(out vec3 c) { c = vec3(1.0); }\nvoid outer(out vec3 c) { fill(c); }").empty());
    only(errors_with("fill(first);", "void fill(out vec3 c) { if (c.x > 0.5) c = vec3(1.0); }"), "output_unwritten");
    only(errors_with("fill(first);", "void fill(inout vec3 c) { c.x = 1.0; }"), "output_unwritten");
    only(errors_with("if (uv.x > 0.5) fill(first);", "void fill(out vec3 c) { c = vec3(1.0); }"), "output_unwritten");
    // Written in one call, not in the next: what one call did says nothing of another.
    only(errors_with("fill(second, true); fill(first, false);", "void fill(out vec3 c, bool is_due) { if (is_due) c = vec3(1.0); }"), "output_unwritten");
}

TEST_CASE("a path without a return value is refused", "[shader][output]")
{
    const char* const missing = GENERATE("vec3 probe(vec2 uv) { if (uv.x > 0.5) return image(uv); }", "vec3 probe(vec2 uv) { while (true) { if (uv.x > 0.5) return image(uv); break; } }",
                                         "vec3 probe(vec2 uv) { for (int i = 0; i < 3; ++i) return image(uv); }",
                                         "vec3 probe(vec2 uv) { switch (int(uv.x)) { case 0: return image(uv); default: break; } }");
    CAPTURE(missing);
    const auto error = only(errors_of(probe(missing)), "output_unwritten");
    CHECK(error.where.line == 2);
    CHECK(error.message.find("does not return a value") != std::string::npos);

    CHECK(errors_of(probe("vec3 probe(vec2 uv) { if (uv.x > 0.5) return image(uv); else return vec3(0.0); }")).empty());
    CHECK(errors_of(probe("vec3 probe(vec2 uv) { switch (int(uv.x)) { case 0: return image(uv); default: return vec3(0.0); } }")).empty());
}

TEST_CASE("an output of a body too large to follow is not blamed", "[shader][output]")
{
    std::string helpers = "vec3 f0(vec2 p) { return image(p); }\n";
    for (int i = 1; i < 30; ++i)
        helpers += "vec3 f" + std::to_string(i) + "(vec2 p) { return f" + std::to_string(i - 1) + "(p) + f" + std::to_string(i - 1) + "(p); }\n";
    CHECK(errors_with("first = f29(uv);", helpers).empty());
}
