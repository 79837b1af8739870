// JSON whose every value knows its line and column, and in which a key stands once.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <passgraph/core/error.hpp>

namespace passgraph {

/// One value of a JSON document, with the place where it starts.
///
/// Members keep the file's order. A plain struct: readers look at `kind` and take the part that it names.
struct Json {
    enum class Kind { null, boolean, number, string, array, object };
    struct Member;

    Kind kind = Kind::null;
    bool boolean = false;
    double number = 0.0;
    bool is_integer = false;
    std::string string{};
    std::vector<Json> array{};
    std::vector<Member> members{};
    Location where{};

    bool is(Kind wanted) const { return kind == wanted; }

    /// The member called `key`, or nullptr. O(members).
    const Json* find(std::string_view key) const;
};

struct Json::Member {
    std::string key;
    Location where; ///< of the key
    Json value;
};

/// "an object", "a number", …: for messages.
std::string_view kind_name(Json::Kind kind);

/// Reads a JSON text; `//` comments are allowed.
///
/// Errors   json_syntax (then nothing more can be found), json_duplicate_key (each), json_depth (over 100 levels).
///          Positions count lines and bytes from 1, `first_line` being the number of the text's first line.
/// Cost     one pass; memory about ten times the text.
Result<Json> parse_json(std::string_view text, const std::string& file, int first_line = 1, int first_column = 1);

/// The whole file as text. Errors: file_missing, file_unreadable.
Result<std::string> read_text_file(const std::string& path);

/// Collects the mistakes of a JSON object while its members are read by name.
///
/// Each getter reports wrong_type where the member has another type; `finish` reports each member that nobody
/// asked for as unknown_field.
class JsonFields {
public:
    /// `what` names the object in messages ("pass header", "light"). Reports wrong_type if `object` is none.
    JsonFields(const Json& object, std::string what, Errors& errors);

    const Json* find(std::string_view key);                     ///< any type
    const Json* require(std::string_view key);                  ///< field_missing when absent
    const Json* find(std::string_view key, Json::Kind kind);    ///< wrong_type when of another kind
    const Json* require(std::string_view key, Json::Kind kind); ///< both
    std::string text(std::string_view key, std::string fallback = "");
    double number(std::string_view key, double fallback);
    bool boolean(std::string_view key, bool fallback);
    /// An array of exactly `count` numbers that a float can hold into `out`, which is left alone when absent or wrong.
    /// False: absent or wrong.
    bool numbers(std::string_view key, size_t count, float* out);
    bool numbers(std::string_view key, size_t count, double* out); ///< the same without the rounding to float

    /// Reports members that were never asked for.
    void finish();

private:
    const Json& object_;
    std::string what_;
    Errors& errors_;
    std::vector<std::string> known_;
};

/// Reports wrong_type at `value`.
void report_wrong_type(const Json& value, std::string_view what, std::string_view expected, Errors& errors);

} // namespace passgraph
