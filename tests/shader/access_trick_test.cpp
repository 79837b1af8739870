// Bodies that look as if they read at uv, and do not: none may be called pointwise.
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::test::access_of;

namespace {

/// Anything but a promise, and no refusal either: the trick itself is fine GLSL.
bool promises_nothing(const std::string& access)
{
    return access == "warp" || access == "gather(radius unknown)";
}

} // namespace

TEST_CASE("no variable that something else may change is trusted", "[shader][access]")
{
    const char* const body = GENERATE(
        // A function changes a global: before the read, and before the loop's next turn.
        "vec2 held;\nvoid move() { held *= 2.0; }\nvec3 probe(vec2 uv) { held = uv; move(); return image(held); }",
        "vec2 held;\nvoid move() { held *= 2.0; }\nvec3 probe(vec2 uv) { held = uv; vec3 s = vec3(0.0); for (int i = 0; i < 3; ++i) { s += image(held); move(); } return s; }",
        "vec2 held;\nvoid move() { held *= 2.0; }\nvec3 probe(vec2 uv) { held = uv; for (int i = 0; i < 3; ++i) move(); return image(held); }",
        // An inout or out parameter is written on one path only.
        "void move(inout vec2 p) { if (p.x > 0.5) p = vec2(0.0); }\nvec3 probe(vec2 uv) { move(uv); return image(uv); }",
        "void move(inout vec2 p) { p.x = 0.0; }\nvec3 probe(vec2 uv) { move(uv); return image(uv); }",
        "void move(inout vec2 p) { for (int i = 0; i < 3; ++i) p *= 2.0; }\nvec3 probe(vec2 uv) { move(uv); return image(uv); }",
        "void move(inout vec2 p) { if (p.x > 0.5) return; p = vec2(0.0); }\nvec3 probe(vec2 uv) { move(uv); return image(uv); }",
        "void move(inout vec2 p[2]) { p[0] = vec2(0.0); }\nvec3 probe(vec2 uv) { vec2 p[2] = vec2[2](uv, uv); move(p); return image(p[0]); }",
        // Two results into one variable: GLSL does not say which comes last.
        "void both(vec2 p, out vec2 a, out vec2 b) { a = vec2(0.0); b = p; }\nvec3 probe(vec2 uv) { vec2 q; both(uv, q, q); return image(q); }",
        // Members and elements.
        "struct S { vec2 p; };\nvec3 probe(vec2 uv) { S s = S(uv); s.p = vec2(0.0); return image(s.p); }",
        "vec3 probe(vec2 uv) { vec2 p[2]; p[0] = vec2(0.0); p[1] = uv; return image(p[0]); }",
        "vec3 probe(vec2 uv) { vec2 p = uv; p[int(uv.x)] = 0.0; return image(p); }",
        "vec3 probe(vec2 uv) { vec2 p = uv; p.yx = p; return image(p); }");
    CAPTURE(body);
    CHECK(promises_nothing(access_of(body)));
}

TEST_CASE("no path is taken for granted", "[shader][access]")
{
    const char* const body = GENERATE(
        // What && and || skip has not happened.
        "vec3 probe(vec2 uv) { vec2 p = vec2(0.0); bool b = uv.x > 0.5 && ((p = uv), true); return image(p); }",
        "vec3 probe(vec2 uv) { vec2 p = vec2(0.0); bool b = uv.x > 0.5 || ((p = uv), true); return image(p); }",
        "vec3 probe(vec2 uv) { vec2 p = vec2(0.0); float f = uv.x > 0.5 ? ((p = uv), 1.0) : 0.0; return f * image(p); }",
        // do runs its body before its test.
        "vec3 probe(vec2 uv) { vec2 p = vec2(0.0); vec3 s; do { s = image(p); } while ((p = uv, false)); return s; }",
        // The step of a loop runs after `continue`, too.
        "vec3 probe(vec2 uv) { vec3 s = image(uv); for (int i = 0; i < 3; ++i, s += image(uv * 2.0)) { continue; } return s; }",
        // Fallen through from the case above; no case at all.
        "vec3 probe(vec2 uv) { vec2 p = uv; switch (int(uv.x * 3.0)) { case 0: p = vec2(0.0); case 1: return image(p); } return vec3(0.0); }",
        "vec3 probe(vec2 uv) { vec2 p = vec2(0.0); switch (int(uv.x * 3.0)) { case 0: p = uv; break; } return image(p); }",
        "vec3 probe(vec2 uv) { vec2 p = vec2(0.0); for (int i = 0; i < int(uv.x); ++i) p = uv; return image(p); }",
        "vec3 probe(vec2 uv) { vec2 p = uv; for (int i = 0; i < 3; ++i) { if (i == 1) { p = vec2(0.0); break; } p = uv; } return image(p); }",
        "vec2 pick(vec2 p) { if (p.x > 0.5) return p.yx; return p; }\nvec3 probe(vec2 uv) { return image(pick(uv)); }");
    CAPTURE(body);
    CHECK(promises_nothing(access_of(body)));
}

TEST_CASE("no order is taken for granted where GLSL leaves it open", "[shader][access]")
{
    const char* const body = GENERATE(
        "vec3 probe(vec2 uv) { float a[2]; a[(uv = vec2(0.0), 0)] = image(uv).x; return vec3(a[0]); }",
        "vec3 move(out vec2 p) { p = vec2(0.0); return vec3(1.0); }\nvec3 probe(vec2 uv) { vec2 p = uv; return image(p) * move(p); }",
        "vec3 move(out vec2 p) { p = vec2(0.0); return vec3(1.0); }\nvec3 probe(vec2 uv) { vec2 p = uv; return move(p) + image(p); }",
        "vec3 probe(vec2 uv) { vec2 p = uv; return mix(image(p), image(uv), (p = vec2(0.0), 0.5)); }",
        "vec3 probe(vec2 uv) { vec2 p = uv; return vec3(image(p).x, (p = vec2(0.0)).x, 0.0); }",
        "vec3 keep(vec3 a, vec2 b) { return a; }\nvec3 probe(vec2 uv) { vec2 p = vec2(0.0); return keep(image(p), (p = uv)); }");
    CAPTURE(body);
    CHECK(promises_nothing(access_of(body)));
}

TEST_CASE("reads in odd corners are seen", "[shader][access]")
{
    const char* const body = GENERATE(
        "vec3 probe(vec2 uv) { float a[2]; a[int(image(uv * 2.0).x)] = 1.0; return image(uv) * a[0]; }",
        "void set(out float x) { x = 1.0; }\nvec3 probe(vec2 uv) { float a[2]; set(a[int(image(uv * 2.0).x)]); return image(uv) * a[0]; }",
        "vec3 probe(vec2 uv) { vec3 s = image(uv); for (int i = 0; i < int(image(uv * 2.0).x); ++i) s += 1.0; return s; }",
        "vec3 probe(vec2 uv) { return uv.x > 0.5 || image(uv * 2.0).x > 0.5 ? image(uv) : vec3(0.0); }",
        "vec3 probe(vec2 uv) { vec3 s = image(uv); switch (int(image(uv * 2.0).x)) { case 0: s = vec3(0.0); break; default: break; } return s; }",
        "#define AT(p) image((p) * 2.0)\nvec3 probe(vec2 uv) { return image(uv) + AT(uv); }",
        "float corner(vec2 p) { return image(p).x; }\nvec3 probe(vec2 uv) { float f = corner(vec2(0.0)); return f * image(uv); }");
    CAPTURE(body);
    CHECK(access_of(body) == "gather(radius unknown)");
}

TEST_CASE("text that differs from program to program promises nothing", "[shader][access]")
{
    // In a program every name is a macro (#define image p3_image); alone it is none.
    const char* const condition = GENERATE("ifdef image", "ifndef image", "if defined(probe)", "if defined probe", "if __FILE__ == 1", "if GL_ARB_gpu_shader5");
    CAPTURE(condition);
    CHECK(access_of(std::string("vec3 probe(vec2 uv) {\n#") + condition + "\n#endif\nreturn image(uv); }") == "gather(radius unknown)");
    CHECK(access_of("#define MOVED 1\nvec3 probe(vec2 uv) {\n#ifdef MOVED\nreturn image(uv + image_texel());\n#endif\nreturn image(uv); }") == "gather(1)");
}

TEST_CASE("numbers are followed as 32 bits hold them", "[shader][access]")
{
    const std::string members = R"("params": { "n": { "type": "int", "default": 0, "range": [-1, 7] }, "wide": { "type": "float", "default": 0, "range": [0, 40] } })";
    struct Row {
        const char* offset;
        const char* access;
    };
    const auto row = GENERATE(values<Row>({
        {"float(n / 2 * 2 - n)", "gather(7)"}, // 7 / 2 is 3
        {"float(uint(n))", "warp"},            // -1 is 4294967295
        {"float(0u - uint(n * n))", "warp"},
        {"(float(n + 2147483647) - 2147483647.0)", "warp"},
        {"float(n * 65536 * 65536)", "warp"},
        {"(wide * 3e38 * 3e38)", "warp"},
        {"(1.0 / wide)", "warp"},
        {"(1.0 / (wide - 1.0))", "warp"},
        {"((wide + 1e9) - 1e9)", "gather(64)"}, // near 1e9 binary32 counts in steps of 64: 40 comes back as 64
    }));
    CAPTURE(row.offset);
    CHECK(access_of(std::string("vec3 probe(vec2 uv) { return image(uv + ") + row.offset + " * image_texel()); }", members) == row.access);
}

TEST_CASE("whole numbers are cut, wrap and grow too large", "[shader][access]")
{
    CHECK(access_of("vec3 probe(vec2 uv) { int seven = 7; return image(uv + float(seven / 2 * 2 - 7) * image_texel()); }") == "gather(1)");
    CHECK(access_of("vec3 probe(vec2 uv) { vec3 s = vec3(0.0); for (uint i = 3u; i >= 0u; --i) { s += image(uv + float(i) * image_texel()); if (i > 9u) break; } return s; }") ==
          "gather(radius unknown)");
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + 1e12 * image_texel()); }") == "gather(radius unknown)");
}

TEST_CASE("a value of another width does not shift its neighbours into uv's place", "[shader][access]")
{
    const std::string header = R"(/*{ "pass": "probe", "inputs": { "image": "color", "deep": "depth" }, "outputs": { "result": "color" } }*/)";
    const auto pass = passgraph::test::access_of(
        "vec3 probe(vec2 uv) { vec4 q = vec4(other_size().x, uv.x, 0.0, 0.0); vec4 r = vec4(other_size().x, uv.y, 0.0, 0.0); return image(vec2(q.w, r.w)); }");
    CHECK(pass == "warp");
    CHECK(passgraph::test::access_in(header + "\nvec3 probe(vec2 uv) { float d = deep(uv); vec4 q = vec4(d, uv.x, 0.0, 0.0); vec4 r = vec4(d, uv.y, 0.0, 0.0);"
                                              " return image(vec2(q.w, r.w)); }\n", "image") == "warp");
    CHECK(passgraph::test::access_in(header + "\nvec3 probe(vec2 uv) { return image(vec2(uv.x, vec4(deep(uv), 0.0, uv).w)); }\n", "image") == "pointwise");
}
