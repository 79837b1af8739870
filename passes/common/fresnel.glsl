// How much of light a smooth boundary reflects, by the cosine of the angle of incidence.

// How the weight of Schlick's edge is raised to the fifth power: the rungs of a ladder, in its order.
const int power_by_pow = 0;
const int power_by_multiplications = 1;

/// (1 - cosine)^5, Schlick's blend towards white at grazing angles, 0 for a cosine that rounds above 1.
/// pow is 31 ulp off on llvmpipe and undefined for a negative base; three multiplications are 2 ulp off and quicker.
float fresnel_weight(float cosine, int power)
{
    float x = 1.0 - cosine;
    if (power == power_by_pow)
        return x > 0.0 ? pow(x, 5.0) : 0.0;
    float x2 = x * x;
    return x2 * x2 * x;
}

/// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15: from the weight above.
float fresnel_schlick(float f0, float weight)
{
    return f0 + (1.0 - f0) * weight;
}

/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 22: unpolarised light on a
/// dielectric that reflects f0 at normal incidence, so of the index n = (1 + sqrt f0) / (1 - sqrt f0).
/// Rearranged so that nothing cancels: 1 - sqrt f0 = (1 - f0) / (1 + sqrt f0), so n^2 - 1 = 4 s (1 + s)^2 / (1 - f0)^2, and
/// (g - c) / (g + c) = (n^2 - 1) / (g + c)^2. f0 = 1 is an infinite index; f0 = 0 with c = 0 is 0 / 0, and reflects all.
float fresnel_exact(float f0, float cosine)
{
    float c = cosine > 0.0 ? min(cosine, 1.0) : 0.0;
    float s = sqrt(f0);
    float contrast = (1.0 + s) / (1.0 - f0);
    float n2_less_1 = 4.0 * s * contrast * contrast;
    float g = sqrt(n2_less_1 + c * c);
    float across = n2_less_1 / ((g + c) * (g + c));
    float along = (c * (g + c) - 1.0) / (c * n2_less_1 / (g + c) + 1.0);
    float reflected = 0.5 * across * across * (1.0 + along * along);
    return f0 < 1.0 && g + c > 0.0 ? reflected : 1.0;
}
