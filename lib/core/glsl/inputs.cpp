// Accessors of images and cubes: a texture, a value of another pass of the step, a constant, or black.
#include "core/glsl/inputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "passgraph/core/glsl_interface.hpp"

namespace passgraph::glsl {
namespace {

/// The expression that reads an input at `place` ("uv, 0.0"), decoded, guarded when the host supplies it.
/// Codes that stand in the first channels of one texture are its texel; others are gathered into a vec4.
std::string texture_value(const InputSource& source, std::string_view function, std::string_view place)
{
    const auto fetch = [&](const InputSource::Piece& piece) {
        return fmt::format("{}({}, {})", function, piece.sampler, place);
    };
    std::string texel;
    size_t channels = 0;
    for (const InputSource::Piece& piece : source.pieces) {
        texel += fmt::format("{}.{}, ", fetch(piece), piece.channels);
        channels += piece.channels.size();
    }
    if (source.pieces.size() == 1 && std::string_view("rgba").starts_with(source.pieces.front().channels))
        texel = fetch(source.pieces.front());
    else
        texel = channels == 4 ? fmt::format("vec4({})", texel.substr(0, texel.size() - 2))
                              : fmt::format("vec4({}{}1.0)", texel, channels == 1 ? "0.0, 0.0, " : channels == 2 ? "0.0, " : "");
    std::string value = glsl_decode_call(source.signal, source.codec, texel);
    if (source.is_import)
        value = glsl_guard_call(source.signal, value);
    return value;
}

/// What a sampler makes of texels, of values that are computed: clamped to the edge, the four around a place weighed by nearness.
void add_call_accessor(ProgramText& text, const InputSource& source, std::string_view type, const std::string& name)
{
    const auto [width, height] = source.extent;
    text.add_line(fmt::format("vec2 {}_inside(vec2 texel) {{ return clamp(texel, vec2(0.0), vec2({:#}, {:#})); }}", name, width - 1.0,
                              height - 1.0));
    if (source.filter == Filter::nearest) {
        text.add_line(fmt::format("{0} {1}(vec2 uv) {{ return {2}({1}_inside(floor(uv * vec2({3:#}, {4:#})))); }}", type, name, source.name,
                                  static_cast<double>(width), static_cast<double>(height)));
        return;
    }
    text.add_line(fmt::format(R"({0} {1}(vec2 uv)
{{
    vec2 place = uv * vec2({3:#}, {4:#}) - 0.5;
    vec2 low = floor(place);
    vec2 share = place - low;
    vec2 a = {1}_inside(low);
    vec2 b = {1}_inside(low + 1.0);
    return mix(mix({2}(a), {2}(vec2(b.x, a.y)), share.x), mix({2}(vec2(a.x, b.y)), {2}(b), share.x), share.y);
}})",
                              type, name, source.name, static_cast<double>(width), static_cast<double>(height)));
}

void add_image_accessor(ProgramText& text, const InputPort& port, const InputSource& source, const std::string& name,
                        Part part)
{
    const std::string_view type = glsl_type(seen_components(port));
    const bool drops_alpha = info(source.signal).has_alpha && seen_components(port) == 3;
    const auto add = [&](const std::string& suffix, const std::string& parameters, std::string_view function,
                         std::string_view place) {
        const bool is_zero = source.kind == InputSource::Kind::black || (part == Part::background && source.is_tested_depth) ||
                             (part == Part::when_skipped && source.is_black_when_skipped);
        const bool is_constant = source.kind == InputSource::Kind::constant || source.kind == InputSource::Kind::black;
        const int components = is_constant ? seen_components(port) : info(source.signal).components;
        const std::string whole = is_zero ? fmt::format("{}(0.0)", glsl_type(components))
                                  : source.kind == InputSource::Kind::value   ? source.name
                                  : source.kind == InputSource::Kind::texture ? texture_value(source, function, place)
                                                                              : constant_value(port);
        const bool is_wide = !is_constant && drops_alpha;
        text.add_line(fmt::format("{} {}{}({}) {{ return {}{}; }}", type, name, suffix, parameters,
                                  is_wide ? "(" + whole + ")" : whole, is_wide ? ".rgb" : ""));
        if (is_wide && suffix.empty())
            text.add_line(fmt::format("float {}_alpha(vec2 uv) {{ return ({}).a; }}", name, whole));
    };
    if (source.kind == InputSource::Kind::call) {
        add_call_accessor(text, source, type, name);
    } else if (port.has_levels) {
        add("", "vec2 uv", "textureLod", "uv, 0.0");
        add("_lod", "vec2 uv, float lod", "textureLod", "uv, lod");
    } else if (source.is_loaded) {
        add("", "vec2 uv", "imageLoad", "passgraph_texel");
    } else {
        add("", "vec2 uv", "texture", "uv");
    }
    const bool has_own_extent = source.extent.width > 0; // a table's may be known only when it is bound
    if (!has_own_extent) {
        const std::string size = fmt::format("textureSize({}, 0)", source.pieces.front().sampler);
        text.add_line(fmt::format("vec2 {}_texel() {{ return 1.0 / vec2({}); }}", name, size));
        text.add_line(fmt::format("ivec2 {}_size() {{ return {}; }}", name, size));
        return;
    }
    text.add_line(fmt::format("vec2 {}_texel() {{ return vec2({:#}, {:#}); }}", name,
                              1.0 / std::max(source.extent.width, 1), 1.0 / std::max(source.extent.height, 1)));
    text.add_line(
        fmt::format("ivec2 {}_size() {{ return ivec2({}, {}); }}", name, source.extent.width, source.extent.height));
}

void add_sphere_accessor(ProgramText& text, const InputPort& port, const InputSource& source, const std::string& name, const Flats& flats)
{
    const std::string_view type = glsl_type(seen_components(port));
    const bool is_wired = source.kind == InputSource::Kind::cube;
    const std::string constant =
        source.kind == InputSource::Kind::black ? fmt::format("{}(0.0)", type) : constant_value(port);
    const std::string value = is_wired ? texture_value(source, "textureLod", "direction, lod") : constant;
    text.add_line(fmt::format("{} {}(vec3 direction, float lod) {{ return {}; }}", type, name, value));
    text.add_line(fmt::format("float {}_top_lod() {{ return {}; }}", name,
                              is_wired ? fmt::format("passgraph_top_level(textureSize({}, 0).x)", source.pieces.front().sampler) : "0.0"));
    if (!port.has_levels)
        return;
    const std::string irradiance = is_wired
                                       ? fmt::format("passgraph_irradiance({}, direction)",
                                                     name_in(flats, harmonics_name(source.pieces.front().sampler)))
                                       : fmt::format("{} * 3.14159265358979324", constant);
    text.add_line(fmt::format("{} {}_irradiance(vec3 direction) {{ return {}; }}", type, name, irradiance));
}

} // namespace

std::string prefix_of(int number) { return fmt::format("p{}_", number); }

void add_inputs(ProgramText& text, const Instance& instance, const Flats& flats, Renames& renames, Part part)
{
    const std::string prefix = prefix_of(instance.number);
    for (size_t i = 0; i < instance.pass->inputs.size(); ++i) {
        const InputPort& port = instance.pass->inputs[i];
        if (port.over == Over::scene)
            continue;
        const auto rename = [&](const std::string& suffix) {
            renames.emplace_back(port.name + suffix, prefix + port.name + suffix);
        };
        rename("");
        if (port.over == Over::sphere) {
            rename("_top_lod");
            if (port.has_levels)
                rename("_irradiance");
            add_sphere_accessor(text, port, instance.inputs[i], prefix + port.name, flats);
        } else {
            rename("_texel");
            rename("_size");
            if (port.has_levels)
                rename("_lod");
            add_image_accessor(text, port, instance.inputs[i], prefix + port.name, part);
        }
    }
}

} // namespace passgraph::glsl
