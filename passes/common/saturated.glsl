// Values brought into [0, 1] by comparisons, which send what is not a number to 0 on every driver; clamp need not.

float saturated(float x)
{
    return x > 0.0 ? min(x, 1.0) : 0.0;
}

vec3 saturated(vec3 v)
{
    return vec3(saturated(v.x), saturated(v.y), saturated(v.z));
}
