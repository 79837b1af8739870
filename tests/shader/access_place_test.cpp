// How straight-line bodies read their input: what is provably at uv, what is one computed place, what is anything.
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::test::access_of;

namespace {

struct Row {
    const char* body;
    const char* expected;
};

const char* const kAnywhere = "gather(radius unknown)";

} // namespace

TEST_CASE("a read at the entry's own uv is pointwise, however it is written", "[shader][access]")
{
    const auto row = GENERATE(values<Row>({
        {"vec3 probe(vec2 uv) { return image(uv); }", "pointwise"},
        {"vec3 probe(vec2 at) { return image(at); }", "pointwise"},
        {"vec3 probe(const in vec2 uv) { return image(uv); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(uv) + image(uv); }", "pointwise"},
        {"vec3 probe(vec2 uv) { vec2 p = uv; vec2 q; q = p; return image(q); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(uv.xy); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(uv.yx.yx); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(vec2(uv.x, uv.y)); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(vec2(uv.s, uv[1])); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(vec3(uv, 1.0).xy); }", "pointwise"},
        {"vec3 probe(vec2 uv) { vec2 p; p.x = uv.x; p.y = uv.y; return image(p); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(uv + 0.0); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image(uv.x > 0.5 ? uv : uv.xy); }", "pointwise"},
        {"vec3 probe(vec2 uv) { vec2 kept = uv; uv = vec2(0.5); uv = kept; return image(uv); }", "pointwise"},
        {"vec3 probe(vec2 uv) { { vec2 uv = vec2(0.5); uv *= 2.0; } return image(uv); }", "pointwise"},
        {"vec3 probe(vec2 uv) { return image((uv.x, uv)); }", "pointwise"},
        {"vec3 helper(vec2 p) { return image(p); }\nvec3 probe(vec2 uv) { return helper(uv); }", "pointwise"},
        {"vec2 same(vec2 p) { return p; }\nvec3 probe(vec2 uv) { return image(same(uv)); }", "pointwise"},
        {"void same(vec2 p, out vec2 q) { q = p; }\nvec3 probe(vec2 uv) { vec2 q; same(uv, q); return image(q); }", "pointwise"},
        {"void same(inout vec2 p) { }\nvec3 probe(vec2 uv) { same(uv); return image(uv); }", "pointwise"},
        {"float split(vec2 p, out vec2 q) { q = p; return 2.0; }\n"
         "vec3 probe(vec2 uv) { vec2 q; float two = split(uv, q) * 2.0; return two * image(q); }", "pointwise"},
    }));
    CAPTURE(row.body);
    CHECK(access_of(row.body) == row.expected);
}

TEST_CASE("one computed place is a warp, more are anything", "[shader][access]")
{
    const auto row = GENERATE(values<Row>({
        {"vec3 probe(vec2 uv) { return image(uv.yx); }", "warp"},
        {"vec3 probe(vec2 uv) { return image(uv * 2.0); }", "warp"},
        {"vec3 probe(vec2 uv) { return image(1.0 - uv); }", "warp"},
        {"vec3 probe(vec2 uv) { return image(vec2(0.5)); }", "warp"},
        {"vec3 probe(vec2 uv) { return image(floor(uv * 8.0) / 8.0); }", "warp"},
        {"vec3 probe(vec2 uv) { return image(other(uv).xy); }", "warp"},
        {"vec3 probe(vec2 uv) { vec2 uv2 = uv; { vec2 uv = vec2(0.5); uv2 = uv; } return image(uv2); }", "warp"},
        {"vec3 probe(vec2 uv) { return image(uv * 2.0) + image(uv * 3.0); }", kAnywhere},
        {"vec3 probe(vec2 uv) { return image(uv * 2.0) + image(uv); }", kAnywhere},
        {"vec3 probe(vec2 uv) { vec3 s = vec3(0.0); for (int i = 0; i < 2; ++i) s += image(uv * float(i)); return s; }", kAnywhere},
        {"vec3 helper(vec2 p) { return image(p); }\nvec3 probe(vec2 uv) { return helper(uv * 2.0); }", "warp"},
        {"vec3 helper(vec2 p) { return image(p); }\nvec3 probe(vec2 uv) { return helper(uv) + helper(uv * 2.0); }", kAnywhere},
        {"vec3 helper(vec2 p) { return image(p); }\n"
         "vec3 probe(vec2 uv) { vec3 s = vec3(0.0); while (s.x < 1.0) s += helper(s.xy); return s; }", kAnywhere},
    }));
    CAPTURE(row.body);
    CHECK(access_of(row.body) == row.expected);
}

TEST_CASE("uv that may have been changed is not uv", "[shader][access]")
{
    const char* const body = GENERATE(
        "vec3 probe(vec2 uv) { uv += 0.25; return image(uv); }", "vec3 probe(vec2 uv) { uv.x = 0.5; return image(uv); }",
        "vec3 probe(vec2 uv) { uv++; return image(uv); }", "vec3 probe(vec2 uv) { uv *= 2.0; return image(uv); }",
        "vec3 probe(vec2 uv) { if (uv.x > 0.5) uv = 1.0 - uv; return image(uv); }",
        "vec3 probe(vec2 uv) { return image(uv.x > 0.5 ? uv : 1.0 - uv); }",
        "vec3 probe(vec2 uv) { switch (int(uv.x * 2.0)) { case 0: uv = uv.yx; default: break; } return image(uv); }",
        "vec3 probe(vec2 uv) { for (int i = 0; i < 3; ++i) uv = uv.yx; return image(uv); }",
        "void move(inout vec2 p) { p *= 2.0; }\nvec3 probe(vec2 uv) { move(uv); return image(uv); }",
        "void move(out vec2 p) { p = vec2(0.5); }\nvec3 probe(vec2 uv) { move(uv); return image(uv); }",
        "vec3 probe(vec2 uv) { return image((uv = vec2(0.5), uv)); }",
        "vec3 probe(vec2 uv) { vec2 whole; modf(uv, whole); return image(whole); }",
        "vec3 probe(vec2 uv) { return image(uv * 1.0); }", "vec3 probe(vec2 uv) { return image(uv - uv); }",
        "vec3 probe(vec2 uv) { return image(mat2(1.0) * uv); }", "vec3 probe(vec2 uv) { return image(-uv); }",
        "vec3 probe(vec2 uv) { return image(vec2(uv.x)); }", "vec3 probe(vec2 uv) { return image(uv + 0.25 / vec2(image_size())); }");
    CAPTURE(body);
    CHECK(access_of(body) == "warp");
}

TEST_CASE("a level of detail reads anywhere", "[shader][access]")
{
    const std::string text = passgraph::test::probe("vec3 probe(vec2 uv) { return image(uv) + other_lod(uv, 0.0); }");
    CHECK(passgraph::test::access_in(text, "image") == "pointwise");
    CHECK(passgraph::test::access_in(text, "other") == kAnywhere);
}

TEST_CASE("an input whose extent alone is asked for is read nowhere", "[shader][access]")
{
    CHECK(access_of("vec3 probe(vec2 uv) { return vec3(image_size(), 0.0); }") != "pointwise");
    CHECK(access_of("vec3 probe(vec2 uv) { return vec3(image_size(), 0.0); }") == access_of("vec3 probe(vec2 uv) { return vec3(image_texel(), 0.0); }"));
    CHECK(access_of("vec3 probe(vec2 uv) { return vec3(image_size(), 0.0); }").find("size") == 0);
}
