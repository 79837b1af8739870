// A pass's body with the declarations it sees, as a text of its own: for a parser, not for a driver.
#include <fmt/format.h>

#include "core/glsl/assemble.hpp"
#include "core/glsl/module_text.hpp"

namespace passgraph::glsl {

std::string standalone_text(const PassDeclaration& pass, const std::vector<int>& selections,
                            std::vector<std::string>& sources)
{
    // Nothing is renamed here: parameters, accessors and includes keep their names, for glslang's messages and analysis.
    ProgramText text(sources);
    text.add_line("#version 330 core");
    text.add(accessors(pass.reads, pass.kind));
    text.add_line("ivec2 pixel() { return ivec2(gl_FragCoord.xy); }\nivec2 pixel_count() { return ivec2(1); }");
    for (const InputPort& port : pass.inputs) {
        if (port.over == Over::scene)
            continue;
        const std::string_view type = glsl_type(seen_components(port));
        if (port.over == Over::sphere) {
            text.add_line(fmt::format("{} {}(vec3 direction, float lod) {{ return {}; }}", type, port.name,
                                      constant_value(port)));
            text.add_line(fmt::format("float {}_top_lod() {{ return 0.0; }}", port.name));
            if (port.has_levels)
                text.add_line(fmt::format("{} {}_irradiance(vec3 direction) {{ return {}; }}", type, port.name,
                                          constant_value(port)));
            continue;
        }
        text.add_line(fmt::format("{} {}(vec2 uv) {{ return {}; }}", type, port.name, constant_value(port)));
        if (port.has_levels)
            text.add_line(
                fmt::format("{} {}_lod(vec2 uv, float lod) {{ return {}; }}", type, port.name, constant_value(port)));
        text.add_line(fmt::format("vec2 {}_texel() {{ return vec2(1.0); }}\nivec2 {}_size() {{ return ivec2(1); }}",
                                  port.name, port.name));
    }
    std::vector<std::pair<std::string, std::string>> renames;
    for (const Param& param : pass.params) {
        text.add_line(param.is_static ? fmt::format("const {} {} = {};", glsl_type_of(param.type), param.name,
                                                    literal(param.type, param.default_value))
                                      : fmt::format("uniform {} {};", glsl_type_of(param.type), param.name));
        for (size_t item = 0; item < param.items.size(); ++item)
            renames.emplace_back(param.name + "_" + param.items[item], std::to_string(item));
    }
    for (size_t i = 0; i < pass.selections.size(); ++i) {
        if (selections[i] == kAnyItem)
            text.add_line(fmt::format("uniform int {};", pass.selections[i].name));
        else
            renames.emplace_back(pass.selections[i].name, std::to_string(selections[i]));
        for (size_t item = 0; item < pass.selections[i].items.size(); ++item)
            renames.emplace_back(pass.selections[i].name + "_" + pass.selections[i].items[item], std::to_string(item));
    }
    GlslText body = pass.body;
    body.globals.clear();
    text.add_module(body, "", renames);
    if (!pass.skip_when.empty()) {
        GlslText skip = skip_text(pass);
        skip.globals.clear();
        text.add_module(skip, "", std::move(renames));
    }
    text.add_line("void main() {}");
    return text.take();
}

} // namespace passgraph::glsl
