// Where a lamp's light comes from and how much of it arrives.
#include "attenuation.glsl"

/// The way from a place to the lamp in metres; of a directional light, against the light's direction.
vec3 way_to(Light lamp, vec3 place)
{
    return lamp.kind == light_point ? lamp.position - place : -lamp.direction;
}

/// Irradiance on a plane facing the lamp, `squared` metres^2 away.
vec3 irradiance(Light lamp, float squared)
{
    float strength = windowed_inverse_square(squared, lamp.radius);
    return lamp.color * (lamp.kind == light_point ? strength : 1.0);
}
