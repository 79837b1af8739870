// Edits of a JSON text at the places where its values stand.
#include "tool/view/graph_edit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <passgraph/core/json.hpp>

#include "tool/preset.hpp"

namespace passgraph::tool::view {
namespace {

struct Edit {
    size_t start = 0;
    size_t end = 0;
    std::string text;
};

/// A JSON text whose values can be found by their place.
class Text {
public:
    explicit Text(const std::string& text) : text_(text)
    {
        lines_.push_back(0);
        for (size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n')
                lines_.push_back(i + 1);
    }

    size_t start_of(const Json& value) const
    {
        return lines_[static_cast<size_t>(value.where.line) - 1] + static_cast<size_t>(value.where.column) - 1;
    }

    /// Behind the value's last letter. The text was parsed: brackets match, and strings end.
    size_t end_of(const Json& value) const
    {
        size_t at = start_of(value);
        if (value.is(Json::Kind::string))
            return end_of_string(at);
        if (!value.is(Json::Kind::object) && !value.is(Json::Kind::array))
            return std::min(text_.find_first_of(",]} \t\r\n/", at), text_.size());
        int depth = 0;
        for (;; ++at) {
            const char c = text_[at];
            if (c == '"')
                at = end_of_string(at) - 1;
            else if (c == '/' && text_.compare(at, 2, "//") == 0)
                at = text_.find('\n', at);
            else if (c == '{' || c == '[')
                ++depth;
            else if ((c == '}' || c == ']') && --depth == 0)
                return at + 1;
        }
    }

private:
    size_t end_of_string(size_t at) const
    {
        for (++at; text_[at] != '"'; ++at)
            if (text_[at] == '\\')
                ++at;
        return at + 1;
    }

    const std::string& text_;
    std::vector<size_t> lines_;
};

/// A member added behind the last one of an object.
Edit added(const Text& text, const Json& object, const std::string& member)
{
    if (object.members.empty()) {
        const size_t inside = text.start_of(object) + 1;
        return {inside, inside, " " + member + " "};
    }
    const size_t behind = text.end_of(object.members.back().value);
    return {behind, behind, ", " + member};
}

/// "params", "choices" or "rungs"; "" when the pass has no such setting.
std::string member_of(const PassDeclaration& pass, const std::string& setting)
{
    if (pass.find_param(setting) >= 0)
        return "params";
    const int selection = pass.find_selection(setting);
    if (selection < 0)
        return "";
    return pass.selections[static_cast<size_t>(selection)].kind == Selection::Kind::ladder ? "rungs" : "choices";
}

const GraphDescription::Pass* find_pass(const GraphDescription& description, const std::string& name)
{
    const auto found = std::find_if(description.passes.begin(), description.passes.end(),
                                    [&](const auto& pass) { return pass.name == name; });
    return found == description.passes.end() ? nullptr : &*found;
}

/// New members of one pass that go into one object which the file lacks yet are collected, to be added at once.
struct Additions {
    const Json* pass = nullptr;
    std::map<std::string, std::string> members; ///< "params" -> the settings
};

} // namespace

Result<std::string> with_settings(const std::string& text, const std::string& file, const Settings& settings,
                                  const GraphDescription& description, const PassLibrary& library)
{
    const Result<Json> json = parse_json(text, file);
    if (!json)
        return tl::unexpected(json.error());
    const Text places(text);
    std::vector<Edit> edits;
    std::map<std::string, Additions> additions;
    Errors errors;
    for (const auto& [place, setting] : settings) {
        const size_t dot = place.rfind('.');
        const std::string name = place.substr(0, dot);
        const std::string key = dot == std::string::npos ? "" : place.substr(dot + 1);
        const Json* passes = json->find("passes");
        const Json* pass = passes ? passes->find(name) : nullptr;
        const GraphDescription::Pass* use = find_pass(description, name);
        const PassPtr declaration = use ? library.find(use->pass.text) : nullptr;
        const std::string member = declaration ? member_of(*declaration, key) : "";
        if (!pass || member.empty()) {
            errors.push_back({.code = pass ? "unknown_param" : "unknown_image",
                              .message = fmt::format("`{}` is no setting of a pass of this file", place),
                              .where = {file}});
            continue;
        }
        const Json* group = nullptr;
        const Json* value = nullptr;
        for (const char* candidate : {"params", "choices", "rungs"}) {
            const Json* found = pass->find(candidate);
            if (found && candidate == member)
                group = found;
            if (found && found->find(key))
                value = found->find(key);
        }
        const std::string pair = fmt::format("\"{}\": {}", key, value_text(setting));
        if (value) {
            edits.push_back({places.start_of(*value), places.end_of(*value), value_text(setting)});
        } else if (group) {
            edits.push_back(added(places, *group, pair));
        } else {
            Additions& addition = additions[name];
            addition.pass = pass;
            std::string& members = addition.members[member];
            members += (members.empty() ? "" : ", ") + pair;
        }
    }
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    for (const auto& [name, addition] : additions)
        for (const auto& [member, pairs] : addition.members)
            edits.push_back(added(places, *addition.pass, fmt::format("\"{}\": {{ {} }}", member, pairs)));
    // From the end, so that places stay right; of equal places the later one first, so that they stand in order.
    std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.start < b.start; });
    std::string edited = text;
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
        edited.replace(edit->start, edit->end - edit->start, edit->text);
    return edited;
}

} // namespace passgraph::tool::view
