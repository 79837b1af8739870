// The passes that come with the library load, and read as their authors meant.
#include <fmt/format.h>

#include "passgraph/core/pass_header.hpp"
#include "passgraph/shader/pass_file.hpp"
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using passgraph::PassLibrary;

namespace {

const PassLibrary& built_in()
{
    static const PassLibrary library = [] {
        PassLibrary loaded;
        const auto result = passgraph::load_pass_folder(PASSGRAPH_SOURCE_DIR "/passes", loaded);
        if (!result)
            FAIL(passgraph::to_text(result.error()));
        return loaded;
    }();
    return library;
}

} // namespace

TEST_CASE("every built-in pass loads and says what it does and where it comes from", "[shader][builtin]")
{
    CHECK(built_in().passes().size() >= 12);
    for (const auto& [name, pass] : built_in().passes()) {
        CAPTURE(name);
        CHECK_FALSE(pass->summary.empty());
        CHECK_FALSE(pass->source.empty());
    }
}

TEST_CASE("built-in passes read their inputs in the way their function needs", "[shader][builtin]")
{
    struct Row {
        const char* pass;
        const char* input;
        const char* access;
    };
    const auto row = GENERATE(values<Row>({
        {"bloom_combine", "scene", "pointwise"}, {"bloom_combine", "bloom", "pointwise"}, {"bright", "image", "pointwise"},
        {"blur_direction", "image", "gather(12)"}, {"downsample", "image", "gather(radius unknown)"}, {"upsample", "image", "pointwise"},
        {"night_vision", "image", "pointwise"}, {"vignette", "image", "pointwise"}, {"tone_map", "image", "pointwise"},
        {"pixelate", "image", "gather(radius unknown)"}, {"pbr_surface", "albedo", "pointwise"}, {"pbr_surface", "normal", "pointwise"},
        {"pbr_surface", "position", "pointwise"}, {"pbr_surface", "emissive", "pointwise"}, {"sky", "depth", "pointwise"},
    }));
    CAPTURE(row.pass, row.input);
    const auto pass = built_in().find(row.pass);
    REQUIRE(pass);
    const int input = pass->find_input(row.input);
    REQUIRE(input >= 0);
    CHECK(to_text(pass->inputs[static_cast<size_t>(input)].access) == row.access);
}

TEST_CASE("what was derived survives its way through JSON", "[shader][builtin]")
{
    for (const auto& [name, pass] : built_in().passes()) {
        CAPTURE(name);
        passgraph::PassDeclaration copy = *pass;
        for (passgraph::InputPort& port : copy.inputs)
            port.access = {};
        REQUIRE(apply_derived(copy, derived_to_json(*pass)));
        for (size_t i = 0; i < copy.inputs.size(); ++i)
            CHECK(copy.inputs[i].access == pass->inputs[i].access);
    }
    passgraph::PassDeclaration copy = *built_in().find("bright");
    CHECK_FALSE(apply_derived(copy, R"({ "image": { "access": 3 } })"));
    CHECK_FALSE(apply_derived(copy, "{"));
}
