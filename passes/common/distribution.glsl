// How the facets of a rough surface are turned: densities D(h) per steradian of the surface's cosine-weighted normals.
// alpha is roughness squared; cos and sin are of the angle between the surface's normal and the half vector.

const float inverse_pi = 0.318309886183790672;

// How GGX is evaluated: the rungs of a ladder, in its order.
const int textbook_form = 0;
const int difference_of_squares_form = 1;
const int lagrange_form = 2;

/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33, as textbooks print it.
/// 1 - cos^2, hidden in the bracket, cancels: a rounding of the cosine is magnified by up to 4 / alpha^2, which is 2 % of D
/// at roughness 0.045 for half of all directions. At alpha 0 a peak of no width has no height either.
float ggx_textbook(float cosine, float alpha_squared)
{
    float bracket = cosine * cosine * (alpha_squared - 1.0) + 1.0;
    float squared = bracket * bracket;
    return squared > 0.0 ? inverse_pi * alpha_squared / squared : 0.0;
}

/// The same, from sin^2 taken without the cancellation: (1 - cos) (1 + cos) keeps the cosine's own rounding,
/// |n x h|^2 (Lagrange's identity) has none of it: 1e-5 where the textbook's form is 9 % off.
/// `cos_squared` and `sin_squared` may be those of a half vector of any length, `length_squared` their sum: D = alpha^2 |h|^4
/// / (pi (alpha^2 (n.h)^2 + |n x h|^2)^2) saves its normalisation. Nothing is reflected by a half vector of length 0.
float ggx_distribution(float cos_squared, float sin_squared, float length_squared, float alpha_squared)
{
    float bracket = cos_squared * alpha_squared + sin_squared;
    float squared = bracket * bracket;
    return squared > 0.0 ? inverse_pi * alpha_squared * length_squared * length_squared / squared : 0.0;
}

/// Cook and Torrance 1982, "A Reflectance Model for Computer Graphics", eq. 7, normalised as in Walter 2007, eq. 25.
/// tan^2 = sin^2 / cos^2 needs no half vector of length 1; cos^4 is taken of one. exp ends at 0 quietly.
float beckmann_distribution(float cos_squared, float sin_squared, float length_squared, float alpha_squared)
{
    float stretched = alpha_squared * cos_squared;
    float density = inverse_pi * exp(-sin_squared / stretched) * length_squared * length_squared;
    float area = stretched * cos_squared;
    return stretched > 0.0 && area > 0.0 ? density / area : 0.0;
}
