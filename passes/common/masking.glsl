// How facets hide one another from the light and from the viewer: G, in the form V = G / (4 n.l n.v), which is what a lobe
// needs and which has no 0 / 0 at grazing angles. Cosines are of directions above the surface.

// How Beckmann's masking is evaluated: the rungs of a ladder, in its order.
const int masking_by_rational = 0;
const int masking_by_erf = 1;

/// Walter et al. 2007, eq. 34, as n.x Lambda(x) of G1 = 1 / (1 + Lambda): what facets hide of a direction's cosine.
float ggx_hidden(float cosine, float alpha_squared)
{
    return 0.5 * (sqrt(alpha_squared + (1.0 - alpha_squared) * cosine * cosine) - cosine);
}

/// Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 72, as n.x Lambda(x), with a = 1 / (alpha tan).
/// erfc by Abramowitz and Stegun 1964, 7.1.26: within 1.5e-7, which is G's own error. The rational rung is Walter et al.
/// 2007, eq. 35, within 0.32 %. Divided by no cosine: at grazing angles alpha / (2 sqrt pi) is left.
float beckmann_hidden(float cosine, float alpha_squared, int masking)
{
    float sine_squared = (1.0 - cosine) * (1.0 + cosine);
    float slope = sqrt(alpha_squared * sine_squared); // alpha sin; 0 hides nothing, below
    float a = cosine / slope;
    float hidden;
    if (masking == masking_by_rational) {
        hidden = a < 1.6 ? slope * (1.0 + a * (0.396 * a - 1.259)) / (3.535 + 2.181 * a) : 0.0;
    } else {
        float t = 1.0 / (1.0 + 0.3275911 * a);
        float tail = t * (0.254829592 + t * (t * (1.421413741 + t * (1.061405429 * t - 1.453152027)) - 0.284496736));
        hidden = 0.5 * exp(-a * a) * (0.564189583547756287 * slope - cosine * tail);
    }
    return slope > 0.0 ? hidden : 0.0;
}

/// Heitz 2014, eq. 99, height-correlated: G = 1 / (1 + Lambda(l) + Lambda(v)). `l_hidden` is n.l Lambda(l).
float smith_correlated_visibility(float n_dot_l, float n_dot_v, float l_hidden, float v_hidden)
{
    float area = n_dot_l * n_dot_v + n_dot_v * l_hidden + n_dot_l * v_hidden;
    return area > 0.0 ? 0.25 / area : 0.0;
}

/// Walter et al. 2007, eq. 23: G = G1(l) G1(v), as if hiding from one were independent of hiding from the other.
float smith_separable_visibility(float n_dot_l, float n_dot_v, float l_hidden, float v_hidden)
{
    float area = (n_dot_l + l_hidden) * (n_dot_v + v_hidden);
    return area > 0.0 ? 0.25 / area : 0.0;
}

/// Cook and Torrance 1982, section "Geometrical attenuation": G = min(1, 2 n.h n.v / v.h, 2 n.h n.l / v.h), V-shaped grooves.
/// The smaller of the two holds the smaller cosine, so V divides by the larger one, and by v.h only where that is not 0.
/// A normal turned away from the viewer has half vectors below it: they see nothing.
float cook_torrance_visibility(float n_dot_l, float n_dot_v, float n_dot_h, float v_dot_h)
{
    float most = max(n_dot_l, n_dot_v);
    float least = min(n_dot_l, n_dot_v);
    bool is_hidden = 2.0 * n_dot_h * least < v_dot_h;
    float area = is_hidden ? 2.0 * v_dot_h * most : 4.0 * least * most;
    return area > 0.0 ? (is_hidden ? (n_dot_h > 0.0 ? n_dot_h : 0.0) : 1.0) / area : 0.0;
}

/// Neumann et al. 1999, "Compact Metallic Reflectance Models": G = n.l n.v / max(n.l, n.v).
float neumann_visibility(float n_dot_l, float n_dot_v)
{
    float most = max(n_dot_l, n_dot_v);
    return most > 0.0 ? 0.25 / most : 0.0;
}

/// G = n.l n.v, for which the microfacet formula leaves no factor at all (Hoffman 2013, "Background: Physics and Math of
/// Shading", "implicit").
float implicit_visibility()
{
    return 0.25;
}
