// The transfer curve of sRGB.

/// IEC 61966-2-1: linear light to code, per channel; the two pieces meet within 3e-8.
float srgb_encode(float x)
{
    return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
}

vec3 srgb_encode(vec3 linear)
{
    return vec3(srgb_encode(linear.x), srgb_encode(linear.y), srgb_encode(linear.z));
}
