// Neighbourhoods: their radius is found where it is literal, static or in a parameter's range, and is unknown elsewhere.
#include <fmt/format.h>

#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::test::access_of;

namespace {

struct Row {
    const char* body;
    const char* expected;
};

const char* const kAnywhere = "gather(radius unknown)";

std::string summed(const std::string& loop)
{
    return fmt::format("vec3 probe(vec2 uv) {{ vec3 s = vec3(0.0); vec2 t = image_texel(); {} return s; }}", loop);
}

} // namespace

TEST_CASE("a literal neighbourhood is a gather of its radius", "[shader][access]")
{
    const auto row = GENERATE(values<Row>({
        {"s = image(uv + t) + image(uv - t);", "gather(1)"},
        {"s = image(uv + 0.5 * t);", "gather(1)"},
        {"s = image(uv + vec2(3.0, -7.0) * t) + image(uv);", "gather(7)"},
        {"s = image(vec2(uv.x + 2.0 * t.x, uv.y));", "gather(2)"},
        {"s = image(uv + t + t - 2.0 * t);", "gather(4)"},
        {"s = image(uv + t / 0.25);", "gather(4)"},
        {"s = image(uv + 0.0 * t);", "pointwise"},
        {"s = image(s.x > 0.0 ? uv + t : uv - 2.0 * t);", "gather(2)"},
        {"vec2 p = uv; if (s.x > 0.0) p += 3.0 * t; s = image(p);", "gather(3)"},
        {"for (int y = -1; y <= 1; ++y) for (int x = -1; x <= 1; ++x) s += image(uv + vec2(x, y) * t);", "gather(1)"},
        {"for (int i = 4; i > -4; i--) s += image(uv + float(i) * t);", "gather(4)"},
        {"for (int i = 0; i < 3; ++i) { if (i == 1) continue; s += image(uv + float(i * 2) * t); }", "gather(6)"},
        {"for (float x = -2.0; x <= 2.0; ++x) s += image(uv + x * t);", "gather(2)"},
        {"const int reach = 5; for (int i = -reach; i <= reach; ++i) s += image(uv + vec2(i, 0) * t);", "gather(5)"},
        {"const vec2 taps[3] = vec2[3](vec2(0.0), vec2(1.5, 0.0), vec2(0.0, -2.5)); for (int i = 0; i < 3; ++i) s += image(uv + taps[i] * t);",
         "gather(3)"},
        {"float far = 3.0; s = image(uv + min(far, 2.0) * t) + image(uv + clamp(uv.x, 0.0, 1.0) * t);", "gather(radius unknown)"},
        {"float far = 3.0; s = image(uv + min(far, 2.0) * t);", "gather(2)"},
        {"s = image(uv + max(-1.0, -4.0) * t);", "gather(1)"},
    }));
    CAPTURE(row.body);
    CHECK(access_of(summed(row.body)) == row.expected);
}

TEST_CASE("a neighbourhood without a provable bound reads anywhere", "[shader][access]")
{
    const char* const loop = GENERATE(
        "int i = 0; while (i < 3) { s += image(uv + float(i) * t); i++; }",
        "vec2 p = uv; for (int i = 0; i < 3; ++i) { s += image(p); p += t; }",
        "for (int i = 0; i < 3; ++i) { s += image(uv + float(i) * t); i += 0; }",
        "for (int i = 0; i < int(uv.x * 9.0); ++i) s += image(uv + float(i) * t);",
        "int n = 3; for (int i = 0; i < n; ++i) { n = 9; s += image(uv + float(i) * t); }",
        "for (int i = 0; i < 3; --i) { if (i < -90) break; s += image(uv + float(i) * t); }",
        "int j = 0; for (int i = 0; i < 3; ++i) { j += 2; s += image(uv + float(j) * t); }");
    CAPTURE(loop);
    CHECK(access_of(summed(loop)) == kAnywhere);
}

TEST_CASE("an offset in another input's texels, or along the other axis, says nothing", "[shader][access]")
{
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + other_texel()); }") == "warp");
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + other_texel()) + image(uv - image_texel()); }") == kAnywhere);
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + image_texel() + other_texel()); }") == "warp");
    // A picture of 1000 x 1 texels: one texel of its height is a thousand of its width.
    CHECK(access_of("vec3 probe(vec2 uv) { return image(uv + image_texel().yx); }") == "warp");
    CHECK(access_of("vec3 probe(vec2 uv) { float t = image_texel().y; return image(vec2(uv.x + t, uv.y)); }") == "warp");
    CHECK(access_of("vec3 probe(vec2 uv) { return image(vec2(uv.x, uv.y + image_texel().y)); }") == "gather(1)");
    CHECK(access_of("vec3 probe(vec2 uv) { vec2 t = uv.x > 0.5 ? image_texel() : image_texel().yx; return image(uv + t); }") == "warp");
}
