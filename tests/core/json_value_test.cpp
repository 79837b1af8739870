// JSON that is written: what braces mean, and texts that no JSON can hold.
#include <limits>

#include <passgraph/core/json_value.hpp>

#include "support/catch.hpp"

using passgraph::JsonValue;

TEST_CASE("pairs that begin with a text are an object; other lists are arrays", "[core][json]")
{
    CHECK(JsonValue{{"a", 1}, {"b", nullptr}}.text() == R"({"a":1,"b":null})");
    CHECK(JsonValue{1, "two", 3.5, true}.text() == R"([1,"two",3.5,true])");
    CHECK(JsonValue{{"a", 1}, 2}.text() == R"([["a",1],2])");
    CHECK(JsonValue{{"a", {{"b", {1, 2}}}}}.text() == R"({"a":{"b":[1,2]}})");
    CHECK(JsonValue::array({"a", 1}).text() == R"(["a",1])");
    CHECK(JsonValue(std::vector<std::string>{"a", "b"}).text() == R"(["a","b"])");
    CHECK(JsonValue::object().text() == "{}");
    CHECK(JsonValue::array().text() == "[]");
    CHECK(JsonValue().text() == "null");
}

TEST_CASE("members keep their order, and stand once", "[core][json]")
{
    JsonValue json;
    json["z"] = 1;
    json["a"].push_back("first");
    json["z"] = 2;
    json.update({{"b", false}, {"a", 0}});
    CHECK(json.text() == R"({"z":2,"a":0,"b":false})");
}

TEST_CASE("numbers keep their kind and all their digits", "[core][json]")
{
    CHECK(JsonValue(std::numeric_limits<unsigned long>::max()).text() == "18446744073709551615");
    CHECK(JsonValue(-1).text() == "-1");
    CHECK(JsonValue(0.1).text() == "0.1");
    CHECK(JsonValue(1.0).text() == "1.0");
    CHECK(JsonValue(std::numeric_limits<double>::infinity()).text() == "null");
}

TEST_CASE("a text that is not UTF-8 is replaced, quotes are escaped", "[core][json]")
{
    CHECK(JsonValue("a\xff\"").text() == "\"a\xEF\xBF\xBD\\\"\"");
}
