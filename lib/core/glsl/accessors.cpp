// GLSL of what the frame offers a pass beside its inputs: camera, lights, frame, elements.
#include "core/glsl/accessors.hpp"

#include <cassert>
#include <map>

#include <fmt/format.h>


namespace passgraph::glsl {
namespace {

constexpr const char* kFlatCamera = R"(flat in mat4 passgraph_view_from_world;
flat in mat4 passgraph_world_from_view;
flat in vec4 passgraph_ray;
flat in vec4 passgraph_range;
)";

constexpr const char* kCamera = R"(vec3 view_ray(vec2 uv) { return vec3((uv * 2.0 - 1.0) * passgraph_ray.xy + passgraph_ray.zw, -1.0); }
vec3 world_from_view(vec3 direction) { return mat3(passgraph_world_from_view) * direction; }
vec3 view_from_world(vec3 direction) { return mat3(passgraph_view_from_world) * direction; }
vec3 camera_position() { return passgraph_world_from_view[3].xyz; }
float view_distance(float depth)
{
    // Reversed depth d of the distance z: d = n (f - z) / (z (f - n)), so z = n f / (n + d (f - n)).
    return passgraph_range.x * passgraph_range.y / (passgraph_range.x + depth * (passgraph_range.y - passgraph_range.x));
}
float passgraph_distance_of(float depth) { return depth > 0.0 ? view_distance(depth) : 0.0; }
float passgraph_depth_of(float distance)
{
    float above = passgraph_range.x * (passgraph_range.y - distance);
    return distance > 0.0 ? above / (distance * (passgraph_range.y - passgraph_range.x)) : 0.0;
}
)";

constexpr const char* kFrame = R"(layout(std140) uniform passgraph_frame_block
{
    float passgraph_time;
    float passgraph_delta;
    int passgraph_index;
    int passgraph_is_cut;
    int passgraph_light_count;
};
)";

constexpr const char* kFrameAccessors = R"(float frame_time() { return passgraph_time; }
float frame_delta() { return passgraph_delta; }
int frame_index() { return passgraph_index; }
bool frame_is_cut() { return passgraph_is_cut != 0; }
float random(ivec2 pixel, int n)
{
    // Jarzynski and Olano 2020, "Hash Functions for GPU Rendering" (pcg3d); 24 bits fill a float in [0, 1).
    uvec3 v = uvec3(uint(pixel.x), uint(pixel.y), uint(n)) * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    return float(v.x >> 8u) * (1.0 / 16777216.0);
}
)";

constexpr const char* kLight = R"(struct Light
{
    vec3 color;               // irradiance on a facing plane: directional as it is, else at 1 m
    vec3 position;            // metres, view space; of a directional light the unit vector against its direction
    float nearness;           // 1: at `position`; 0: infinitely far in its direction
    float per_radius_squared; // 1 / radius^2, rounded up; 0 has no end
    vec3 axis;                // of a spot light, times its cone's scale; 0 shines all around
    float cone_offset;        // cone_share(cone_offset - dot(to the light, axis))
};
Light light(int i)
{
    vec4 color_and_end = passgraph_light_row(3 * i);
    vec4 position_and_nearness = passgraph_light_row(3 * i + 1);
    vec4 axis_and_offset = passgraph_light_row(3 * i + 2);
    return Light(color_and_end.rgb, position_and_nearness.xyz, position_and_nearness.w, color_and_end.w,
                 axis_and_offset.xyz, axis_and_offset.w);
}
)";

constexpr const char* kElements = R"(uniform vec4 passgraph_element[7];
uniform vec4 passgraph_atlas_levels[15];
uniform sampler2D passgraph_atlas_albedo;
uniform sampler2D passgraph_atlas_material;
uniform sampler2D passgraph_atlas_emissive;
vec3 element_to_view(vec3 position)
{
    vec4 place = vec4(position, 1.0);
    return vec3(dot(passgraph_element[0], place), dot(passgraph_element[1], place), dot(passgraph_element[2], place));
}
vec3 element_normal_to_view(vec3 normal)
{
    return vec3(dot(passgraph_element[3].xyz, normal), dot(passgraph_element[4].xyz, normal),
                dot(passgraph_element[5].xyz, normal));
}
vec2 element_texels() { return passgraph_cell.xy; }
int element_last_level() { return int(passgraph_cell.z); }
ivec2 element_wrap() { return ivec2(int(passgraph_cell.w) & 3, int(passgraph_cell.w) >> 2); }
vec4 element_level(int i) { return passgraph_atlas_levels[i]; }
vec3 element_albedo(vec2 place) { return texture(passgraph_atlas_albedo, place).rgb; }
vec3 element_material(vec2 place) { return texture(passgraph_atlas_material, place).rgb; }
vec3 element_emissive(vec2 place) { return texture(passgraph_atlas_emissive, place).rgb; }
)";

/// What is known of the lights is a constant, which folds away whatever the lights do not need.
std::string lights_part(const Facts& facts, const Flats& flats)
{
    const bool are_few = facts.lights() <= kFewLights;
    const int count = are_few ? static_cast<int>(facts.lights()) : 0;
    std::string rows = "uniform samplerBuffer passgraph_lights;\nvec4 passgraph_light_row(int i) { return texelFetch(passgraph_lights, i); }\n";
    if (are_few)
        rows = count == 0 ? "vec4 passgraph_light_row(int i) { return vec4(0.0); }\n"
                          : fmt::format("{}vec4 passgraph_light_row(int i) {{ return {}[i]; }}\n",
                                        declared(flats, "vec4", kLightRows, count * kLightTexels), name_in(flats, kLightRows));
    return fmt::format("{}{}int light_count() {{ return {}; }}\nbool lights_have_ends() {{ return {}; }}\n"
                       "bool lights_have_cones() {{ return {}; }}\n",
                       rows, kLight, are_few ? std::to_string(count) : "passgraph_light_count",
                       facts.point_lights + facts.spot_lights > 0.0, facts.spot_lights > 0.0);
}

/// `cell` declares passgraph_cell, an element's last row: flat, see flat.hpp.
std::string common_part(const Reads& reads, const Facts& facts, const Flats& flats, std::string_view cell)
{
    std::string text;
    if (reads.camera)
        text += (flats.has_camera ? kFlatCamera : camera_block("")) + kCamera;
    if (reads.frame || reads.lights)
        text += kFrame;
    if (reads.frame)
        text += kFrameAccessors;
    if (reads.lights)
        text += lights_part(facts, flats);
    if (reads.materials)
        text += fmt::format("bool materials_have_metal() {{ return {}; }}\n", facts.metal > 0.0);
    if (reads.elements)
        text += fmt::format("{} vec4 passgraph_cell;\n{}", cell, kElements);
    return text;
}

} // namespace

std::string camera_block(std::string_view instance)
{
    return fmt::format(R"(layout(std140) uniform {}
{{
    mat4 passgraph_clip_from_view;
    mat4 passgraph_view_from_world;
    mat4 passgraph_world_from_view;
    vec4 passgraph_ray;
    vec4 passgraph_range;
}}{}{};
)",
                       kCameraBlock, instance.empty() ? "" : " ", instance);
}

int light_rows(const Reads& reads, const Facts& facts)
{
    return reads.lights && facts.lights() <= kFewLights ? static_cast<int>(facts.lights()) * kLightTexels : 0;
}

std::string accessors(const Reads& reads, PassKind kind, const Facts& facts, const Flats& flats)
{
    std::string text = common_part(reads, facts, flats, "flat in");
    if (reads.elements && kind == PassKind::geometry) {
        // A mirrored element has its winding, and so the host's front face, flipped already.
        text += "bool element_is_back_facing() { return !gl_FrontFacing; }\n";
    }
    return text;
}

std::string accessors(const Reads& reads, PassKind kind, const Facts& facts) { return accessors(reads, kind, facts, {}); }

std::string vertex_accessors(const Reads& reads)
{
    std::string text = common_part(reads, {}, {}, "flat out");
    if (reads.elements)
        text += "bool element_is_back_facing() { return false; }\n";
    // A pass's functions for the surface stand in this stage too, uncalled; there are no derivatives here.
    for (const char* type : {"float", "vec2", "vec3"})
        for (const char* derivative : {"dFdx", "dFdy"})
            text += fmt::format("{0} {1}({0} x) {{ return {0}(0.0); }}\n", type, derivative);
    return text;
}

const std::vector<std::string>& accessor_names(const std::string& read)
{
    static const std::map<std::string, std::vector<std::string>> names = {
        {"camera", {"view_ray", "world_from_view", "view_from_world", "camera_position", "view_distance"}},
        {"frame", {"frame_time", "frame_delta", "frame_index", "frame_is_cut", "random"}},
        {"materials", {"materials_have_metal"}},
        {"lights", {"light_count", "light", "Light", "lights_have_ends", "lights_have_cones"}},
        {"elements",
         {"element_to_view", "element_normal_to_view", "element_texels", "element_last_level", "element_wrap",
          "element_level", "element_albedo", "element_material", "element_emissive", "element_is_back_facing"}},
    };
    const auto found = names.find(read);
    assert(found != names.end());
    return found->second;
}

} // namespace passgraph::glsl
