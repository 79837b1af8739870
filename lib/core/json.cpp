// A located JSON reader on nlohmann's SAX parser.
#include "passgraph/core/json.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace passgraph {
namespace {

constexpr size_t kDeepest = 100;

/// Counts what the parser has consumed: the only way to learn where a SAX event happened.
struct CountingIterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    const char* at;
    const char** reached;

    reference operator*() const { return *at; }
    CountingIterator& operator++()
    {
        ++at;
        *reached = at;
        return *this;
    }
    CountingIterator operator++(int)
    {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at == b.at; }
    friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return a.at != b.at; }
};

class LocatedReader : public nlohmann::json_sax<nlohmann::json> {
public:
    LocatedReader(std::string_view text, const std::string& file, int line, int column)
        : text_(text), file_(file), line_(line), column_(column), seen_(text.data()), reached(text.data())
    {
    }

    bool null() override { return add({}); }
    bool boolean(bool value) override
    {
        Json json{.kind = Json::Kind::boolean};
        json.boolean = value;
        return add(std::move(json));
    }
    bool number_integer(number_integer_t value) override { return add_number(static_cast<double>(value), true); }
    bool number_unsigned(number_unsigned_t value) override { return add_number(static_cast<double>(value), true); }
    bool number_float(number_float_t value, const string_t&) override { return add_number(value, false); }
    bool string(string_t& value) override
    {
        Json json{.kind = Json::Kind::string};
        json.string = std::move(value);
        return add(std::move(json));
    }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(Json::Kind::object); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(Json::Kind::array); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override
    {
        Location where = token_start();
        auto& members = open_.back()->members;
        const auto same = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.key == name; });
        if (same != members.end()) {
            errors.push_back({"json_duplicate_key", fmt::format("the key `{}` stands twice", name),
                              fmt::format("it stands first at line {}; rename or remove one", same->where.line),
                              where});
        }
        members.push_back({name, where, {}});
        return true;
    }

    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& problem) override
    {
        // nlohmann's text is "[json.exception.parse_error.101] parse error at line 1, column 2: what"; we have the place.
        std::string what = problem.what();
        if (const size_t name = what.find("] "); name != std::string::npos)
            what = what.substr(name + 2);
        if (const size_t colon = what.find(": "); colon != std::string::npos)
            what = what.substr(colon + 2);
        const auto says = [&](const char* words) { return what.find(words) != std::string::npos; };
        const bool is_separator = says("unexpected ','") || says("unexpected ':'");
        Location where = is_separator ? position(reached - 1) : token_start();
        const bool is_cut_off = says("unexpected end of input") || (says("invalid") && is_begun(rest()));
        if (is_cut_off)
            where = position(text_.data() + text_.size());
        errors.push_back({"json_syntax", what, is_cut_off ? "the text ends too early: close what is open" : "", where});
        return false;
    }

    Json root;
    Errors errors;

private:
    Location position(const char* place)
    {
        for (; seen_ < place; ++seen_) {
            if (*seen_ == '\n') {
                ++line_;
                column_ = 1;
            } else {
                ++column_;
            }
        }
        return {file_, line_, column_};
    }

    std::string_view rest() const { return text_.substr(static_cast<size_t>(seen_ - text_.data())); }

    /// True when more text could make a token of it.
    static bool is_begun(std::string_view token)
    {
        const auto begins = [&](std::string_view word) { return word.starts_with(token); };
        const bool is_number = token.find_first_not_of("+-.eE0123456789") == std::string_view::npos;
        const bool is_string = token.starts_with('"') && token.find_first_of("\"\n", 1) == std::string_view::npos;
        const bool is_comment = token.starts_with("/*") && token.find("*/", 2) == std::string_view::npos;
        return begins("true") || begins("false") || begins("null") || begins("/*") || is_number || is_string ||
               is_comment;
    }

    /// Between two tokens stand only blanks, commas, colons and comments: skip them from the last token's end.
    Location token_start()
    {
        const char* end = text_.data() + text_.size();
        const char* place = last_end_ ? last_end_ : text_.data();
        while (place < end) {
            if (place + 1 < end && place[0] == '/' && place[1] == '/') {
                while (place < end && *place != '\n')
                    ++place;
            } else if (place + 1 < end && place[0] == '/' && place[1] == '*') {
                const size_t stop = text_.find("*/", static_cast<size_t>(place - text_.data()) + 2);
                place = stop == std::string_view::npos ? end : text_.data() + stop + 2;
            } else if (std::string_view(" \t\r\n,:").find(*place) != std::string_view::npos) {
                ++place;
            } else {
                break;
            }
        }
        last_end_ = reached;
        // To see where a number ends, the parser has read one character more, which may begin a comment.
        const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
        if (place < end && (*place == '-' || is_digit(*place)) && !(reached == end && is_digit(end[-1])))
            last_end_ = reached - 1;
        return position(place);
    }

    Json& place_for_value()
    {
        if (open_.empty())
            return root;
        Json& parent = *open_.back();
        if (parent.kind == Json::Kind::object)
            return parent.members.back().value;
        return parent.array.emplace_back();
    }

    bool add(Json json)
    {
        json.where = token_start();
        place_for_value() = std::move(json);
        return true;
    }

    bool add_number(double value, bool is_integer)
    {
        Json json{.kind = Json::Kind::number};
        json.number = value;
        json.is_integer = is_integer;
        return add(std::move(json));
    }

    bool open(Json::Kind kind)
    {
        Location where = token_start();
        if (open_.size() >= kDeepest) {
            errors.push_back(
                {"json_depth", fmt::format("more than {} values inside one another", kDeepest), "", where});
            return false;
        }
        Json& value = place_for_value();
        value.kind = kind;
        value.where = std::move(where);
        open_.push_back(&value); // stable: a parent does not grow while a child is open
        return true;
    }

    bool close()
    {
        last_end_ = reached;
        open_.pop_back();
        return true;
    }

    std::string_view text_;
    std::string file_;
    int line_;
    int column_;
    const char* seen_;
    const char* last_end_ = nullptr;
    std::vector<Json*> open_;

public:
    const char* reached;
};

} // namespace

const Json* Json::find(std::string_view key) const
{
    for (const Member& member : members)
        if (member.key == key)
            return &member.value;
    return nullptr;
}

std::string_view kind_name(Json::Kind kind)
{
    switch (kind) {
    case Json::Kind::null:
        return "null";
    case Json::Kind::boolean:
        return "true or false";
    case Json::Kind::number:
        return "a number";
    case Json::Kind::string:
        return "a string";
    case Json::Kind::array:
        return "an array";
    case Json::Kind::object:
        return "an object";
    }
    return "";
}

Result<Json> parse_json(std::string_view text, const std::string& file, int first_line, int first_column)
{
    LocatedReader reader(text, file, first_line, first_column);
    const CountingIterator first{text.data(), &reader.reached};
    const CountingIterator last{text.data() + text.size(), &reader.reached};
    constexpr bool kWholeText = true;
    constexpr bool kComments = true;
    const bool done =
        nlohmann::json::sax_parse(first, last, &reader, nlohmann::json::input_format_t::json, kWholeText, kComments);
    if (!done || !reader.errors.empty())
        return tl::unexpected(std::move(reader.errors));
    return std::move(reader.root);
}

Result<std::string> read_text_file(const std::string& path)
{
    std::error_code code;
    if (!std::filesystem::exists(path, code))
        return fail({"file_missing", "there is no such file", "check the path", {path}});
    if (std::filesystem::is_directory(path, code))
        return fail({"file_unreadable", "this is a folder, not a file", "name a file in it", {path}});
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream)
        return fail({"file_unreadable", "the file cannot be read", "check its permissions", {path}});
    return text.str();
}

void report_wrong_type(const Json& value, std::string_view what, std::string_view expected, Errors& errors)
{
    errors.push_back(
        {"wrong_type", fmt::format("{}: expected {}, got {}", what, expected, kind_name(value.kind)), "", value.where});
}

JsonFields::JsonFields(const Json& object, std::string what, Errors& errors)
    : object_(object), what_(std::move(what)), errors_(errors)
{
    if (!object.is(Json::Kind::object))
        report_wrong_type(object, what_, "an object", errors);
}

const Json* JsonFields::find(std::string_view key)
{
    if (std::find(known_.begin(), known_.end(), key) == known_.end())
        known_.emplace_back(key);
    return object_.find(key);
}

const Json* JsonFields::require(std::string_view key)
{
    const Json* value = find(key);
    if (!value && object_.is(Json::Kind::object))
        errors_.push_back({"field_missing", fmt::format("{} lacks \"{}\"", what_, key), "", object_.where});
    return value;
}

const Json* JsonFields::find(std::string_view key, Json::Kind kind)
{
    const Json* value = find(key);
    if (value && !value->is(kind)) {
        report_wrong_type(*value, fmt::format("{}: \"{}\"", what_, key), kind_name(kind), errors_);
        return nullptr;
    }
    return value;
}

const Json* JsonFields::require(std::string_view key, Json::Kind kind)
{
    return require(key) ? find(key, kind) : nullptr;
}

std::string JsonFields::text(std::string_view key, std::string fallback)
{
    const Json* value = find(key, Json::Kind::string);
    return value ? value->string : fallback;
}

double JsonFields::number(std::string_view key, double fallback)
{
    const Json* value = find(key, Json::Kind::number);
    return value ? value->number : fallback;
}

bool JsonFields::boolean(std::string_view key, bool fallback)
{
    const Json* value = find(key, Json::Kind::boolean);
    return value ? value->boolean : fallback;
}

bool JsonFields::numbers(std::string_view key, size_t count, float* out)
{
    std::vector<double> exact(count);
    if (!numbers(key, count, exact.data()))
        return false;
    std::transform(exact.begin(), exact.end(), out, [](double number) { return static_cast<float>(number); });
    return true;
}

bool JsonFields::numbers(std::string_view key, size_t count, double* out)
{
    const Json* value = find(key, Json::Kind::array);
    if (!value)
        return false;
    bool fits = value->array.size() == count;
    for (const Json& item : value->array)
        fits = fits && item.is(Json::Kind::number) && std::isfinite(static_cast<float>(item.number));
    if (!fits) {
        errors_.push_back(
            {"wrong_type", fmt::format("{}: \"{}\" wants {} finite numbers", what_, key, count), "", value->where});
        return false;
    }
    std::transform(value->array.begin(), value->array.end(), out, [](const Json& item) { return item.number; });
    return true;
}

void JsonFields::finish()
{
    for (const Json::Member& member : object_.members) {
        if (std::find(known_.begin(), known_.end(), member.key) == known_.end()) {
            errors_.push_back({"unknown_field", fmt::format("{} has no field \"{}\"", what_, member.key),
                               suggest(member.key, known_, "fields"), member.where});
        }
    }
}

} // namespace passgraph
