/*{
  "pass": "blur_direction",
  "summary": "Blurs along rows or columns with a Gaussian; weights are point samples that sum to 1.",
  "inputs": { "image": "color" },
  "outputs": { "blurred": "color" },
  "params": {
    "sigma": { "type": "float", "default": 2, "range": [0, 20], "unit": "texels", "static": true }
  },
  "choices": { "direction": { "items": ["horizontal", "vertical"], "default": "horizontal" } },
  // 5 to 25 cut the Gaussian off at 2, 4, 6 and 12 texels: at 3 sigma, 99.7 % of it is inside. learnopengl5 is the
  // 2017 demo's: five distinct weights, hence nine taps, of a sigma of about 1.7 whatever `sigma` says, unless it is 0.
  "ladders": { "taps": { "items": ["5", "9", "13", "25", "learnopengl5"], "default": "13" } },
  "identity": { "when": "sigma == 0", "is": "image" },
  "source": "separable Gaussian; learnopengl5: de Vries, LearnOpenGL, Bloom"
}*/
#if taps == taps_5
const int reach = 2;
#elif taps == taps_13
const int reach = 6;
#elif taps == taps_25
const int reach = 12;
#else
const int reach = 4;
#endif

#if taps == taps_learnopengl5
float weight(int distance_in_texels)
{
    const float table[5] = float[5](0.227027, 0.1945946, 0.1216216, 0.054054, 0.016216);
    return sigma > 0.0 ? table[distance_in_texels] : float(distance_in_texels == 0);
}
#else
float weight(int distance_in_texels)
{
    // Below a sigma of 1e-3 all weights but the first are 0 in binary32; the bound makes sigma 0 the same, not 0 / 0.
    float x = float(distance_in_texels);
    return exp(-0.5 * x * x / max(sigma * sigma, 1e-6));
}
#endif

/// Nearest taps, each weight for a pair: on software rasterisers a linear tap costs two nearest ones.
vec3 blur_direction(vec2 uv)
{
#if direction == direction_horizontal
    vec2 texel = vec2(image_texel().x, 0.0);
#else
    vec2 texel = vec2(0.0, image_texel().y);
#endif
    vec3 sum = image(uv) * weight(0);
    float total = weight(0);
    for (int i = 1; i <= reach; ++i) {
        vec2 offset = float(i) * texel;
        sum += (image(uv - offset) + image(uv + offset)) * weight(i);
        total += 2.0 * weight(i);
    }
    return sum / total;
}
