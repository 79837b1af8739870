// `eval`: binary32 in and out, and every mistake of a table with its place.
#include "program.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using test::Workplace;
using Catch::Contains;

namespace {

/// The lines that stdout has, without the header.
std::string evaluated(const std::string& expression, const std::string& csv, const std::string& header)
{
    const Workplace place;
    place.write("in.csv", csv);
    const test::Outcome outcome = place.run({"eval", expression, "--csv", "in.csv"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    REQUIRE(outcome.out.rfind(header + "\n", 0) == 0);
    return outcome.out.substr(header.size() + 1);
}

} // namespace

TEST_CASE("eval passes binary32 through unchanged", "[tool][eval]")
{
    // 0.1 is not a binary32; its nearest one comes out with the nine digits that tell it from its neighbours.
    CHECK(evaluated("x", "x\n0.1\n16777217\n-0\n3.4028234663852886e38\n1.17549435e-38\n", "x,value") ==
          "0.100000001,0.100000001\n16777216,16777216\n-0,-0\n3.40282347e+38,3.40282347e+38\n1.17549435e-38,1.17549435e-38\n");
    CHECK(evaluated("x", "x\nnan\ninf\n-inf\n-nan\n1e99\n-1e99\n1e-99\n", "x,value") ==
          "nan,nan\ninf,inf\n-inf,-inf\nnan,nan\ninf,inf\n-inf,-inf\n0,0\n");
    // Half-way cases of a decimal are rounded once: 1 + 2^-24 to even, and a bit more upwards.
    CHECK(evaluated("x", "x\n1.000000059604644775390625\n1.000000059604644775390626\n", "x,value") ==
          "1,1\n1.00000012,1.00000012\n");
}

TEST_CASE("eval computes one value per row, of one to four components", "[tool][eval]")
{
    CHECK(evaluated("a + b", "a,b\n1,2\n\n0.5, -4\r\n", "a,b,value") == "1,2,3\n0.5,-4,-3.5\n");
    CHECK(evaluated("vec2(b, a)", "a,b\n1,2\n", "a,b,x,y") == "1,2,2,1\n");
    CHECK(evaluated("vec3(a)", "a\n7\n", "a,x,y,z") == "7,7,7,7\n");
    CHECK(evaluated("vec4(a, 2.0 * a, 0.0, -a)", "a\n1\n", "a,x,y,z,w") == "1,1,2,0,-1\n");
    CHECK(evaluated("a > 1.0", "a\n1\n2\n", "a,value") == "1,0\n2,1\n");
    CHECK(evaluated("int(a)", "a\n1.75\n", "a,value") == "1.75,1\n");
    CHECK(evaluated("-x", "x\n1\n", "x,value") == "1,-1\n");
    CHECK(evaluated("x == 1.0 ? 5.0 : 6.0", "x\n1\n", "x,value") == "1,5\n");
    CHECK(evaluated("a", "a\n", "a,value").empty());
}

TEST_CASE("eval takes more rows than a texture is wide", "[tool][eval]")
{
    std::string csv = "i,j\n";
    std::string expected;
    for (int i = 0; i < 20000; ++i) {
        csv += std::to_string(i) + ",1\n";
        expected += std::to_string(i) + ",1," + std::to_string(i + 1) + "\n";
    }
    CHECK(evaluated("i + j", csv, "i,j,value") == expected);
}

TEST_CASE("eval includes common files and passes, and writes a file", "[tool][eval]")
{
    const Workplace place;
    place.write("square.glsl", "// Squares.\nfloat square(float x) { return x * x; }\n");
    place.write("cube.glsl", "// Cubes.\nfloat cube(float x) { return x * x * x; }\n");
    place.write("in.csv", "x\n3\n");
    const auto outcome = place.run({"eval", "square(x) + cube(x)", "--include", "square.glsl", "--include", "cube.glsl", "--csv", "in.csv", "--out", "o.csv"});
    CHECK(outcome.err == "");
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.empty());
    CHECK(place.read("o.csv") == "x,value\n3,36\n");
    const std::string common = std::string(PASSGRAPH_SOURCE_DIR) + "/passes/common/luminance.glsl";
    CHECK(place.run({"eval", "luminance(vec3(x))", "--include", common, "--csv", "in.csv", "--out", "-"}).code == 0);
}

TEST_CASE("a table's mistakes come all at once, with their places", "[tool][eval]")
{
    const Workplace place;
    place.write("old.csv", "untouched");
    const auto errors = [&](const std::string& expression, const std::string& csv) {
        place.write("in.csv", csv);
        const test::Outcome outcome = place.run({"eval", expression, "--csv", "in.csv", "--out", "old.csv"});
        CHECK(outcome.code == 1);
        CHECK(place.read("old.csv") == "untouched");
        return outcome.err;
    };
    CHECK_THAT(errors("a", "a, b\n1,two\n,2\n1\n1,2,3\n1.5x,0x10\n"),
               Contains("in.csv:2:3: error[csv_cell] `two`") && Contains("in.csv:3:1: error[csv_cell] this cell is empty") &&
                   Contains("in.csv:4:1: error[csv_row]") && Contains("in.csv:5:5: error[csv_row]") && Contains("in.csv:6:1: error[csv_cell]") &&
                   Contains("in.csv:6:6: error[csv_cell]"));
    CHECK_THAT(errors("1.0", "float,a b,a,a\n1,2,3,4\n"),
               Contains("in.csv:1:1: error[csv_column]") && Contains("in.csv:1:7: error[csv_column]") && Contains("in.csv:1:13: error[csv_column]"));
    CHECK_THAT(errors("1.0", ""), Contains("in.csv:1:1: error[csv_empty]"));
    CHECK_THAT(errors("b * 2.0", "a\n1\n"), Contains("error[glsl_error]") && Contains("'b'"));
    CHECK_THAT(errors("a +", "a\n1\n"), Contains("error[glsl_error]"));
}
