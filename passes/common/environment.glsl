// How a surface reflects light that comes from everywhere, a sky, without integrating over it.

/// The share of a uniformly bright environment that a rough surface reflects is f0 * x + y; x + y never exceeds 1.
/// The split is that of Lazarov 2013, "Getting More Physical in Call of Duty: Black Ops II". His and Karis's fits are for
/// a darker visibility term than ours, by up to 0.28 at n.v >= 0.1; these two polynomials are our own, fitted to the
/// integral of ggx_lobe over 40 x 33 roughnesses and angles with the least largest error: 0.05 for n.v >= 0.04.
vec2 environment_reflectance(float roughness, float n_dot_v)
{
    float r = roughness;
    float v = n_dot_v;
    float x = 1.0 - v;
    float x2 = x * x;
    // What f0 = 1 loses to light that microfacets block, and what f0 = 0 gains from Schlick's edge.
    float loss = r * (0.4315 + r * (0.4396 * r - 0.7341) + v * (1.1771 * r - 0.4201 * v - 0.1525));
    float edge = x2 * x2 * x * (1.0651 + r * (1.312 * r - 2.4318) + v * (0.3982 * r - 3.7876 * v + 1.4367));
    float total = 1.0 - clamp(loss, 0.0, 1.0);
    float bias = clamp(edge, 0.0, total);
    return vec2(total - bias, bias);
}

/// The level of a cube map in which one texel covers the solid angle of a specular lobe.
/// Colbert and Krivanek 2007, "GPU-Based Importance Sampling" (GPU Gems 3, chapter 20): lod = log2(lobe / texel) / 2.
/// The lobe's solid angle is one over its peak density 1 / (4 pi alpha^2); the top level's texel is a face, 4 pi / 6.
float environment_lod(float alpha_squared, float top_lod)
{
    return clamp(top_lod + 0.5 * log2(6.0 * alpha_squared), 0.0, top_lod);
}
