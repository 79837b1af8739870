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

/// Own fit: a quotient of quadratics in sqrt(x) that is 1 at 1, of least largest error above the joint, 1.31e-4 (0.033 of an
/// 8-bit code). A square root and a quotient cost less than pow, which is a logarithm and an exponential.
float srgb_encode_rational(float x)
{
    float s = sqrt(max(x, 0.0));
    float curve = (-0.0435966253 + s * (1.43957949 + s * 4.3725324)) / (1.0 + s * (4.4115963 + s * 0.356918603));
    return x <= 0.0031308 ? 12.92 * x : curve;
}

vec3 srgb_encode_rational(vec3 linear)
{
    return vec3(srgb_encode_rational(linear.x), srgb_encode_rational(linear.y), srgb_encode_rational(linear.z));
}

/// The folk approximation x^(1 / 2.2): 0.034 off near black, where it is far too bright.
vec3 gamma_2_2_encode(vec3 linear)
{
    return pow(max(linear, vec3(0.0)), vec3(1.0 / 2.2));
}
