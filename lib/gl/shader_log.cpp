// Reads the logs of GLSL compilers.
#include "gl/shader_log.hpp"

#include <charconv>
#include <cstdio>
#include <optional>

#include <fmt/format.h>

namespace passgraph::gl {
namespace {

struct Complaint {
    int line = 0;
    int column = 0;
    std::string_view text;
};

std::string_view trimmed(std::string_view text)
{
    const size_t first = text.find_first_not_of(" \t\r\n");
    const size_t last = text.find_last_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view{} : text.substr(first, last - first + 1);
}

/// The lines of a text, one by one, without their ends.
std::vector<std::string_view> lines_of(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

std::optional<Complaint> read_complaint(std::string_view line)
{
    const std::string copy(line);
    int source = 0;
    int end = 0;
    Complaint found;
    const auto matches = [&](bool is_match) { return is_match && end > 0; };
    if (matches(std::sscanf(copy.c_str(), "%d:%d(%d): error: %n", &source, &found.line, &found.column, &end) == 3) ||
        matches(std::sscanf(copy.c_str(), "%d(%d) : error %n", &source, &found.line, &end) == 2) ||
        matches(std::sscanf(copy.c_str(), "ERROR: %d:%d: %n", &source, &found.line, &end) == 2)) {
        found.text = trimmed(line.substr(static_cast<size_t>(end)));
        return found;
    }
    return std::nullopt;
}

/// `#line 12 3`: both numbers, or nothing.
std::optional<std::pair<int, int>> read_line_directive(std::string_view line)
{
    int number = 0;
    int source = 0;
    if (std::sscanf(std::string(line).c_str(), " # line %d %d", &number, &source) != 2)
        return std::nullopt;
    return std::pair(number, source);
}

} // namespace

std::string folded_source_numbers(std::string_view glsl)
{
    std::string folded;
    folded.reserve(glsl.size());
    for (const std::string_view line : lines_of(glsl)) {
        if (const auto directive = read_line_directive(line))
            folded += fmt::format("#line {}\n", directive->first + directive->second * kSourceStride);
        else
            folded += fmt::format("{}\n", line);
    }
    return folded;
}

Errors shader_errors(std::string_view log, std::string_view subject, const std::vector<std::string>& sources)
{
    Errors errors;
    int last_line = -1;
    for (const std::string_view line : lines_of(log)) {
        const std::optional<Complaint> complaint = read_complaint(line);
        if (!complaint || complaint->line == last_line)
            continue;
        last_line = complaint->line;
        Error error{.code = "shader_failed",
                    .message = fmt::format("{}: {}", subject, complaint->text),
                    .hint = "`passgraph plan --glsl` shows what the driver was given"};
        const size_t source = static_cast<size_t>(complaint->line / kSourceStride);
        if (source < sources.size())
            error.where = {sources[source], complaint->line % kSourceStride, complaint->column};
        errors.push_back(std::move(error));
    }
    if (errors.empty())
        errors.push_back({.code = "shader_failed", .message = fmt::format("{}: {}", subject, trimmed(log))});
    return errors;
}

} // namespace passgraph::gl
