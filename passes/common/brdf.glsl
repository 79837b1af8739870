// What an opaque surface makes of light: a lobe of microfacets with a Fresnel edge, over a Lambert ground.
// Directions are unit vectors pointing away from the surface: n its normal, v to the viewer, l to the light; h = v + l
// is the half vector, not normalised. alpha is roughness squared, so alpha_squared is roughness to the fourth.
#include "distribution.glsl"
#include "fresnel.glsl"
#include "masking.glsl"
#include "saturated.glsl"

// The models of each term: the choices of the passes that light, in their order.
const int distribution_of_ggx = 0;
const int distribution_of_beckmann = 1;
const int fresnel_of_schlick = 0;
const int fresnel_of_dielectrics = 1;
const int geometry_smith_correlates = 0;
const int geometry_smith_separates = 1;
const int geometry_of_cook_torrance = 2;
const int geometry_of_neumann = 3;

/// Which formula stands for each term. Always constants, so that a compiler leaves only what is chosen.
struct Terms {
    int facets; ///< distribution
    int edge;   ///< Fresnel
    int hiding; ///< geometry
    int form;   ///< of GGX
    int power;  ///< of Schlick's edge
    int masking; ///< of Beckmann's facets
};

// Below it the highlight of a point light is a few pixels' noise and its peak, 1 / (pi alpha^2) = 77 625, leaves half.
const float smallest_roughness = 0.045;

/// What a surface's material says to the functions below; independent of the light.
struct Surface {
    vec3 diffuse;        ///< Lambert's albedo / pi, weighted by what the specular layer lets in and out towards v
    vec3 f0;             ///< reflectance at normal incidence, of metal and dielectric mixed
    vec3 metal_f0;
    float dielectric_f0;
    float metallic;
    float alpha_squared;
    float n_dot_v;  ///< at least 1e-4
    float v_hidden; ///< n.v Lambda(v), what facets hide from the viewer
};

/// n.x Lambda(x) for the chosen facets; 0 for geometry terms that do not ask for it.
float hidden_of(Terms terms, float cosine, float alpha_squared)
{
    if (terms.hiding != geometry_smith_correlates && terms.hiding != geometry_smith_separates)
        return 0.0;
    return terms.facets == distribution_of_beckmann ? beckmann_hidden(cosine, alpha_squared, terms.masking)
                                                    : ggx_hidden(cosine, alpha_squared);
}

/// G / (4 n.l n.v), per steradian. `n_dot_h` and `v_dot_h` are cosines, of an h of length 1.
float visibility_of(Terms terms, float n_dot_l, float n_dot_v, float n_dot_h, float v_dot_h, float l_hidden, float v_hidden)
{
    if (terms.hiding == geometry_smith_correlates)
        return smith_correlated_visibility(n_dot_l, n_dot_v, l_hidden, v_hidden);
    if (terms.hiding == geometry_smith_separates)
        return smith_separable_visibility(n_dot_l, n_dot_v, l_hidden, v_hidden);
    if (terms.hiding == geometry_of_cook_torrance)
        return cook_torrance_visibility(n_dot_l, n_dot_v, n_dot_h, v_dot_h);
    if (terms.hiding == geometry_of_neumann)
        return neumann_visibility(n_dot_l, n_dot_v);
    return implicit_visibility();
}

/// D of a half vector of any length.
float density_of(Terms terms, vec3 n, vec3 h, float n_dot_h, float length_squared, float alpha_squared)
{
    if (terms.facets == distribution_of_ggx && terms.form != lagrange_form) {
        float cosine = length_squared > 0.0 ? n_dot_h * inversesqrt(length_squared) : 0.0;
        if (terms.form == textbook_form)
            return ggx_textbook(cosine, alpha_squared);
        return ggx_distribution(cosine * cosine, (1.0 - cosine) * (1.0 + cosine), 1.0, alpha_squared);
    }
    vec3 across = cross(n, h);
    float cos_squared = n_dot_h * n_dot_h;
    float sin_squared = dot(across, across);
    if (terms.facets == distribution_of_beckmann)
        return beckmann_distribution(cos_squared, sin_squared, length_squared, alpha_squared);
    return ggx_distribution(cos_squared, sin_squared, length_squared, alpha_squared);
}

/// A surface from the G-buffer's values, `material` being specular, roughness, metallic; what is outside [0, 1] or not a number
/// is brought inside.
/// A normal turned away from the viewer, which interpolation makes at silhouettes, is lit as if seen edge-on, so that
/// nothing jumps where n.v changes sign; 1e-4 as in Filament's clampNoV.
/// glTF 2.0 and KHR_materials_specular: dielectrics reflect 0.08 * specular at normal incidence, metals their albedo.
Surface make_surface(vec3 albedo, vec3 material, float n_dot_v, Terms terms)
{
    vec3 base = saturated(albedo);
    float metallic = saturated(material.z);
    float roughness = material.y > smallest_roughness ? min(material.y, 1.0) : smallest_roughness;
    float alpha = roughness * roughness;
    Surface surface;
    surface.dielectric_f0 = 0.08 * saturated(material.x);
    surface.n_dot_v = n_dot_v > 1e-4 ? n_dot_v : 1e-4;
    surface.alpha_squared = alpha * alpha;
    surface.v_hidden = hidden_of(terms, surface.n_dot_v, surface.alpha_squared);
    surface.metallic = metallic;
    surface.metal_f0 = base;
    surface.f0 = mix(vec3(surface.dielectric_f0), base, metallic);
    // Light enters once and leaves once: (1 - F(n.l)) (1 - F(n.v)) never gives out what the lobe above reflects already.
    // Schlick's 1 - F(x) = (1 - f0) (1 - weight(x)) leaves only 1 - weight(n.l) to the light.
    float leaving = 1.0 - surface.dielectric_f0;
    float entering = leaving * leaving * (1.0 - fresnel_weight(surface.n_dot_v, terms.power));
    if (terms.edge == fresnel_of_dielectrics)
        entering = 1.0 - fresnel_exact(surface.dielectric_f0, surface.n_dot_v);
    surface.diffuse = base * ((1.0 - metallic) * entering * inverse_pi);
    return surface;
}

/// F at the facet, per channel. Schlick's is linear in f0, so metal and dielectric may be mixed before; the exact one is not:
/// half of each reflects half of what each does, or it would give out more than arrives.
vec3 fresnel_of(Surface surface, float v_dot_h, Terms terms)
{
    if (terms.edge == fresnel_of_dielectrics)
        return mix(vec3(fresnel_exact(surface.dielectric_f0, v_dot_h)),
                   vec3(fresnel_exact(surface.metal_f0.x, v_dot_h), fresnel_exact(surface.metal_f0.y, v_dot_h),
                        fresnel_exact(surface.metal_f0.z, v_dot_h)),
                   surface.metallic);
    return surface.f0 + (vec3(1.0) - surface.f0) * fresnel_weight(v_dot_h, terms.power);
}

/// The diffuse ground's share of light from n.l, with what the lobe above reflects of it taken off.
vec3 diffuse_of(Surface surface, float n_dot_l, Terms terms)
{
    if (terms.edge == fresnel_of_dielectrics)
        return surface.diffuse * (1.0 - fresnel_exact(surface.dielectric_f0, n_dot_l));
    return surface.diffuse * (1.0 - fresnel_weight(n_dot_l, terms.power));
}

/// Radiance towards v per unit of irradiance on a plane facing l, that is BRDF * n.l; never above what arrives, and 0 from
/// below the surface. Needs no normalised half vector: with unit v and l, v.h / |h| = |h| / 2.
vec3 reflected(Surface surface, vec3 n, vec3 v, vec3 l, Terms terms)
{
    vec3 h = v + l;
    float n_dot_l = dot(n, l);
    n_dot_l = n_dot_l > 0.0 ? n_dot_l : 0.0; // may round above 1, which every term bears
    float n_dot_h = dot(n, h);
    float h_squared = dot(h, h);
    float v_dot_h = 0.5 * sqrt(h_squared);
    float n_dot_unit_h = n_dot_h * inversesqrt(h_squared); // no number where l = -v: D is 0 there, and V some number
    float lobe = density_of(terms, n, h, n_dot_h, h_squared, surface.alpha_squared) *
                 visibility_of(terms, n_dot_l, surface.n_dot_v, n_dot_unit_h, v_dot_h,
                               hidden_of(terms, n_dot_l, surface.alpha_squared), surface.v_hidden);
    return (fresnel_of(surface, v_dot_h, terms) * lobe + diffuse_of(surface, n_dot_l, terms)) * n_dot_l;
}
