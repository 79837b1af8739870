// Flat values: which, and the vertex stage that hands them over.
#include "core/glsl/flat.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/glsl/accessors.hpp"

namespace passgraph::glsl {
namespace {

/// What its accessors read of the camera: two matrices and two vectors.
constexpr int kCameraComponents = 40;
constexpr int kUvComponents = 4; // a varying of two fills up one of four

int components_of(ParamType type)
{
    switch (type) {
    case ParamType::float_: return 1;
    case ParamType::vec2: return 2;
    case ParamType::color:
    case ParamType::vec3: return 3;
    case ParamType::vec4: return 4;
    case ParamType::int_:
    case ParamType::bool_:
    case ParamType::enum_: return 0; // these choose code: better known before it runs
    }
    return 0;
}

std::string array_of(int count) { return count > 0 ? fmt::format("[{}]", count) : std::string(); }

} // namespace

bool Flats::has(const std::string& uniform) const
{
    return std::any_of(uniforms.begin(), uniforms.end(), [&](const FlatUniform& flat) { return flat.uniform == uniform; });
}

Flats flats_of(const StepSource& step)
{
    Flats flats;
    if (step.kind == PassKind::geometry)
        return flats;
    int left = step.varying_components - kUvComponents;
    const auto fits = [&](int components) {
        const bool does = components > 0 && components <= left;
        left -= does ? components : 0;
        return does;
    };
    flats.has_camera = step.reads.camera && fits(kCameraComponents);
    const int rows = light_rows(step.reads, step.facts);
    if (fits(4 * rows))
        flats.uniforms.push_back({"vec4", kLightRows, rows});
    for (const Instance& instance : step.instances)
        for (size_t i = 0; i < instance.pass->params.size(); ++i)
            if (const Param& param = instance.pass->params[i]; !instance.is_static[i] && fits(components_of(param.type)))
                flats.uniforms.push_back({std::string(glsl_type_of(param.type)), uniform_name(instance.number, param.name)});
    for (const SamplerDeclaration& sampler : step.samplers)
        if (sampler.is_cube && fits(3 * kHarmonics))
            flats.uniforms.push_back({"vec3", harmonics_name(sampler.name), kHarmonics});
    return flats;
}

std::string flat_name(const std::string& uniform) { return "flat_" + uniform; }

std::string declared(const Flats& flats, const std::string& type, const std::string& uniform, int count)
{
    return fmt::format("{} {} {}{};\n", flats.has(uniform) ? "flat in" : "uniform", type, name_in(flats, uniform), array_of(count));
}

std::string name_in(const Flats& flats, const std::string& uniform) { return flats.has(uniform) ? flat_name(uniform) : uniform; }

std::string full_screen_vertex(const Flats& flats)
{
    std::string declarations;
    std::string assignments;
    if (flats.has_camera) {
        declarations += camera_block("passgraph_camera") + "flat out mat4 passgraph_view_from_world;\nflat out mat4 passgraph_world_from_view;\n"
                                                           "flat out vec4 passgraph_ray;\nflat out vec4 passgraph_range;\n";
        for (const char* name : {"passgraph_view_from_world", "passgraph_world_from_view", "passgraph_ray", "passgraph_range"})
            assignments += fmt::format("    {0} = passgraph_camera.{0};\n", name);
    }
    for (const FlatUniform& flat : flats.uniforms) {
        const std::string array = array_of(flat.count);
        declarations += fmt::format("uniform {0} {1}{2};\nflat out {0} {3}{2};\n", flat.type, flat.uniform, array, flat_name(flat.uniform));
        assignments += fmt::format("    {} = {};\n", flat_name(flat.uniform), flat.uniform);
    }
    return fmt::format(R"(#version 330 core
noperspective out vec2 passgraph_uv;
{}void main()
{{
    // One triangle that covers the target; uv is exact at texel centers of extents up to 2^23.
    passgraph_uv = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(passgraph_uv * 2.0 - 1.0, 0.0, 1.0);
{}}}
)",
                       declarations, assignments);
}

} // namespace passgraph::glsl
