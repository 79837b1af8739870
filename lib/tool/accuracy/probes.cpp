// The probes' texts.
#include "tool/accuracy/probes.hpp"

#include <fmt/format.h>

#include <passgraph/shader/pass_file.hpp>

namespace passgraph::accuracy {
namespace {

struct Probe {
    const char* name;
    const char* text;
};

/// Hands a value on: what it is stored in and read from is the graph's choice.
std::string keeper_of(const std::string& signal)
{
    return fmt::format(R"(/*{{ "pass": "keep_{0}", "inputs": {{ "value": "{0}" }}, "outputs": {{ "kept": "{0}" }} }}*/
vec3 keep_{0}(vec2 uv) {{ return value(uv); }}
)",
                       signal);
}

// Signals whose guard leaves every finite vector alone (`position`) carry what has no signal of its own.
constexpr Probe kProbes[] = {
    {"ggx_density", R"(/*{ "pass": "ggx_density",
  "inputs": { "normals": "position", "halves": "position" }, "outputs": { "density": "position" },
  "params": { "roughness": { "type": "float", "default": 0.045, "range": [0, 1], "static": true } },
  "ladders": { "form": ["textbook", "difference_of_squares", "lagrange"] } }*/
#include "brdf.glsl"
vec3 ggx_density(vec2 uv)
{
    vec3 n = normals(uv);
    vec3 h = halves(uv);
    float alpha = roughness * roughness;
    float cosine = dot(n, h);
#if form == form_textbook
    float bracket = cosine * cosine * (alpha * alpha - 1.0) + 1.0;
    float density = inverse_pi * alpha * alpha / (bracket * bracket);
#elif form == form_difference_of_squares
    float density = ggx_distribution(cosine * cosine, (1.0 - cosine) * (1.0 + cosine), alpha * alpha);
#else
    vec3 across = cross(n, h);
    float density = ggx_distribution(cosine * cosine, dot(across, across), alpha * alpha);
#endif
    return vec3(density, 0.0, 0.0);
}
)"},
    {"fresnel_edge", R"(/*{ "pass": "fresnel_edge",
  "inputs": { "cosines": "position" }, "outputs": { "weight": "position" },
  "ladders": { "power": ["pow", "multiplications"] } }*/
#include "brdf.glsl"
float edge(float cosine)
{
#if power == power_pow
    return pow(1.0 - cosine, 5.0);
#else
    return fresnel_weight(cosine);
#endif
}
vec3 fresnel_edge(vec2 uv)
{
    vec3 c = cosines(uv);
    return vec3(edge(c.x), edge(c.y), edge(c.z));
}
)"},
    {"spoil", R"(/*{ "pass": "spoil", "summary": "Returns what a careless pass may: marks in `value` become no number, infinity and less than nothing.",
  "inputs": { "value": "position" }, "outputs": { "spoilt": "radiance" } }*/
vec3 spoil(vec2 uv)
{
    vec3 seen = value(uv);
    float bad = seen.x < -2.5 ? -5.0 : uintBitsToFloat(seen.x < -1.5 ? 0x7f800000u : 0x7fc00000u);
    return seen.x < 0.0 ? vec3(bad) : seen;
}
)"},
};

} // namespace

Result<PassLibrary> with_probes(const PassLibrary& library, const std::string& common_folder)
{
    PassLibrary result = library;
    Errors errors;
    const auto add = [&](const std::string& name, const std::string& text) {
        const Result<PassPtr> pass = read_pass(text, "probe " + name, "probe", {common_folder});
        if (pass)
            result.add(*pass);
        else
            append(errors, pass.error());
    };
    for (const char* signal : {"normal", "position", "radiance"})
        add(std::string("keep_") + signal, keeper_of(signal));
    for (const Probe& probe : kProbes)
        add(probe.name, probe.text);
    if (!errors.empty())
        return tl::unexpected(std::move(errors));
    return result;
}

} // namespace passgraph::accuracy
