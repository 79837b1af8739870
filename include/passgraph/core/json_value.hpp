// A JSON value that is written. Its text is nlohmann's; that library, one large template, is compiled in two files of core alone.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace passgraph {

/// Members keep the order in which they were added.
///
/// Braces mean what they mean to nlohmann: `{{"a", 1}, {"b", 2}}`, pairs that each begin with a text, are an object; every other list is an
/// array. `JsonValue::array({"a", 1})` is always one.
class JsonValue {
public:
    JsonValue() = default; ///< null
    JsonValue(std::nullptr_t) {}
    JsonValue(std::same_as<bool> auto boolean) : value_(boolean) {}
    JsonValue(std::signed_integral auto number) : value_(static_cast<std::int64_t>(number)) {}
    JsonValue(std::unsigned_integral auto number)
        requires(!std::same_as<decltype(number), bool>)
        : value_(static_cast<std::uint64_t>(number))
    {
    }
    JsonValue(std::floating_point auto number) : value_(static_cast<double>(number)) {}
    JsonValue(const char* text) : value_(std::string(text)) {}
    JsonValue(std::string_view text) : value_(std::string(text)) {}
    JsonValue(const std::string& text) : value_(text) {}
    JsonValue(std::initializer_list<JsonValue> list);
    template <class Range>
        requires requires(const Range& range) { JsonValue(*range.begin()); range.end(); }
    JsonValue(const Range& range) : value_(Array(range.begin(), range.end()))
    {
    }

    static JsonValue array(std::initializer_list<JsonValue> elements = {});
    static JsonValue object();

    /// The member called `key`, which is added as null where there is none; null becomes an object.
    JsonValue& operator[](std::string_view key);
    /// Null becomes an array.
    void push_back(JsonValue element);
    const JsonValue& front() const;
    JsonValue& back();
    /// Sets all members of `other`, an object.
    void update(const JsonValue& other);

    /// On one line where `indent` is negative. What is not UTF-8 is replaced, as JSON has no other encoding; numbers that are not finite are null.
    std::string text(int indent = -1) const;

private:
    struct Writer;
    using Array = std::vector<JsonValue>;
    using Members = std::vector<std::pair<std::string, JsonValue>>;

    std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Members> value_;
};

} // namespace passgraph
