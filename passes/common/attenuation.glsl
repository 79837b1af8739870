// How light thins out on its way from a point light.

/// Irradiance at a distance from a light of unit color, on a plane facing it; `distance_squared` and `radius` in metres.
/// Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 3.1.2: the inverse square, times a window
/// (1 - (d / r)^4)^2 that ends at the radius, so that a light may be skipped beyond it without a trace.
/// 1e-4 is a light of one centimetre: nearer, the irradiance stays at 10 000 instead of growing without end.
/// The comparison makes the end exact where a division would round, and turns off a light of radius 0.
float windowed_inverse_square(float distance_squared, float radius)
{
    float radius_squared = radius * radius;
    float ratio = distance_squared / radius_squared;
    float window = 1.0 - ratio * ratio;
    return distance_squared < radius_squared ? window * window / max(distance_squared, 1e-4) : 0.0;
}
