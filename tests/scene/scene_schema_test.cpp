// The published schema of scene files and the reader know the same fields.
#include <algorithm>
#include <set>

#include <passgraph/core/json.hpp>

#include "support/catch.hpp"

#include "files.hpp"

using namespace passgraph;

namespace {

using Names = std::set<std::string>;

Json schema()
{
    const std::string path = std::string(PASSGRAPH_SOURCE_DIR) + "/lib/scene/scene.schema.json";
    auto json = parse_json(read_text_file(path).value(), path);
    REQUIRE(json);
    return *json;
}

Names properties(const Json& object)
{
    REQUIRE(object.find("properties"));
    Names names;
    for (const auto& member : object.find("properties")->members)
        names.insert(member.key);
    CHECK(object.find("additionalProperties")->kind == Json::Kind::boolean);
    return names;
}

/// The fields a reader lists when it meets one that resembles none of them.
Names known_fields(const std::string& text)
{
    const test::Folder folder;
    const auto scene = load_scene(folder.write("s.json", text));
    REQUIRE_FALSE(scene);
    const std::string start = "the fields are: ";
    for (const Error& error : scene.error()) {
        if (error.code != "unknown_field")
            continue;
        REQUIRE(error.hint.starts_with(start));
        Names names;
        std::string rest = error.hint.substr(start.size()) + ", ";
        for (size_t comma; (comma = rest.find(", ")) != std::string::npos; rest = rest.substr(comma + 2))
            names.insert(rest.substr(0, comma));
        return names;
    }
    return {};
}

} // namespace

TEST_CASE("the schema names exactly the fields that the reader knows", "[scene][schema]")
{
    const Json root = schema();
    const Json& parts = *root.find("$defs");
    const std::string odd = "\"qqqqqqqqqqqqqqqq\": 0";
    const std::string start = "{\"passgraph_scene\": 1, ";
    CHECK(properties(root) == known_fields(start + odd + "}"));
    CHECK(properties(*parts.find("camera")) == known_fields(start + "\"camera\": {" + odd + "}}"));
    CHECK(properties(*parts.find("sky")) == known_fields(start + "\"sky\": {" + odd + "}}"));
    CHECK(properties(*parts.find("atlas")) == known_fields(start + "\"atlas\": {" + odd + "}}"));
    CHECK(properties(*parts.find("element")) == known_fields(start + "\"elements\": [{" + odd + "}]}"));
    for (const std::string kind : {"directional", "point", "spot"}) {
        const std::string light = "\"lights\": [{\"kind\": \"" + kind + "\", " + odd + "}]}";
        CHECK(properties(*parts.find(kind + "_light")) == known_fields(start + light));
    }
}

TEST_CASE("what the schema requires the reader misses", "[scene][schema]")
{
    const Json root = schema();
    const test::Folder folder;
    const auto scene = load_scene(folder.write(
        "s.json", "{\"camera\": {}, \"sky\": {}, \"atlas\": {}, \"elements\": [{}], \"lights\": [{\"kind\": \"directional\"}, "
                  "{\"kind\": \"point\"}, {\"kind\": \"spot\"}]}"));
    REQUIRE_FALSE(scene);
    const std::string text = to_text(scene.error());
    const auto check = [&](const Json& part) {
        for (const Json& name : part.find("required")->array)
            if (name.string != "kind")
                CHECK_THAT(text, Catch::Contains("lacks \"" + name.string + "\""));
    };
    check(root);
    for (const char* part : {"camera", "sky", "atlas", "element", "directional_light", "point_light", "spot_light"})
        check(*root.find("$defs")->find(part));
}
