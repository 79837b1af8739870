// How a surface reflects light that comes from everywhere, a sky, without integrating over it.
#include "brdf.glsl"
#include "distribution.glsl"
#include "fresnel.glsl"
#include "masking.glsl"
#include "saturated.glsl"

/// Where the split-sum table keeps a surface, in uv of `size` texels: its first and last texels' centers are the ends of the
/// ranges. Along x the square root of n.v, because the lobe's share bends where n.v nears 0; along y roughness.
vec2 reflectance_place(float n_dot_v, float roughness, vec2 size)
{
    return vec2(sqrt(n_dot_v), roughness) * ((size - 1.0) / size) + 0.5 / size;
}

/// The surface that a place of the table stands for: n.v and roughness.
vec2 reflectance_surface(vec2 uv, vec2 size)
{
    vec2 place = (uv * size - 0.5) / (size - 1.0);
    return vec2(max(place.x * place.x, 1e-4), clamp(place.y, smallest_roughness, 1.0));
}

/// The half vector, of any length, at a place `u`, `turn` of the unit square: facets as the viewer sees them, GGX.
/// Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps". `seen` is the viewer as the facets' sphere
/// sees it, normalize(alpha v.x, alpha v.y, v.z).
vec3 visible_facet(vec3 seen, float alpha, float u, float turn)
{
    float z = 1.0 - u * (1.0 + seen.z);
    float r = sqrt(max(1.0 - z * z, 0.0));
    vec3 h = vec3(r * cos(6.28318530717958648 * turn), r * sin(6.28318530717958648 * turn), z) + seen;
    return vec3(alpha * h.xy, h.z);
}

/// The share of a uniformly bright environment that a rough surface reflects is f0 * x + y; x + y never exceeds 1.
/// Karis 2013, "Real Shading in Unreal Engine 4", "Environment BRDF", from the same terms as lamps are lit by.
///
/// A fixed quadrature of 64 x 16 half vectors: 64 midpoints from the lobe's center outwards, denser where it ends at the
/// horizon (u = 1 - s^3), and for each 16 around the circle, every ring turned by the golden section against the one before.
/// Against the integral in double: 3e-4 for Smith's geometry, 4e-3 for Cook and Torrance's, whose G has kinks.
/// Visible facets are seen with density D G1(v) / (4 n.v), which leaves V n.l 4 n.v / G1(v) of the integrand; Beckmann's
/// density takes the place of GGX's by their ratio, at most 4 / e.
vec2 environment_reflectance(float n_dot_v, float roughness, Terms terms)
{
    const int rings = 64;
    const int around = 16;
    float alpha = roughness * roughness;
    float alpha_squared = alpha * alpha;
    vec3 v = vec3(sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v)), 0.0, n_dot_v);
    vec3 seen = normalize(vec3(alpha * v.xy, v.z));
    float per_masking = n_dot_v + ggx_hidden(n_dot_v, alpha_squared); // n.v / G1(v)
    float v_hidden = hidden_of(terms, n_dot_v, alpha_squared);
    vec2 sum = vec2(0.0);
    for (int ring = 0; ring < rings; ++ring) {
        float s = 1.0 - (float(ring) + 0.5) / float(rings);
        float turn = fract(0.5 + 0.618033988749894848 * float(ring));
        vec2 of_ring = vec2(0.0);
        for (int i = 0; i < around; ++i) {
            vec3 h = visible_facet(seen, alpha, 1.0 - s * s * s, (turn + float(i)) / float(around));
            float h_squared = dot(h, h);
            float per_h = inversesqrt(h_squared);
            float v_dot_h = dot(v, h) * per_h;
            float n_dot_h = h.z * per_h;
            float n_dot_l = 2.0 * v_dot_h * n_dot_h - n_dot_v;
            if (n_dot_l <= 0.0 || v_dot_h <= 0.0)
                continue;
            float share = 4.0 * per_masking * n_dot_l *
                          visibility_of(terms, n_dot_l, n_dot_v, n_dot_h, v_dot_h,
                                        hidden_of(terms, n_dot_l, alpha_squared), v_hidden);
            if (terms.facets == distribution_of_beckmann) {
                float across = dot(h.xy, h.xy);
                share *= beckmann_distribution(h.z * h.z, across, h_squared, alpha_squared) /
                         ggx_distribution(h.z * h.z, across, h_squared, alpha_squared);
            }
            float edge = fresnel_weight(v_dot_h, terms.power);
            of_ring += share * vec2(1.0 - edge, edge);
        }
        sum += s * s * of_ring;
    }
    // The midpoints' weights 3 s^2 sum to 1 - 1 / (4 rings^2): divided by what they sum to.
    float weights = float(around) * float(rings) * (1.0 / 3.0 - 1.0 / (12.0 * float(rings) * float(rings)));
    sum /= weights;
    return sum / max(sum.x + sum.y, 1.0); // no geometry term gives more than arrives; a sum may, by its own error
}

/// The level of a prefiltered sky that was made for a roughness: levels are equally far apart in roughness, from a mirror's at
/// 0 to a roughness of 1 at the top. Between two levels the blend is six times as steep, around their middle, so that five
/// sixths of all roughnesses read one level: half the texels, and a tenth of the lighting's time on llvmpipe.
float environment_lod(float roughness, float top_lod)
{
    float lod = saturated(roughness) * top_lod;
    float level = floor(lod);
    return level + clamp(6.0 * (lod - level) - 2.5, 0.0, 1.0);
}
