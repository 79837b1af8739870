// Where a lamp's light comes from and how much of it arrives.
#include "attenuation.glsl"

/// The way from a place to the lamp in metres; to a lamp infinitely far away, the unit vector against its light.
vec3 way_to(Light lamp, vec3 place)
{
    return lamp.position - place * lamp.nearness;
}

/// Irradiance on a plane facing the lamp, which stands in the direction `l` at `squared` metres^2.
vec3 irradiance(Light lamp, float squared, vec3 l)
{
    float strength = 1.0;
    if (lights_have_ends())
        strength = lamp.nearness > 0.0 ? windowed_inverse_square(squared, lamp.per_radius_squared) : 1.0;
    if (lights_have_cones())
        strength *= cone_share(lamp.cone_offset - dot(l, lamp.axis));
    return lamp.color * strength;
}
