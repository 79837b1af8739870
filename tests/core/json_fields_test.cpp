// Members read by name: wrong types, missing fields, fields nobody knows; and text files.
#include <array>

#include <passgraph/core/json.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

Json parsed(const std::string& text)
{
    const auto json = parse_json(text, "a.json");
    REQUIRE(json);
    return *json;
}

} // namespace

TEST_CASE("fields that nobody asked for are reported with the nearest known one", "[core][json]")
{
    const MarkedText source = marked("{ \"name\": \"x\",\n  @\"colour\": 1,\n  @\"zzz\": 2 }");
    const Json json = parsed(source.text);
    Errors errors;
    JsonFields fields(json, "lamp", errors);
    CHECK(fields.text("name") == "x");
    CHECK(fields.number("color", 7.0) == 7.0);
    fields.finish();
    CHECK(codes_of(errors) == codes_at(source, {"unknown_field", "unknown_field"}));
    CHECK(errors[0].message == "lamp has no field \"colour\"");
    CHECK(errors[0].hint == "did you mean `color`?");
    CHECK(errors[1].hint == "the fields are: name, color");
}

TEST_CASE("a field of another type is reported at its value, and the fallback stands in", "[core][json]")
{
    const MarkedText source = marked(R"({ "a": @1, "b": @"x", "c": @[], "d": @true, "e": @{} })");
    const Json json = parsed(source.text);
    Errors errors;
    JsonFields fields(json, "lamp", errors);
    CHECK(fields.text("a", "fallback") == "fallback");
    CHECK(fields.number("b", 2.0) == 2.0);
    CHECK(fields.boolean("c", true));
    CHECK(fields.find("d", Json::Kind::object) == nullptr);
    CHECK(fields.require("e", Json::Kind::array) == nullptr);
    fields.finish();
    CHECK(codes_of(errors) == codes_at(source, {"wrong_type", "wrong_type", "wrong_type", "wrong_type", "wrong_type"}));
    CHECK(errors[0].message == "lamp: \"a\": expected a string, got a number");
}

TEST_CASE("a missing field is reported once, at its object", "[core][json]")
{
    const MarkedText source = marked("\n  @{ }");
    const Json json = parsed(source.text);
    Errors errors;
    JsonFields fields(json, "lamp", errors);
    CHECK(fields.require("name", Json::Kind::string) == nullptr);
    CHECK(codes_of(errors) == codes_at(source, {"field_missing"}));
    CHECK(errors[0].message == "lamp lacks \"name\"");
}

TEST_CASE("something that is no object is one mistake, not one per field", "[core][json]")
{
    const Json json = parsed("[1]");
    Errors errors;
    JsonFields fields(json, "lamp", errors);
    CHECK(fields.require("name") == nullptr);
    CHECK(fields.text("label", "x") == "x");
    fields.finish();
    CHECK(codes_of(errors) == "wrong_type 1:1\n");
}

TEST_CASE("rows of numbers have the right count and are finite in binary32", "[core][json]")
{
    const MarkedText source = marked(R"({ "good": [1, 2.5, -3], "few": @[1, 2], "many": @[1, 2, 3, 4], "mixed": @[1, "2", 3],
  "huge": @[1, 1e300, 2], "none": @5 })");
    const Json json = parsed(source.text);
    Errors errors;
    JsonFields fields(json, "lamp", errors);
    std::array<float, 3> numbers = {7, 7, 7};
    CHECK(fields.numbers("good", 3, numbers.data()));
    CHECK(numbers == std::array<float, 3>{1.0f, 2.5f, -3.0f});
    for (const char* key : {"few", "many", "mixed", "huge", "none", "absent"})
        CHECK(!fields.numbers(key, 3, numbers.data()));
    CHECK(numbers == std::array<float, 3>{1.0f, 2.5f, -3.0f});
    CHECK(codes_of(errors) == codes_at(source, {"wrong_type", "wrong_type", "wrong_type", "wrong_type", "wrong_type"}));
}

TEST_CASE("a file that is missing or a folder is an error naming it", "[core][json]")
{
    const auto missing = read_text_file("/nowhere/at/all.json");
    REQUIRE(!missing);
    CHECK(missing.error().front().code == "file_missing");
    CHECK(missing.error().front().where.file == "/nowhere/at/all.json");
    const auto folder = read_text_file(PASSGRAPH_SOURCE_DIR "/tests");
    REQUIRE(!folder);
    CHECK(folder.error().front().code == "file_unreadable");
    CHECK_THAT(read_text_file(PASSGRAPH_SOURCE_DIR "/tests/core/CMakeLists.txt").value_or(""), Contains("passgraph_tests(core"));
}
