// What can go wrong, as values: every mistake of a file at once, each with its place and the fix.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace passgraph {

/// A place in a text file. `line` and `column` count from 1; 0 means "not known".
struct Location {
    std::string file{};
    int line = 0;
    int column = 0;

    friend bool operator==(const Location&, const Location&) = default;
};

/// Who can mend it: the user (their file, name or value) or the machine's owner (a missing library, a limit).
enum class Fault { user, machine };

/// One mistake: `file:line:column: error[code] message`, then `  hint: ...`.
///
/// `code` is a stable identifier such as `signal_mismatch`; tests and tools may rely on it.
struct Error {
    std::string code;
    std::string message;
    std::string hint{};
    Location where{};
    Fault fault = Fault::user;
};

using Errors = std::vector<Error>;

/// Either a value or every mistake that was found.
template <class T>
using Result = tl::expected<T, Errors>;

/// The error in the form every program of passgraph prints, without a final newline.
std::string to_text(const Error& error);

/// All errors, one after another, each ended by a newline.
std::string to_text(const Errors& errors);

/// Adds `more` behind `errors`.
void append(Errors& errors, const Errors& more);

/// A failed result holding one error.
tl::unexpected<Errors> fail(Error error);

/// The candidate closest to `name` by edit distance, or "" when none is near enough to be a typing mistake.
///
/// Cost     O(candidates * length^2).
/// Source   Damerau 1964, restricted edit distance.
std::string closest(std::string_view name, const std::vector<std::string>& candidates);

/// "did you mean `x`?" when a candidate is near, else "`what` are: a, b, c".
std::string suggest(std::string_view name, const std::vector<std::string>& candidates, std::string_view what);

} // namespace passgraph
