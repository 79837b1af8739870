// Reads the layouts of a geometry pass: what it draws into, and where each output stands there.
#include <algorithm>

#include <fmt/format.h>

#include "core/pass/header_fields.hpp"

namespace passgraph::header {
namespace {

std::string_view trimmed(std::string_view text)
{
    const size_t first = text.find_first_not_of(' ');
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "xy" or "rg" as "rg"; "" when these are no channels of a format.
std::string channels_of(std::string_view text, Format format)
{
    constexpr std::string_view kColors = "rgba";
    constexpr std::string_view kPlaces = "xyzw";
    std::string channels;
    for (const char c : text) {
        const size_t channel = std::min(kColors.find(c), kPlaces.find(c));
        if (channel >= static_cast<size_t>(channel_count(format)))
            return "";
        channels += kColors[channel];
    }
    return channels;
}

std::optional<Format> find_format(std::string_view wanted)
{
    for (int i = 0; i <= static_cast<int>(Format::depth32f); ++i)
        if (name(static_cast<Format>(i)) == wanted)
            return static_cast<Format>(i);
    return std::nullopt;
}

std::vector<std::string> format_names()
{
    std::vector<std::string> names;
    for (int i = 0; i <= static_cast<int>(Format::depth32f); ++i)
        names.emplace_back(name(static_cast<Format>(i)));
    return names;
}

/// One layout: targets it names itself, and one more for each output that has a codec and no place.
class LayoutReader {
public:
    LayoutReader(const Json::Member& member, const PassDeclaration& pass, Errors& errors) : pass_(pass), errors_(errors)
    {
        layout_.name = member.key;
        if (!member.value.is(Json::Kind::object)) {
            report_wrong_type(member.value, fmt::format("layout `{}`", member.key), "an object", errors);
            return;
        }
        if (const Json* targets = member.value.find("targets"))
            read_targets(*targets);
        for (const Json::Member& entry : member.value.members)
            if (entry.key != "targets")
                read_output(entry);
        if (errors.empty())
            check_free(member.where);
    }

    Layout take() { return std::move(layout_); }

private:
    void report(std::string code, std::string message, std::string hint, const Location& where)
    {
        errors_.push_back({std::move(code), fmt::format("layout `{}`: {}", layout_.name, message), std::move(hint), where});
    }

    void read_targets(const Json& targets)
    {
        if (!targets.is(Json::Kind::object)) {
            report_wrong_type(targets, fmt::format("layout `{}`: \"targets\"", layout_.name), "an object", errors_);
            return;
        }
        for (const Json::Member& entry : targets.members) {
            const auto format = find_format(entry.value.string);
            if (!format)
                report("unknown_format", fmt::format("target `{}`: there is no format `{}`", entry.key, entry.value.string),
                       suggest(entry.value.string, format_names(), "formats"), entry.value.where);
            layout_.targets.push_back({entry.key, format.value_or(Format::rgba32f)});
        }
    }

    void read_output(const Json::Member& entry)
    {
        const int index = pass_.find_output(entry.key);
        if (index < 0) {
            std::vector<std::string> names;
            for (const OutputPort& port : pass_.outputs)
                names.push_back(port.name);
            report("unknown_output", fmt::format("there is no output `{}`", entry.key), suggest(entry.key, names, "outputs"),
                   entry.where);
            return;
        }
        if (!entry.value.is(Json::Kind::string)) {
            report_wrong_type(entry.value, fmt::format("layout `{}`: `{}`", layout_.name, entry.key),
                              "a codec's name, places or a derivation", errors_);
            return;
        }
        Layout::Output output;
        output.output = entry.key;
        output.where = entry.value.where;
        const Signal signal = pass_.outputs[static_cast<size_t>(index)].signal;
        const std::string_view text = trimmed(entry.value.string);
        if (text.starts_with("from "))
            output.derived_from = trimmed(text.substr(5));
        else if (text.find('.') == std::string_view::npos)
            take_own_target(text, signal, output);
        else
            read_places(text, signal, output);
        layout_.outputs.push_back(std::move(output));
    }

    /// "rgba8": a target of its own.
    void take_own_target(std::string_view codec, Signal signal, Layout::Output& output)
    {
        const Codec* found = find_codec(signal, codec);
        if (!found) {
            report("unknown_codec", fmt::format("no codec `{}` stores {}", codec, info(signal).name),
                   suggest(codec, codec_names(signal), "codecs"), output.where);
            return;
        }
        output.codec = *found;
        const int channels = std::min(channel_count(found->format), 4);
        output.places = {{static_cast<int>(layout_.targets.size()), std::string("rgba").substr(0, static_cast<size_t>(channels))}};
        layout_.targets.push_back({output.output, found->format});
    }

    /// "diffuse.a, normal.a : rgba8": channels of named targets, and how the codes that stand there are made.
    void read_places(std::string_view text, Signal signal, Layout::Output& output)
    {
        const size_t colon = text.find(':');
        const std::string_view codec = colon == std::string_view::npos ? "" : trimmed(text.substr(colon + 1));
        std::string_view rest = text.substr(0, colon);
        while (!rest.empty()) {
            const size_t comma = rest.find(',');
            read_place(trimmed(rest.substr(0, comma)), output);
            rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
        }
        if (output.places.empty())
            return;
        const Format format = layout_.targets[static_cast<size_t>(output.places.front().target)].format;
        output.codec = {name(format), format, Packing::plain};
        if (!codec.empty()) {
            const Codec* found = find_codec(signal, codec);
            if (!found) {
                report("unknown_codec", fmt::format("no codec `{}` stores {}", codec, info(signal).name),
                       suggest(codec, codec_names(signal), "codecs"), output.where);
                return;
            }
            output.codec = *found;
        }
        check_fit(signal, output);
    }

    void read_place(std::string_view text, Layout::Output& output)
    {
        const size_t dot = text.find('.');
        const auto target = std::find_if(layout_.targets.begin(), layout_.targets.end(),
                                         [&](const Layout::Target& t) { return t.name == text.substr(0, dot); });
        if (dot == std::string_view::npos || target == layout_.targets.end()) {
            std::vector<std::string> names;
            for (const Layout::Target& known : layout_.targets)
                names.push_back(known.name);
            report("unknown_target", fmt::format("`{}` names no target", text), suggest(text.substr(0, dot), names, "targets"),
                   output.where);
            return;
        }
        const std::string channels = channels_of(text.substr(dot + 1), target->format);
        if (channels.empty())
            report("unknown_channels", fmt::format("`{}` names no channels of {}", text, name(target->format)),
                   "channels are r g b a or x y z w", output.where);
        output.places.push_back({static_cast<int>(target - layout_.targets.begin()), channels});
    }

    void check_fit(Signal signal, const Layout::Output& output)
    {
        size_t channels = 0;
        for (const Layout::Place& place : output.places) {
            channels += place.channels.size();
            const Format format = layout_.targets[static_cast<size_t>(place.target)].format;
            if (output.codec.packing != Packing::plain && channel_kind(format) != channel_kind(output.codec.format))
                report("codec_mismatch", fmt::format("`{}`: codes of {} do not fit into {}", output.output, output.codec.name,
                                                     name(format)),
                       "a packed code needs channels of its own kind", output.where);
        }
        const bool is_plane = output.codec.packing == Packing::octahedral || output.codec.packing == Packing::sphere_map;
        const size_t wanted = output.codec.packing == Packing::plain
                                  ? static_cast<size_t>(info(signal).components)
                                  : static_cast<size_t>(std::min(channel_count(output.codec.format), is_plane ? 2 : 3));
        if (channels != wanted)
            report("channel_count", fmt::format("`{}` needs {} channels, its places have {}", output.output, wanted, channels),
                   "name one channel for each", output.where);
    }

    /// No channel holds two outputs.
    void check_free(const Location& where)
    {
        std::vector<std::string> taken(layout_.targets.size());
        for (const Layout::Output& output : layout_.outputs) {
            for (const Layout::Place& place : output.places) {
                std::string& channels = taken[static_cast<size_t>(place.target)];
                for (const char c : place.channels)
                    if (channels.find(c) != std::string::npos)
                        report("channel_taken", fmt::format("`{}`: {}.{} holds another output already", output.output,
                                                            layout_.targets[static_cast<size_t>(place.target)].name, c),
                               "choose a free channel", output.where);
                channels += place.channels;
            }
        }
        for (size_t i = 0; i < taken.size(); ++i)
            if (taken[i].empty())
                report("target_unused", fmt::format("nothing stands in target `{}`", layout_.targets[i].name), "remove it",
                       where);
    }

    const PassDeclaration& pass_;
    Errors& errors_;
    Layout layout_;
};

} // namespace

void read_layouts(const Json& layouts, PassDeclaration& pass, Errors& errors)
{
    Selection selection;
    selection.name = "layout";
    selection.kind = Selection::Kind::layout;
    selection.where = layouts.where;
    for (const Json::Member& member : layouts.members) {
        selection.items.push_back(member.key);
        pass.layouts.push_back(LayoutReader(member, pass, errors).take());
    }
    if (!selection.items.empty())
        pass.selections.push_back(std::move(selection));
}

} // namespace passgraph::header
