// A light reading of GLSL text: tokens with places, global names, forbidden words.
#include "core/pass/glsl_scan.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

namespace passgraph {
namespace {

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

class Scanner {
public:
    Scanner(std::string_view text, int line, int column) : text_(text), line_(line), column_(column) {}

    std::vector<GlslToken> run()
    {
        while (at_ < text_.size()) {
            if (text_.substr(at_, 2) == "//")
                skip_to(text_.find('\n', at_));
            else if (text_.substr(at_, 2) == "/*")
                skip_to(text_.find("*/", at_ + 2) == std::string_view::npos ? text_.size()
                                                                            : text_.find("*/", at_ + 2) + 2);
            else if (std::isspace(static_cast<unsigned char>(text_[at_])))
                skip_to(at_ + 1);
            else
                take_token();
        }
        return std::move(tokens_);
    }

private:
    void skip_to(size_t end)
    {
        for (end = std::min(end, text_.size()); at_ < end; ++at_) {
            if (text_[at_] == '\n') {
                ++line_;
                column_ = 1;
                is_line_start_ = true;
            } else {
                ++column_;
            }
        }
    }

    void take_token()
    {
        GlslToken token;
        token.line = line_;
        token.column = column_;
        size_t end = at_ + 1;
        if (text_[at_] == '#' && is_line_start_) {
            token.is_directive = true;
            end = directive_end();
        } else if (starts_name(text_[at_])) {
            token.is_identifier = true;
            while (end < text_.size() && continues_name(text_[end]))
                ++end;
        } else if (std::isdigit(static_cast<unsigned char>(text_[at_]))) {
            while (end < text_.size() && (continues_name(text_[end]) || text_[end] == '.'))
                ++end;
        }
        token.text = text_.substr(at_, end - at_);
        is_line_start_ = false;
        tokens_.push_back(token);
        skip_to(end);
    }

    size_t directive_end() const
    {
        size_t end = at_;
        while (end < text_.size() && !(text_[end] == '\n' && text_[end - 1] != '\\'))
            ++end;
        return end;
    }

    std::string_view text_;
    size_t at_ = 0;
    int line_;
    int column_;
    bool is_line_start_ = true;
    std::vector<GlslToken> tokens_;
};

void add_once(std::vector<std::string>& names, std::string_view name)
{
    if (std::find(names.begin(), names.end(), name) == names.end())
        names.emplace_back(name);
}

bool is_texture_function(std::string_view name)
{
    static constexpr std::array<std::string_view, 5> kOthers = {"shadow1D", "shadow2D", "imageLoad", "imageStore",
                                                                "imageSize"};
    return name == "texture" || name.starts_with("texelFetch") ||
           (name.starts_with("texture") && name.size() > 7 && std::isupper(static_cast<unsigned char>(name[7]))) ||
           name == "texture2D" || name == "textureCube" ||
           std::find(kOthers.begin(), kOthers.end(), name) != kOthers.end();
}

} // namespace

std::vector<GlslToken> scan_glsl(std::string_view text, int line, int column)
{
    return Scanner(text, line, column).run();
}

std::vector<std::string> global_names(const std::vector<GlslToken>& tokens)
{
    std::vector<std::string> names;
    int depth = 0;
    for (size_t i = 0; i < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "{" || text == "(") {
            ++depth;
        } else if (text == "}" || text == ")") {
            --depth;
        }
        if (depth != 0 || !tokens[i].is_identifier || i == 0)
            continue;
        // At global scope a declared name follows a type and stands before ( = [ ; or ,; a struct's name follows the word.
        const std::string_view next = i + 1 < tokens.size() ? tokens[i + 1].text : "";
        const bool follows_type = tokens[i - 1].is_identifier || tokens[i - 1].text == "]";
        const bool is_declared =
            follows_type && (next == "(" || next == "=" || next == "[" || next == ";" || next == ",");
        const bool is_listed = tokens[i - 1].text == "," && (next == "=" || next == "[" || next == ";" || next == ",");
        if (tokens[i - 1].text == "struct" || is_declared || is_listed)
            add_once(names, text);
    }
    return names;
}

std::vector<std::string> macro_names(const std::vector<GlslToken>& tokens)
{
    std::vector<std::string> names;
    for (const GlslToken& token : tokens) {
        if (!token.is_directive)
            continue;
        const auto words = scan_glsl(token.text.substr(1), token.line, token.column);
        if (words.size() >= 2 && words[0].text == "define")
            add_once(names, words[1].text);
    }
    return names;
}

void report_forbidden(const std::vector<GlslToken>& tokens, const std::string& file, bool is_geometry, Errors& errors)
{
    static constexpr std::array<std::string_view, 10> kDerivatives = {
        "dFdx",       "dFdy",       "fwidth",     "dFdxFine",     "dFdyFine",
        "fwidthFine", "dFdxCoarse", "dFdyCoarse", "fwidthCoarse", "discard"};
    const auto refuse = [&](const GlslToken& token, std::string hint) {
        errors.push_back({"forbidden_builtin",
                          fmt::format("a pass must not use `{}`", token.text),
                          std::move(hint),
                          {file, token.line, token.column}});
    };
    for (size_t i = 0; i < tokens.size(); ++i) {
        const GlslToken& token = tokens[i];
        const bool is_call = i + 1 < tokens.size() && tokens[i + 1].text == "(";
        if (token.is_directive) {
            const auto words = scan_glsl(token.text.substr(1), token.line, token.column);
            if (!words.empty() && (words[0].text == "version" || words[0].text == "extension"))
                refuse({words[0].text, token.line, token.column, true, false},
                       "programs are generated for GLSL 3.30: leave the line out");
        } else if (!token.is_identifier) {
            continue;
        } else if (token.text.starts_with("gl_")) {
            refuse(token, token.text == "gl_FragCoord" ? "pixel() gives the pixel's index"
                                                       : "results are returned, or assigned to out parameters");
        } else if (is_call && is_texture_function(token.text)) {
            refuse(token, "declare an input and call it by its name: image(uv)");
        } else if (token.text == "uniform" || token.text == "layout" || token.text == "varying" ||
                   token.text == "attribute") {
            refuse(token, "parameters and inputs are declared in the header; their GLSL is generated");
        } else if (token.text == "main" && is_call) {
            refuse(token, "the entry function has the pass's name");
        } else if (!is_geometry &&
                   std::find(kDerivatives.begin(), kDerivatives.end(), token.text) != kDerivatives.end()) {
            refuse(token,
                   "a full-screen pass is a function of uv alone: it has no derivatives, and every pixel gets a value");
        }
    }
}

} // namespace passgraph
