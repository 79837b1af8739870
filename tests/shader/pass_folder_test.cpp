// Folders of passes: nested, with common files, composites that use one another, and files that are broken.
#include <algorithm>

#include "passgraph/shader/pass_file.hpp"
#include "shader/pass_text.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using passgraph::test::Folder;

namespace {

std::string simple(const std::string& name, const std::string& extra = "")
{
    return "/*{ \"pass\": \"" + name + "\", \"inputs\": { \"image\": \"color\" }, \"outputs\": { \"result\": \"color\" } }*/\n" + extra + "vec3 " + name +
           "(vec2 uv) { return image(uv); }\n";
}

/// A composite that is the pass `inner`.
std::string composite(const std::string& name, const std::string& inner)
{
    return R"({ "passgraph": 1, "pass": ")" + name + R"(", "summary": "s", "source": "s", "inputs": { "image": { "signal": "color" } },
  "passes": { "inner": { "pass": ")" + inner + R"(", "inputs": { "image": "image" } } }, "outputs": { "result": "inner" } })";
}

bool has_code(const Errors& errors, const std::string& code)
{
    return std::any_of(errors.begin(), errors.end(), [&](const Error& error) { return error.code == code; });
}

} // namespace

TEST_CASE("a folder's passes are found in its subfolders, which are their families; common is left out", "[shader][folder]")
{
    Folder folder;
    folder.write("screen/first.glsl", simple("first"));
    folder.write("screen/deep/second.glsl", simple("second"));
    folder.write("common/helper.glsl", "// No pass.\nfloat helper() { return 1.0; }\n");
    folder.write("screen/notes.txt", "not a pass");
    PassLibrary library;
    const auto result = load_pass_folder(folder.path(), library);
    INFO((result ? "" : to_text(result.error())));
    REQUIRE(result);
    CHECK(library.names() == std::vector<std::string>{"first", "second"});
    CHECK(library.find("first")->family == "screen");
    CHECK(library.find("second")->family == "deep");
    CHECK(library.find("first")->inputs[0].access.kind == AccessClass::pointwise);
}

TEST_CASE("a folder that does not exist is an error", "[shader][folder]")
{
    PassLibrary library;
    const auto result = load_pass_folder("/nowhere/at/all", library);
    REQUIRE_FALSE(result);
    CHECK(result.error().front().code == "file_missing");
    CHECK(result.error().front().where.file == "/nowhere/at/all");
}

TEST_CASE("a broken pass hides no other, and every broken one is told", "[shader][folder]")
{
    Folder folder;
    folder.write("first.glsl", simple("first", "float broken() { return nothing; }\n"));
    folder.write("second.glsl", simple("second"));
    folder.write("third.glsl", "no header");
    folder.write("d.graph.json", "{");
    folder.write("e.graph.json", composite("e", "second"));
    PassLibrary library;
    const auto result = load_pass_folder(folder.path(), library);
    REQUIRE_FALSE(result);
    CHECK(has_code(result.error(), "glsl_error"));
    CHECK(has_code(result.error(), "header_missing"));
    CHECK(has_code(result.error(), "json_syntax"));
    CHECK(library.names() == std::vector<std::string>{"e", "second"});
}

TEST_CASE("composites may name one another in any order", "[shader][folder]")
{
    Folder folder;
    folder.write("a.graph.json", composite("a", "z"));
    folder.write("middle.glsl", simple("middle"));
    folder.write("z.graph.json", composite("z", "middle"));
    PassLibrary library;
    const auto result = load_pass_folder(folder.path(), library);
    INFO((result ? "" : to_text(result.error())));
    REQUIRE(result);
    CHECK(library.names() == std::vector<std::string>{"a", "middle", "z"});
}

TEST_CASE("composites that contain themselves are told, and those beside them load", "[shader][folder]")
{
    Folder folder;
    folder.write("a.graph.json", composite("a", "b"));
    folder.write("b.graph.json", composite("b", "a"));
    folder.write("fine.graph.json", composite("fine", "middle"));
    folder.write("itself.graph.json", composite("itself", "itself"));
    folder.write("middle.glsl", simple("middle"));
    PassLibrary library;
    const auto result = load_pass_folder(folder.path(), library);
    REQUIRE_FALSE(result);
    CHECK(std::count_if(result.error().begin(), result.error().end(), [](const Error& error) { return error.code == "cycle"; }) == 3);
    CHECK(library.names() == std::vector<std::string>{"fine", "middle"});
}

TEST_CASE("an include is looked for in common beside the pass, one folder up, then in the fallback", "[shader][folder]")
{
    Folder folder;
    const std::string body = R"(/*{ "pass": "user", "inputs": { "image": "color" }, "outputs": { "result": "color" } }*/
#include "helper.glsl"
vec3 user(vec2 uv) { return helper() * image(uv); }
)";
    const std::string file = folder.write("family/user.glsl", body);
    const std::string fallback = folder.path() + "/fallback";
    folder.write("fallback/helper.glsl", "// 3\nfloat helper() { return 3.0; }\n");
    const auto included_by = [&] {
        const auto pass = load_pass_file(file, fallback);
        return pass ? (*pass)->body.includes.front()->text : to_text(pass.error());
    };
    CHECK(included_by().find("3.0") != std::string::npos);
    folder.write("common/helper.glsl", "// 2\nfloat helper() { return 2.0; }\n");
    CHECK(included_by().find("2.0") != std::string::npos);
    folder.write("family/common/helper.glsl", "// 1\nfloat helper() { return 1.0; }\n");
    CHECK(included_by().find("1.0") != std::string::npos);

    Folder alone;
    const auto missing = load_pass_file(alone.write("user.glsl", body));
    REQUIRE_FALSE(missing);
    CHECK(missing.error().front().code == "include_missing");
    CHECK(missing.error().front().where.line == 2);
    CHECK(load_pass_file(alone.path() + "/gone.glsl").error().front().code == "file_missing");
}
