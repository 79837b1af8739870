// How light thins out on its way from a point light.

/// Irradiance at a distance from a light of unit color, on a plane facing it; metres squared.
/// Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 3.1.2: the inverse square, times a window
/// (1 - (d / r)^4)^2 that ends at the radius, so that a light may be skipped beyond it without a trace.
/// 1e-4 is a light of one centimetre: nearer, the irradiance stays at 10 000 instead of growing without end.
/// `per_radius_squared` is 1 / r^2 rounded up, so that the product reaches 1, and the window 0, wherever d^2 reaches r^2;
/// 0 is a light without an end.
float windowed_inverse_square(float distance_squared, float per_radius_squared)
{
    float ratio = distance_squared * per_radius_squared;
    float window = 1.0 - ratio * ratio;
    return ratio < 1.0 ? window * window / max(distance_squared, 1e-4) : 0.0;
}

/// A spot light's share of its light where `ramp` = (cos - cos outer) / (cos inner - cos outer), cos being that of the angle
/// with its axis: 0 outside its outer cone, 1 inside its inner one, the square of the ramp between them.
/// KHR_lights_punctual, "Inner and Outer Cone Angles".
float cone_share(float ramp)
{
    float inside = ramp > 0.0 ? min(ramp, 1.0) : 0.0;
    return inside * inside;
}
