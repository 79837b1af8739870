// A small validator of JSON against a schema.
#include "schema.hpp"

#include <algorithm>

#include "support/catch.hpp"

namespace passgraph::test {
namespace {

bool equals(const Json& a, const Json& b)
{
    return a.kind == b.kind && a.string == b.string && a.number == b.number && a.boolean == b.boolean;
}

bool has_type(const Json& value, const std::string& type)
{
    if (type == "integer")
        return value.is(Json::Kind::number) && value.is_integer;
    return (type == "object" && value.is(Json::Kind::object)) || (type == "array" && value.is(Json::Kind::array)) ||
           (type == "string" && value.is(Json::Kind::string)) || (type == "number" && value.is(Json::Kind::number)) ||
           (type == "boolean" && value.is(Json::Kind::boolean)) || (type == "null" && value.is(Json::Kind::null));
}

class Validator {
public:
    explicit Validator(const Json& root) : root_(root) {}

    void check(const Json& value, const Json& schema, const std::string& place)
    {
        for (const Json::Member& rule : schema.members)
            check_rule(value, schema, rule, place);
    }

    std::vector<std::string> found;

private:
    void expect(bool is_right, const std::string& place, const std::string& what)
    {
        if (!is_right)
            found.push_back(place + ": " + what);
    }

    void check_rule(const Json& value, const Json& schema, const Json::Member& rule, const std::string& place)
    {
        const std::string& key = rule.key;
        const Json& wanted = rule.value;
        const double length = static_cast<double>(value.array.size());
        if (key == "$ref")
            check(value, definition(wanted.string), place);
        else if (key == "type")
            expect(has_type(value, wanted.string), place, "expected " + wanted.string);
        else if (key == "const")
            expect(equals(value, wanted), place, "is not the constant");
        else if (key == "enum")
            expect(std::any_of(wanted.array.begin(), wanted.array.end(), [&](const Json& item) { return equals(value, item); }), place,
                   "`" + value.string + "` is none of the items");
        else if (key == "required")
            for (const Json& name : wanted.array)
                expect(value.find(name.string) != nullptr, place, "lacks " + name.string);
        else if (key == "minItems" || key == "maxItems")
            expect(!value.is(Json::Kind::array) || (key == "minItems" ? length >= wanted.number : length <= wanted.number), place, key);
        else if (key == "minimum" || key == "maximum")
            expect(key == "minimum" ? value.number >= wanted.number : value.number <= wanted.number, place, key);
        else if (key == "items")
            for (size_t i = 0; i < value.array.size(); ++i)
                check(value.array[i], wanted, place + "[" + std::to_string(i) + "]");
        else if (key == "additionalProperties")
            check_members(value, schema, wanted, place);
        else if (key == "oneOf")
            check_alternatives(value, wanted, place);
        else
            expect(key == "title" || key == "description" || key == "$schema" || key == "$defs" || key == "properties", place,
                   "the validator does not know the rule " + key);
    }

    void check_members(const Json& value, const Json& schema, const Json& others, const std::string& place)
    {
        const Json* known = schema.find("properties");
        for (const Json::Member& member : value.members) {
            const Json* rules = known != nullptr ? known->find(member.key) : nullptr;
            if (rules == nullptr && others.is(Json::Kind::boolean))
                expect(others.boolean, place, "has the unknown member " + member.key);
            else
                check(member.value, rules != nullptr ? *rules : others, place + "." + member.key);
        }
    }

    void check_alternatives(const Json& value, const Json& alternatives, const std::string& place)
    {
        const auto fits = [&](const Json& alternative) {
            Validator inner(root_);
            inner.check(value, alternative, place);
            return inner.found.empty();
        };
        const auto count = std::count_if(alternatives.array.begin(), alternatives.array.end(), fits);
        expect(count == 1, place, "fits " + std::to_string(count) + " alternatives");
    }

    const Json& definition(const std::string& reference) const
    {
        const std::string start = "#/$defs/";
        REQUIRE(reference.rfind(start, 0) == 0);
        const Json* definitions = root_.find("$defs");
        REQUIRE(definitions != nullptr);
        const Json* found_definition = definitions->find(reference.substr(start.size()));
        REQUIRE(found_definition != nullptr);
        return *found_definition;
    }

    const Json& root_;
};

} // namespace

std::vector<std::string> find_schema_violations(const Json& value, const Json& schema)
{
    Validator validator(schema);
    validator.check(value, schema, "$");
    return validator.found;
}

Json read_schema(const std::string& path)
{
    const std::string file = std::string(PASSGRAPH_SOURCE_DIR) + "/" + path;
    auto json = parse_json(read_text_file(file).value(), file);
    REQUIRE(json);
    return *json;
}

} // namespace passgraph::test
