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
  "ladders": { "ggx_form": ["textbook", "difference_of_squares", "lagrange"] } }*/
#include "brdf.glsl"
vec3 ggx_density(vec2 uv)
{
    vec3 n = normals(uv);
    vec3 h = halves(uv);
    float alpha = roughness * roughness;
    Terms terms = Terms(distribution_of_ggx, fresnel_of_schlick, geometry_smith_correlates, ggx_form, 0, 0);
    return vec3(density_of(terms, n, h, dot(n, h), 1.0, alpha * alpha), 0.0, 0.0);
}
)"},
    {"fresnel_edge", R"(/*{ "pass": "fresnel_edge",
  "inputs": { "cosines": "position" }, "outputs": { "weight": "position" },
  "ladders": { "fresnel_power": ["pow", "multiplications"] } }*/
#include "fresnel.glsl"
vec3 fresnel_edge(vec2 uv)
{
    vec3 c = cosines(uv);
    return vec3(fresnel_weight(c.x, fresnel_power), fresnel_weight(c.y, fresnel_power), fresnel_weight(c.z, fresnel_power));
}
)"},
    {"facets_seen", R"(/*{ "pass": "facets_seen",
  "inputs": { "angles": "position" }, "outputs": { "seen": "position" },
  "ladders": { "beckmann_masking": ["rational", "erf"] } }*/
#include "masking.glsl"
vec3 facets_seen(vec2 uv)
{
    float cosine = angles(uv).x;
    float alpha = angles(uv).y * angles(uv).y; // of the roughness
    return vec3(cosine / (cosine + beckmann_hidden(cosine, alpha * alpha, beckmann_masking)), 0.0, 0.0);
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
