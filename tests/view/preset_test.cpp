// Presets are read back as they were written, and their mistakes have their places.
#include "support/catch.hpp"
#include "tool/preset.hpp"
#include "view/scratch_folder.hpp"

using namespace passgraph;
using namespace passgraph::tool;

TEST_CASE("a preset reads back what was written", "[view][preset]")
{
    test::ScratchFolder folder;
    const std::vector<PassArguments::Setting> written = {
        {"glow.sigma", {0.1}, "", {}}, {"green.tint", {0.4, 1.0 / 3.0, 1e-7}, "", {}}, {"lit.distribution", {}, "ggx", {}}, {"a.flag", {}, "true", {}}};
    const auto read = read_preset(folder.write("p.preset.json", preset_text(written)));
    REQUIRE(read);
    REQUIRE(read->size() == written.size());
    for (size_t i = 0; i < written.size(); ++i) {
        CHECK((*read)[i].name == written[i].name);
        CHECK((*read)[i].numbers == written[i].numbers); // every bit: the shortest text that reads back the same
        CHECK((*read)[i].item == written[i].item);
    }
    CHECK(preset_text({}) == "{\n  \"passgraph_preset\": 1,\n  \"values\": {}\n}\n");
    CHECK(read_preset(folder.write("empty.preset.json", preset_text({})))->empty());
}

TEST_CASE("a preset's mistakes are all told, each with its place", "[view][preset]")
{
    test::ScratchFolder folder;
    const auto read = read_preset(folder.write("p.preset.json", "{ \"passgraph_preset\": 2,\n  \"values\": { \"a.b\": [1, \"x\"],\n  \"c.d\": null },\n  \"more\": 1 }"));
    REQUIRE_FALSE(read);
    std::vector<std::pair<std::string, int>> found;
    for (const Error& error : read.error())
        found.emplace_back(error.code, error.where.line);
    const std::vector<std::pair<std::string, int>> expected = {{"version_unknown", 1}, {"wrong_type", 2}, {"wrong_type", 3}, {"unknown_field", 4}};
    CHECK(found == expected);
    CHECK(read_preset(folder.path("none")).error().front().code == "file_missing");
}
