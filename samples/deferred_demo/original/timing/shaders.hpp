// GLSL of the original's frame, reconstructed from its description; defects included, because they cost time too.
#pragma once

namespace original {

inline constexpr const char* kGeometryVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
out vec3 place;
out vec3 facing;
out vec2 texcoord;
void main()
{
    vec4 world = model * vec4(position, 1.0);
    place = (view * world).xyz;
    facing = mat3(view * model) * normal;
    texcoord = uv;
    gl_Position = projection * view * world;
})";

inline constexpr const char* kGeometryFragment = R"(#version 330 core
in vec3 place;
in vec3 facing;
in vec2 texcoord;
uniform sampler2D color_texture;
uniform sampler2D material_texture;
layout(location = 0) out vec4 diffuse;
layout(location = 1) out vec4 normal;
layout(location = 2) out vec4 position;
layout(location = 3) out vec4 material;
void main()
{
    diffuse = vec4(texture(color_texture, texcoord).rgb, 1.0);
    normal = vec4(normalize(facing), 1.0);
    position = vec4(place, 1.0);
    material = vec4(texture(material_texture, texcoord).rgb, 1.0);
})";

inline constexpr const char* kScreenVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
out vec2 texcoord;
void main()
{
    texcoord = uv;
    gl_Position = vec4(position, 1.0);
})";

inline constexpr const char* kLighting = R"(#version 330 core
in vec2 texcoord;
uniform sampler2D diffuse_map;
uniform sampler2D normal_map;
uniform sampler2D position_map;
uniform sampler2D material_map;
struct Lamp { vec3 color; vec3 position; vec3 direction; int kind; };
uniform Lamp lamps[8];
uniform int lamp_count;
layout(location = 0) out vec4 lit;
layout(location = 1) out vec4 bright;
const float pi = 3.14159265;
float ggx(float n_dot_h, float roughness)
{
    float a2 = pow(roughness, 4.0);
    float d = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0;
    return a2 / (pi * d * d);
}
void main()
{
    vec3 base = texture(diffuse_map, texcoord).rgb;
    vec3 n = normalize(texture(normal_map, texcoord).rgb);
    vec3 place = texture(position_map, texcoord).rgb;
    vec3 matter = texture(material_map, texcoord).rgb;
    vec3 v = normalize(-place);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < lamp_count; ++i) {
        vec3 way = lamps[i].kind == 1 ? lamps[i].position - place : -lamps[i].direction;
        float d = length(way);
        float attenuation = lamps[i].kind == 1 ? 1.0 / (d * d) : 1.0;
        vec3 l = normalize(way);
        vec3 h = normalize(v + l);
        float n_dot_l = max(dot(n, l), 0.0);
        float n_dot_v = max(dot(n, v), 0.0);
        float n_dot_h = max(dot(n, h), 0.0);
        float v_dot_h = max(dot(v, h), 0.0);
        vec3 f0 = mix(vec3(0.08 * matter.r), base, matter.b);
        vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - v_dot_h, 5.0);
        float masking = min(1.0, min(2.0 * n_dot_h * n_dot_v / v_dot_h, 2.0 * n_dot_h * n_dot_l / v_dot_h));
        vec3 specular = fresnel * ggx(n_dot_h, matter.g) * masking * n_dot_v;
        sum += (base * (1.0 - matter.b) / pi + specular) * n_dot_l * lamps[i].color * attenuation;
    }
    lit = vec4(sum, 1.0);
    if (dot(sum, vec3(0.2126, 0.7152, 0.0722)) > 0.8)
        bright = vec4(sum, 1.0);
})";

inline constexpr const char* kBlur = R"(#version 330 core
in vec2 texcoord;
uniform sampler2D image;
uniform bool is_horizontal;
layout(location = 0) out vec4 color;
const float weight[5] = float[5](0.227027, 0.1945946, 0.1216216, 0.054054, 0.016216);
void main()
{
    vec2 texel = 1.0 / vec2(textureSize(image, 0));
    vec3 sum = texture(image, texcoord).rgb * weight[0];
    for (int i = 0; i < 5; ++i) {
        vec2 offset = is_horizontal ? vec2(texel.x * float(i), 0.0) : vec2(0.0, texel.y * float(i));
        sum += texture(image, texcoord + offset).rgb * weight[i];
        if (i > 0)
            sum += texture(image, texcoord - offset).rgb * weight[i];
    }
    color = vec4(sum, 1.0);
})";

inline constexpr const char* kCombine = R"(#version 330 core
in vec2 texcoord;
uniform sampler2D scene;
uniform sampler2D bloom;
uniform bool is_night;
layout(location = 0) out vec4 color;
vec3 curve(vec3 x)
{
    return (x * (0.22 * x + 0.10 * 0.30) + 0.20 * 0.01) / (x * (0.22 * x + 0.30) + 0.20 * 0.30) - 0.01 / 0.30;
}
void main()
{
    vec3 seen = texture(scene, texcoord).rgb + texture(bloom, texcoord).rgb;
    vec3 toned = curve(seen) / curve(vec3(11.2));
    float rim = smoothstep(0.5, 0.9, length(texcoord - 0.5) * 1.41421356);
    color = vec4(toned, 1.0);
    if (is_night)
        color = color * vec4(0.40, 0.79, 0.11, 1.0) - rim;
})";

} // namespace original
