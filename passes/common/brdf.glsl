// What an opaque surface makes of light: GGX microfacets with a Fresnel edge, over a Lambert ground.
// Directions are unit vectors pointing away from the surface: n its normal, v to the viewer, l to the light; h = v + l
// is the half vector, not normalised. alpha is roughness squared, so alpha_squared is roughness to the fourth.

const float inverse_pi = 0.318309886183790672;

// Below it the highlight of a point light is a few pixels' noise and its peak, 1 / (pi alpha^2) = 77 625, leaves half.
const float smallest_roughness = 0.045;

/// What a surface's material says to the functions below; independent of the light.
struct Surface {
    vec3 diffuse;        ///< Lambert's albedo / pi, weighted by what the specular layer lets in and out towards v
    vec3 f0;             ///< reflectance at normal incidence
    float alpha_squared;
    float n_dot_v;       ///< at least 1e-4
};

/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15: F = f0 + (1 - f0) * weight.
/// Multiplications, because pow(x, 5) is 31 ulp off on llvmpipe and undefined once the cosine rounds above 1; there the
/// product is -1e-35, which is nothing.
float fresnel_weight(float cosine)
{
    float x = 1.0 - cosine;
    float x2 = x * x;
    return x2 * x2 * x;
}

vec3 fresnel(vec3 f0, float cosine)
{
    return f0 + (vec3(1.0) - f0) * fresnel_weight(cosine);
}

/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33: D, per steradian.
/// The textbook's 1 - cos^2 loses 9 % at roughness 0.045 to the cosine's rounding; the sine, taken from |n x h|, loses
/// 1e-5. With cos^2 + sin^2 = 1 the bracket is never below alpha^2. That bound, a comparison so that it holds for NaN too,
/// covers v = -l, where h is 0 and its angle 0 / 0; 1e-18 gives a perfect mirror (alpha 0) its limit 0.
float ggx_distribution(float cos_squared, float sin_squared, float alpha_squared)
{
    float least = max(alpha_squared, 1e-18);
    float bracket = cos_squared * alpha_squared + sin_squared;
    bracket = bracket > least ? bracket : least;
    return inverse_pi * alpha_squared / (bracket * bracket);
}

/// Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 99, height-correlated: G / (4 n.l n.v), per steradian.
/// Dividing analytically leaves no 0 / 0 unless both cosines are 0.
float smith_visibility(float n_dot_l, float n_dot_v, float alpha_squared)
{
    float shadowing = n_dot_v * sqrt(alpha_squared + (1.0 - alpha_squared) * n_dot_l * n_dot_l);
    float masking = n_dot_l * sqrt(alpha_squared + (1.0 - alpha_squared) * n_dot_v * n_dot_v);
    float both = shadowing + masking;
    return both > 0.0 ? 0.5 / both : 0.0;
}

/// The specular lobe without its Fresnel factor, D G / (4 n.l n.v), per steradian; 0 below the horizon.
float ggx_lobe(float n_dot_l, float n_dot_v, float cos_squared, float sin_squared, float alpha_squared)
{
    float lobe = ggx_distribution(cos_squared, sin_squared, alpha_squared) *
                 smith_visibility(n_dot_l, n_dot_v, alpha_squared);
    return n_dot_l > 0.0 && n_dot_v > 0.0 ? lobe : 0.0;
}

/// A surface from the G-buffer's values, `material` being specular, roughness, metallic.
/// A normal turned away from the viewer, which interpolation makes at silhouettes, is lit as if seen edge-on, so that
/// nothing jumps where n.v changes sign; 1e-4 as in Filament's clampNoV.
/// glTF 2.0 and KHR_materials_specular: dielectrics reflect 0.08 * specular at normal incidence, metals their albedo.
Surface make_surface(vec3 albedo, vec3 material, float n_dot_v)
{
    float dielectric_f0 = 0.08 * material.x;
    float alpha = max(material.y, smallest_roughness);
    alpha *= alpha;
    Surface surface;
    surface.n_dot_v = max(n_dot_v, 1e-4);
    surface.alpha_squared = alpha * alpha;
    surface.f0 = mix(vec3(dielectric_f0), albedo, material.z);
    // (1 - F(n.v)) (1 - F(n.l)) = (1 - f0)^2 (1 - weight(n.v)) (1 - weight(n.l)); the last factor is the light's.
    float entering = (1.0 - dielectric_f0) * (1.0 - dielectric_f0) * (1.0 - fresnel_weight(surface.n_dot_v));
    surface.diffuse = albedo * ((1.0 - material.z) * entering * inverse_pi);
    return surface;
}

/// Radiance towards v per unit of irradiance on a plane facing l, that is BRDF * n.l; never above what arrives.
/// Needs no normalised half vector: with unit v and l, v.h / |h| = |h| / 2.
vec3 reflected(Surface surface, vec3 n, vec3 v, vec3 l)
{
    vec3 h = v + l;
    float n_dot_l = max(dot(n, l), 0.0);
    float n_dot_h = dot(n, h);
    vec3 across = cross(n, h);
    float h_squared = dot(h, h);
    float per_h = 1.0 / h_squared;
    float lobe = ggx_lobe(n_dot_l, surface.n_dot_v, n_dot_h * n_dot_h * per_h, dot(across, across) * per_h,
                          surface.alpha_squared);
    vec3 specular = fresnel(surface.f0, 0.5 * sqrt(h_squared)) * lobe;
    vec3 diffuse = surface.diffuse * (1.0 - fresnel_weight(n_dot_l));
    return (specular + diffuse) * n_dot_l;
}
