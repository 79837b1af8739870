// The located JSON reader: places, duplicate keys, syntax errors, hostile texts.
#include <fmt/format.h>
#include <passgraph/core/json.hpp>

#include "core_support.hpp"
#include "support/catch.hpp"

using namespace passgraph;
using namespace passgraph::test;
using Catch::Contains;

namespace {

void collect(const Json& json, std::vector<Location>& places)
{
    places.push_back({"", json.where.line, json.where.column});
    for (const Json& item : json.array)
        collect(item, places);
    for (const Json::Member& member : json.members) {
        places.push_back({"", member.where.line, member.where.column});
        collect(member.value, places);
    }
}

/// Every value and key of the text must stand exactly at the marks.
void check_places(const std::string& text)
{
    const MarkedText source = marked(text);
    const auto json = parse_json(source.text, "a.json");
    if (!json)
        FAIL(to_text(json.error()));
    std::vector<Location> places;
    collect(*json, places);
    REQUIRE(places.size() == source.places.size());
    for (size_t i = 0; i < places.size(); ++i) {
        INFO("value " << i << " of " << text);
        CHECK(places[i] == source.places[i]);
    }
}

void check_errors(const std::string& text, const std::vector<std::string>& codes)
{
    const MarkedText source = marked(text);
    INFO(source.text);
    CHECK(codes_of(parse_json(source.text, "a.json")) == codes_at(source, codes));
}

} // namespace

TEST_CASE("each value and key of a JSON text knows where it starts", "[core][json]")
{
    check_places("@null");
    check_places("  \n\t@12");
    check_places("@[@1,@-2.5e3 ,@true,@false,@null,@\"x\",@[],@{}]");
    check_places("@{ @\"a\": @{ @\"b\" : @[ @1 , @2 ] }, @\"c\":@\"d\" }");
    check_places("@{\n  @\"a\":\n    @1,\n  @\"b\": @[\n@2]\n}\n");
}

TEST_CASE("comments shift no place", "[core][json]")
{
    check_places("// before\n@{ // here\n  @\"a\": @1, // \"b\": 2,\n  /* two\n lines */ @\"c\": @3 // last\n}");
    check_places("@[@1//one\n,@2/* 9 */,@3 /* 8 */ /* 7 */ , @4//\n]");
    check_places("@[@\"//\", @\"/*\", @5/**/,@6]");
}

TEST_CASE("lines may end in CR LF, and columns count bytes", "[core][json]")
{
    check_places("@{\r\n  @\"a\": @1,\r\n  @\"b\": @2 // c\r\n , @\"d\":@4}\r\n");
    check_places("@[@\"\xc3\xa4\xe2\x82\xac\", @\"\xf0\x9f\x92\xa1\", @1]");
    check_places("@[@\"\\\"\\u00e4\\n\", @1]");
}

TEST_CASE("places count from the given line and column", "[core][json]")
{
    const auto json = parse_json(" {\n \"a\": 1}", "p.glsl", 10, 3);
    REQUIRE(json);
    CHECK(json->where == Location{"p.glsl", 10, 4});
    CHECK(json->members.front().where == Location{"p.glsl", 11, 2});
}

TEST_CASE("values keep their kind, exact number and order", "[core][json]")
{
    const auto json = parse_json(R"({"z": 1, "a": 2.0, "t": true, "n": null, "s": "x\ty", "big": 4294967296, "neg": -3})", "a.json");
    REQUIRE(json);
    CHECK(json->members[0].key == "z");
    CHECK(json->members[1].key == "a");
    CHECK(json->find("z")->is_integer);
    CHECK(!json->find("a")->is_integer);
    CHECK(json->find("a")->number == 2.0);
    CHECK(json->find("t")->boolean);
    CHECK(json->find("n")->is(Json::Kind::null));
    CHECK(json->find("s")->string == "x\ty");
    CHECK(json->find("big")->number == 4294967296.0);
    CHECK(json->find("neg")->number == -3.0);
    CHECK(json->find("q") == nullptr);
    CHECK(kind_name(Json::Kind::array) == "an array");
}

TEST_CASE("every key that stands twice is reported, wherever it stands", "[core][json]")
{
    check_errors(R"({"a": 1, "b": {"c": 1, @"c": 2}, @"a": 3,
  @"a": 4})", {"json_duplicate_key", "json_duplicate_key", "json_duplicate_key"});
    const auto json = parse_json("{\"a\": 1,\n\"a\": 2}", "a.json");
    REQUIRE(!json);
    CHECK_THAT(json.error().front().hint, Contains("line 1"));
    CHECK(parse_json(R"([{"a": 1}, {"a": 2}])", "a.json")); // each object has its own keys
}

TEST_CASE("a syntax error is located at the token that does not fit", "[core][json]")
{
    check_errors("{\"a\": @}", {"json_syntax"});
    check_errors("{\"a\" @1}", {"json_syntax"});
    check_errors("{\"a\": 1 @\"b\": 2}", {"json_syntax"});
    check_errors("[1, @]", {"json_syntax"});
    check_errors("[1,@,2]", {"json_syntax"});
    check_errors("[1@:2]", {"json_syntax"});
    check_errors("{\n  \"a\": @flase\n}\n", {"json_syntax"});
    check_errors("[1, 0@1]", {"json_syntax"});
    check_errors("{} @x", {"json_syntax"});
    check_errors("[@1e999]", {"json_syntax"});
    check_errors("{\"a\": 1, @\"a\": 2, @}", {"json_duplicate_key", "json_syntax"});
}

TEST_CASE("a syntax error says what was read, and a text cut off says so", "[core][json]")
{
    const auto cut = parse_json("{\"a\": [1, 2", "a.json");
    REQUIRE(!cut);
    CHECK(codes_of(cut) == "json_syntax 1:12\n");
    CHECK_THAT(cut.error().front().hint, Contains("ends too early"));
    const auto more = parse_json("{}}", "a.json");
    REQUIRE(!more);
    CHECK(more.error().front().hint.empty()); // nothing is open
    for (const char* open : {"[tr", "[1e", "\"abc", "[1 /* c", "{\"a\":", "-"})
        CHECK_THAT(parse_json(open, "a.json").error().front().hint, Contains("ends too early"));
    const auto big = parse_json("1e999", "a.json");
    REQUIRE(!big);
    CHECK(big.error().front().message.find("json.exception") == std::string::npos);
    CHECK(codes_of(parse_json("", "a.json")) == "json_syntax 1:1\n");
}

TEST_CASE("a text may nest 100 deep and no deeper", "[core][json]")
{
    CHECK(parse_json(std::string(100, '[') + std::string(100, ']'), "a.json"));
    CHECK(codes_of(parse_json(std::string(101, '[') + std::string(101, ']'), "a.json")) == "json_depth 1:101\n");
    CHECK(codes_of(parse_json(std::string(1000000, '['), "a.json")) == "json_depth 1:101\n");
}

TEST_CASE("a text cut off anywhere is one located error", "[core][json]")
{
    const std::string whole = "// c\n{ \"a\": [1, -2.5e3, true, null], \"\\u00e4\": \"\xc3\xa4\", /* b */ \"c\": { \"d\": {} } }";
    REQUIRE(parse_json(whole, "a.json"));
    for (size_t length = 0; length < whole.size(); ++length) {
        INFO(length);
        const auto json = parse_json(std::string_view(whole).substr(0, length), "a.json");
        REQUIRE(!json);
        REQUIRE(json.error().size() == 1);
        CHECK(json.error().front().code == "json_syntax");
        CHECK(json.error().front().where.line >= 1);
        CHECK(json.error().front().where.line <= 2);
    }
}

TEST_CASE("a text with any one byte replaced is read or refused", "[core][json]")
{
    const std::string whole = "{ \"a\": [1, -2.5e3, true], // c\n \"b\": \"\\u00e4\" }";
    for (size_t at = 0; at < whole.size(); ++at) {
        for (const char c : {'\0', '"', '{', ']', '\\', '\xff', '/', '9', ',', '\n'}) {
            std::string broken = whole;
            broken[at] = c;
            const auto json = parse_json(broken, "a.json");
            if (json)
                continue;
            INFO(fmt::format("byte {} as {}", at, static_cast<int>(c)));
            REQUIRE(!json.error().empty());
            CHECK(json.error().front().where.line >= 1);
            CHECK(json.error().front().where.column >= 1);
        }
    }
}
