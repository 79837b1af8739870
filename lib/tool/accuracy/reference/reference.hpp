// What each ladder approximates, in double precision on the CPU, from the literature's own formulas.
//
// Nothing here includes or is generated from the passes, and nothing here is tuned to them: the two meet in tests alone.
#pragma once

#include <array>
#include <vector>

namespace passgraph::reference {

using Vector = std::array<double, 3>;

/// The angle between two directions of any length, in degrees.
///
/// Range    0 to 180; exact to a few ulp near 0 too, where acos of a dot product has no digits left.
/// Source   Kahan 2006, "How Futile are Mindless Assessments of Roundoff", the atan2 of |a x b| and a . b.
double angle_degrees(const Vector& a, const Vector& b);

/// GGX's density of microfacets about a normal, per steradian, of two directions of any length.
///
/// Range    finite for alpha > 0; `alpha` is roughness squared.
/// Source   Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33, by the tangent.
double ggx_density(const Vector& normal, const Vector& half, double alpha);

/// Schlick's weight of the Fresnel edge, (1 - cosine)^5; 0 for a cosine that rounding left above 1.
/// Source   Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15.
double schlick_weight(double cosine);

/// The share of Beckmann's facets that a direction sees past the others, Smith's G1.
///
/// Range    `cosine` in (0, 1], of the direction and the surface's normal; `alpha` > 0, roughness squared.
/// Source   Heitz 2014, "Understanding the Masking-Shadowing Function", eq. 72.
double beckmann_seen(double cosine, double alpha);

/// The constants of Hable's curve; the default is the 2017 demo's.
struct FilmicConstants {
    double shoulder = 0.22;
    double linear = 0.30;
    double linear_angle = 0.10;
    double toe = 0.20;
    double toe_numerator = 0.01;
    double toe_denominator = 0.30;
};

/// Hable's filmic curve as published, 1 at `white` and beyond; 0 for what is not above 0.
/// Source   Hable 2010, "Uncharted 2: HDR Lighting".
double filmic(double radiance, double white, const FilmicConstants& constants = {});

/// Source   IEC 61966-2-1:1999, linear light to code; clamped to [0, 1].
double srgb_encode(double linear);

/// The weights of a Gaussian sampled at whole texels, from the middle outwards; twice all but the first and the first are 1.
/// Range    `sigma` > 0; reaches 9 sigma, beyond which 1e-17 of the whole is left.
std::vector<double> gaussian_weights(double sigma);

/// An image of interleaved channels blurred along rows and columns, the edge texel standing for those outside.
///
/// Shape    width * height * channels numbers, as given.
/// Cost     18 sigma products per number.
std::vector<double> gaussian_blur(const std::vector<double>& image, int width, int height, int channels, double sigma);

/// Where a ray from the eye through the middle of a pixel meets a plane of constant distance, view space, metres.
///
/// `vertical_fov` in radians; uv (0, 0) is the bottom left, the eye looks along -Z.
Vector place_at_distance(double x, double y, int width, int height, double vertical_fov, double distance);

} // namespace passgraph::reference
