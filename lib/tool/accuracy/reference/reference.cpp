// The references that fit on a screen: angles, lobes, curves, places.
#include "tool/accuracy/reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace passgraph::reference {
namespace {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double cross_length(const Vector& a, const Vector& b)
{
    return std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

} // namespace

double angle_degrees(const Vector& a, const Vector& b)
{
    return std::atan2(cross_length(a, b), dot(a, b)) * (180.0 / std::numbers::pi);
}

double ggx_density(const Vector& normal, const Vector& half, double alpha)
{
    const double angle = std::atan2(cross_length(normal, half), dot(normal, half));
    const double cosine = std::cos(angle);
    if (cosine <= 0.0)
        return 0.0;
    const double tangent = std::tan(angle);
    const double bracket = alpha * alpha + tangent * tangent;
    return alpha * alpha / (std::numbers::pi * std::pow(cosine, 4.0) * bracket * bracket);
}

double schlick_weight(double cosine) { return std::pow(std::max(1.0 - cosine, 0.0), 5.0); }

double beckmann_seen(double cosine, double alpha)
{
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    if (sine == 0.0)
        return 1.0;
    const double a = cosine / (alpha * sine);
    const double lambda = std::exp(-a * a) / (2.0 * a * std::sqrt(std::numbers::pi)) - 0.5 * std::erfc(a);
    return 1.0 / (1.0 + lambda);
}

double filmic(double radiance, double white, const FilmicConstants& k)
{
    const auto curve = [&](double x) {
        return (x * (k.shoulder * x + k.linear_angle * k.linear) + k.toe * k.toe_numerator) /
                   (x * (k.shoulder * x + k.linear) + k.toe * k.toe_denominator) -
               k.toe_numerator / k.toe_denominator;
    };
    return radiance > 0.0 ? curve(std::min(radiance, white)) / curve(white) : 0.0;
}

double srgb_encode(double linear)
{
    if (!(linear > 0.0))
        return 0.0;
    const double x = std::min(linear, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

Vector place_at_distance(double x, double y, int width, int height, double vertical_fov, double distance)
{
    const double up = std::tan(0.5 * vertical_fov);
    const double right = up * width / height;
    return {(2.0 * (x + 0.5) / width - 1.0) * right * distance, (2.0 * (y + 0.5) / height - 1.0) * up * distance, -distance};
}

} // namespace passgraph::reference
