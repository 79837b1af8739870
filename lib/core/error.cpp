// How errors read, and the nearest name for a mistyped one.
#include "passgraph/core/error.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace passgraph {

std::string to_text(const Error& error)
{
    std::string text;
    if (!error.where.file.empty()) {
        text += error.where.file + ":";
        if (error.where.line > 0)
            text += fmt::format("{}:", error.where.line);
        if (error.where.line > 0 && error.where.column > 0)
            text += fmt::format("{}:", error.where.column);
        text += " ";
    }
    text += fmt::format("error[{}] {}", error.code, error.message);
    if (!error.hint.empty())
        text += "\n  hint: " + error.hint;
    return text;
}

std::string to_text(const Errors& errors)
{
    std::string text;
    for (const Error& error : errors)
        text += to_text(error) + "\n";
    return text;
}

void append(Errors& errors, const Errors& more) { errors.insert(errors.end(), more.begin(), more.end()); }

tl::unexpected<Errors> fail(Error error)
{
    Errors errors;
    errors.push_back(std::move(error));
    return tl::unexpected<Errors>(std::move(errors));
}

namespace {

size_t edit_distance(std::string_view a, std::string_view b)
{
    const size_t width = b.size() + 1;
    std::vector<size_t> table((a.size() + 1) * width);
    const auto at = [&](size_t i, size_t j) -> size_t& { return table[i * width + j]; };
    for (size_t i = 0; i <= a.size(); ++i)
        at(i, 0) = i;
    for (size_t j = 0; j <= b.size(); ++j)
        at(0, j) = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t changed = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, changed});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return at(a.size(), b.size());
}

} // namespace

std::string closest(std::string_view name, const std::vector<std::string>& candidates)
{
    // A third of the letters may be wrong; a name that is merely short is no match for everything.
    size_t best = std::max<size_t>(1, name.size() / 3) + 1;
    std::string found;
    if (name.size() > 100)
        return found;
    for (const std::string& candidate : candidates) {
        const size_t distance = edit_distance(name, candidate);
        if (distance < best) {
            best = distance;
            found = candidate;
        }
    }
    return found;
}

std::string suggest(std::string_view name, const std::vector<std::string>& candidates, std::string_view what)
{
    if (const std::string near = closest(name, candidates); !near.empty())
        return fmt::format("did you mean `{}`?", near);
    if (candidates.empty())
        return fmt::format("there are no {}", what);
    return fmt::format("the {} are: {}", what, fmt::join(candidates, ", "));
}

} // namespace passgraph
