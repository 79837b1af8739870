// How errors read, and which names count as typing mistakes.
#include <passgraph/core/error.hpp>

#include "support/catch.hpp"

using namespace passgraph;

TEST_CASE("an error reads file:line:column, code, message, hint", "[core][error]")
{
    CHECK(to_text(Error{"cycle", "round and round", "cut it", {"g.json", 3, 14}}) ==
          "g.json:3:14: error[cycle] round and round\n  hint: cut it");
    CHECK(to_text(Error{"cycle", "round", "", {"g.json", 3, 0}}) == "g.json:3: error[cycle] round");
    CHECK(to_text(Error{"cycle", "round", "", {"g.json", 0, 7}}) == "g.json: error[cycle] round");
    CHECK(to_text(Error{"cycle", "round", "", {"", 3, 14}}) == "error[cycle] round");
    CHECK(to_text(Errors{{"a", "one"}, {"b", "two", "fix"}}) == "error[a] one\nerror[b] two\n  hint: fix\n");
    CHECK(to_text(Errors{}).empty());
}

TEST_CASE("a failed result holds its one error", "[core][error]")
{
    const Result<int> failed = fail({"file_missing", "gone"});
    REQUIRE(!failed);
    REQUIRE(failed.error().size() == 1);
    CHECK(failed.error().front().code == "file_missing");
    CHECK(failed.error().front().fault == Fault::user);
}

TEST_CASE("the closest name is one that a typing mistake could have made", "[core][error]")
{
    const std::vector<std::string> names = {"bright", "gaussian_blur", "tone_map", "sky"};
    CHECK(closest("brigth", names) == "bright");  // two letters swapped are one mistake
    CHECK(closest("brght", names) == "bright");   // one missing
    CHECK(closest("brighht", names) == "bright"); // one too many
    CHECK(closest("gausian_blurr", names) == "gaussian_blur");
    CHECK(closest("sly", names) == "sky");
    CHECK(closest("shy", names) == "sky");
    CHECK(closest("a", names).empty()); // short, but not near
    CHECK(closest("pixelate", names).empty());
    CHECK(closest("", {"ab", "abc"}).empty());
    CHECK(closest("brights", {}).empty());
    CHECK(closest(std::string(101, 'a'), {std::string(100, 'a')}).empty()); // bounds the cost
    CHECK(closest("tone", {"tine", "tune"}) == "tine");                     // of equals, the first
}

TEST_CASE("a suggestion names the near name, else all there are, else that there are none", "[core][error]")
{
    CHECK(suggest("brigth", {"bright", "sky"}, "passes") == "did you mean `bright`?");
    CHECK(suggest("pixelate", {"bright", "sky"}, "passes") == "the passes are: bright, sky");
    CHECK(suggest("pixelate", {}, "passes") == "there are no passes");
}
