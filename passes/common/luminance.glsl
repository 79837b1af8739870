// How bright a color looks.

/// Relative luminance of linear RGB with Rec. 709 primaries (ITU-R BT.709-6, 3.2); the weights sum to 1.
float luminance(vec3 linear)
{
    return dot(linear, vec3(0.2126, 0.7152, 0.0722));
}
