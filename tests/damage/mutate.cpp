// Random damage, and what an error must say whatever the damage was.
#include "damage/mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "support/catch.hpp"

namespace passgraph::test {
namespace {

struct Piece {
    size_t start = 0;
    size_t length = 0;
};

size_t below(size_t count, Random& random)
{
    return count == 0 ? 0 : random() % count;
}

Piece any_piece(const std::string& text, Random& random)
{
    const size_t start = below(text.size(), random);
    return {start, std::min(text.size() - start, 1 + below(40, random))};
}

/// Where the words, numbers and strings of a text stand.
std::vector<Piece> tokens_of(const std::string& text)
{
    std::vector<Piece> tokens;
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '-'; };
    for (size_t i = 0; i < text.size(); ++i) {
        if (!is_part(text[i]))
            continue;
        size_t end = i;
        while (end < text.size() && is_part(text[end]))
            ++end;
        tokens.push_back({i, end - i});
        i = end;
    }
    return tokens;
}

std::string with(std::string text, Piece piece, const std::string& replacement)
{
    return text.replace(piece.start, piece.length, replacement);
}

constexpr std::array<const char*, 24> kExtremes = {
    "0",    "-0",   "-1",  "1e308", "-1e39", "1e-320", "4294967296", "18446744073709551616", "2147483648", "1e999",
    "0.5",  "null", "true", "\"\"",  "[]",    "{}",     "\"a.b.c\"",  "\"\\u0000\"",          "[[[[1]]]]",  "16777217",
    "9e99", "1.",   "nan", "\xff\xfe"};

std::string replace_token(const std::string& text, Random& random)
{
    const std::vector<Piece> tokens = tokens_of(text);
    if (tokens.empty())
        return text;
    const Piece one = tokens[below(tokens.size(), random)];
    if (random() % 2 == 0)
        return with(text, one, kExtremes[below(kExtremes.size(), random)]);
    const Piece other = tokens[below(tokens.size(), random)];
    return with(text, one, text.substr(other.start, other.length));
}

std::string move_piece(std::string text, Random& random)
{
    const Piece piece = any_piece(text, random);
    const std::string moved = text.substr(piece.start, piece.length);
    if (random() % 2 == 0)
        text.erase(piece.start, piece.length); // else it is doubled
    return text.insert(below(text.size() + 1, random), moved);
}

std::string lose_bracket(std::string text, Random& random)
{
    const size_t found = text.find_first_of("{}[](),:\"", below(text.size(), random));
    return found == std::string::npos ? text : text.erase(found, 1);
}

std::string nest(std::string text, Random& random)
{
    const size_t depth = random() % 2 ? 1000 : 90;
    const std::vector<Piece> tokens = tokens_of(text);
    if (tokens.empty())
        return text;
    return with(text, tokens[below(tokens.size(), random)], std::string(depth, '[') + "1" + std::string(depth, ']'));
}

} // namespace

std::string damaged_text(std::string text, Random& random)
{
    if (text.empty())
        return text;
    switch (random() % 12) {
    case 0: return with(text, any_piece(text, random), "");
    case 1: return move_piece(std::move(text), random);
    case 2: return lose_bracket(std::move(text), random);
    case 3: return random() % 4 ? text.substr(0, below(text.size(), random)) : nest(std::move(text), random);
    case 4: text[below(text.size(), random)] = static_cast<char>(random()); return text;
    default: return replace_token(text, random); // mostly a file whose form is right, so that its meaning is tried
    }
}

std::string damaged_bytes(std::string bytes, Random& random)
{
    if (bytes.size() < 8)
        return bytes;
    const size_t at = below(bytes.size() - 4, random);
    switch (random() % 8) {
    case 0: return with(bytes, any_piece(bytes, random), "");
    case 1: return move_piece(std::move(bytes), random);
    case 2: return bytes.substr(0, at);
    case 3: return bytes.replace(at, 4, std::string_view("\xff\xff\xff\x7f", 4));
    case 4: return bytes.replace(at, 4, std::string_view("\0\0\0\0", 4));
    default: bytes[at] = static_cast<char>(random()); return bytes;
    }
}

void check_errors(const Errors& errors, std::string_view text, const std::string& file)
{
    if (errors.empty())
        FAIL("a failure without an error");
    for (const Error& error : errors) {
        const std::string said = to_text(error);
        if (error.code.empty() || error.message.empty())
            FAIL("an error without code or message: " << said);
        if (error.where.file != file || error.where.line == 0)
            continue;
        size_t start = 0;
        for (int line = 1; line < error.where.line && start != std::string_view::npos; ++line) {
            const size_t end = text.find('\n', start);
            start = end == std::string_view::npos ? end : end + 1;
        }
        if (start == std::string_view::npos)
            FAIL("a line that the file does not have: " << said);
        const size_t end = std::min(text.find('\n', start), text.size());
        if (error.where.column < 0 || static_cast<size_t>(error.where.column) > end - start + 1)
            FAIL("a column that the line does not have: " << said);
    }
}

} // namespace passgraph::test
