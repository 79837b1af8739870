// Where a surface's texels are in the texture atlas: what passgraph/scene/atlas.hpp does on the host, in its words.

/// A coordinate inside [0, 1] under a wrap mode: 0 repeats, 1 mirrors, 2 clamps.
/// OpenGL 4.6 specification, table 8.20, for coordinates instead of texels. fract(-1e-9) rounds to 1, which would be
/// the next cell's side; 0.99999994 is the float before 1. NaN gives 0: it fails every comparison, where min, max and
/// clamp may give anything.
float atlas_wrap(float x, int mode)
{
    if (mode == 2)
        return x > 0.0 ? min(x, 1.0) : 0.0;
    if (mode == 1) {
        float turn = x - 2.0 * floor(0.5 * x);
        return turn > 1.0 ? 2.0 - turn : (turn > 0.0 ? turn : 0.0);
    }
    float fraction = x - floor(x);
    return fraction > 0.0 ? min(fraction, 0.99999994) : 0.0;
}

/// The level, 0 to `last`, whose texels match a pixel; the gradients of the unwrapped uv in texels of level 0.
/// OpenGL 4.6 specification, section 8.14, NEAREST between levels: round(log2(the longer gradient)). From the square's
/// exponent, without a logarithm: lengths from 2^(k - 1/2) to 2^(k + 1/2) have squares with exponent 2 k - 1 or 2 k.
/// The exponent of a float begins at bit 23 and is 127 too large; infinity has the largest; NaN is passed over.
int atlas_level(vec2 dx_texels, vec2 dy_texels, int last)
{
    float along_x = dot(dx_texels, dx_texels);
    float along_y = dot(dy_texels, dy_texels);
    float squared = along_x > 1.0 ? along_x : 1.0;
    squared = along_y > squared ? along_y : squared;
    int exponent_and_one = (floatBitsToInt(squared) >> 23) - 126;
    return min(exponent_and_one >> 1, last);
}

/// The place of `inside`, wrapped coordinates, in a level's rectangle: x, y, width, height, in texels or as uv alike.
/// Own derivation. On the rectangle's border a linear fetch reads the gutter of one texel, which continues the texture.
vec2 atlas_place(vec4 rect, vec2 inside)
{
    return rect.xy + inside * rect.zw;
}
