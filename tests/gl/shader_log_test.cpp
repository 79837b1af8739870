// Logs of GLSL compilers, as errors with places.
#include "gl/shader_log.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::gl;

namespace {

const std::vector<std::string> kSources = {"graph", "blur.glsl"};
const int kFolded = 12 + kSourceStride; // line 12 of source 1

} // namespace

TEST_CASE("each driver's form of a complaint gives file, line and text", "[gl][shader_log]")
{
    const auto log = GENERATE(fmt::format("0:{}(5): error: `x' undeclared\n", kFolded),
                              fmt::format("0({}) : error `x' undeclared\n", kFolded),
                              fmt::format("ERROR: 0:{}: `x' undeclared\nERROR: 1 compilation errors.\n", kFolded));
    const Errors errors = shader_errors(log, "step `blur`", kSources);
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].code == "shader_failed");
    CHECK(errors[0].message == "step `blur`: `x' undeclared");
    CHECK(errors[0].where.file == "blur.glsl");
    CHECK(errors[0].where.line == 12);
}

TEST_CASE("warnings are not errors, and every error is kept", "[gl][shader_log]")
{
    const Errors errors = shader_errors("0:1(1): warning: odd\n0:2(3): error: a\n0:4(1): error: b\n", "s", kSources);
    REQUIRE(errors.size() == 2);
    CHECK(errors[1].where == Location{"graph", 4, 1});
}

TEST_CASE("of several complaints about one line the first is kept", "[gl][shader_log]")
{
    const Errors errors = shader_errors("0:2(3): error: a\n0:2(9): error: b\n0:3(1): error: c\n", "s", kSources);
    REQUIRE(errors.size() == 2);
    CHECK(errors[0].message == "s: a");
    CHECK(errors[1].message == "s: c");
}

TEST_CASE("a log of unknown form, or of an unknown source, is kept whole", "[gl][shader_log]")
{
    const Errors whole = shader_errors("link failed: too much\n", "s", kSources);
    REQUIRE(whole.size() == 1);
    CHECK(whole[0].message == "s: link failed: too much");
    const Errors unknown = shader_errors(fmt::format("0:{}(1): error: x\n", 5 * kSourceStride), "s", kSources);
    CHECK(unknown[0].where.file.empty());
}

TEST_CASE("source numbers travel in the line numbers", "[gl][shader_log]")
{
    CHECK(folded_source_numbers("#version 330 core\n#line 12 1\nfloat x;\n# line 3 0\n#line 9\nint y;") ==
          fmt::format("#version 330 core\n#line {}\nfloat x;\n#line 3\n#line 9\nint y;\n", kFolded));
}
