/*{
  "pass": "blur_direction",
  "summary": "Blurs along rows or columns with a Gaussian; weights are point samples that sum to 1.",
  "inputs": { "image": { "signal": "color", "filter": { "sampling": { "linear_pairs": "linear" } } } },
  "outputs": { "blurred": "color" },
  "params": {
    "sigma": { "type": "float", "default": 2, "range": [0, 20], "unit": "texels", "static": true }
  },
  "choices": { "direction": { "items": ["horizontal", "vertical"], "default": "horizontal" } },
  // 5 to 25 cut the Gaussian off at 2, 4, 6 and 12 texels: at 3 sigma, 99.7 % of it is inside. learnopengl5 is the
  // 2017 demo's: five distinct weights, hence nine taps, of a sigma of about 1.7 whatever `sigma` says, unless it is 0.
  "ladders": {
    "taps": { "items": ["5", "9", "13", "25", "learnopengl5"], "default": "13", "reference": "gaussian" },
    // linear_pairs reads two neighbours with one linear tap between them: half the reads, each of two to four texels.
    "sampling": { "items": ["linear_pairs", "nearest_taps"], "default": "nearest_taps", "reference": "gaussian" }
  },
  "identity": { "when": "sigma == 0", "is": "image" },
  "black": ["image"],
  "bound": "image * 1.001", // weights sum to 1 as far as a filter's rounding goes
  "contract": {
    // A linear tap reads its neighbors at a weight of 0, too, and 0 * NaN is NaN.
    "non_finite": {
      "contained": "(taps == taps_25 ? 12 : taps == taps_13 ? 6 : taps == taps_5 ? 2 : 4) + (sampling == sampling_linear_pairs ? 1 : 0)"
    },
    "laws": ["constant", "black", "energy", "monotone", "mirror", "scale"]
  },
  "source": "separable Gaussian; learnopengl5: de Vries, LearnOpenGL, Bloom; linear pairs: Rakos 2010, Efficient Gaussian blur with linear sampling"
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
const float table[5] = float[5](0.227027, 0.1945946, 0.1216216, 0.054054, 0.016216);

float weight(int distance_in_texels)
{
    return sigma > 0.0 ? table[distance_in_texels] : float(distance_in_texels == 0);
}

float share_of_next(int distance_in_texels)
{
    return table[distance_in_texels + 1] / (table[distance_in_texels] + table[distance_in_texels + 1]);
}
#else
// Below a sigma of 1e-3 all weights but the first are 0 in binary32; the bound makes sigma 0 the same, not 0 / 0.
const float twice_variance = 2.0 * max(sigma * sigma, 1e-6);

float weight(int distance_in_texels)
{
    float x = float(distance_in_texels);
    return exp(-x * x / twice_variance);
}

/// w(i + 1) / (w(i) + w(i + 1)), which is 1 / (1 + exp((2 i + 1) / (2 sigma^2))); exp(80) still is a binary32.
float share_of_next(int distance_in_texels)
{
    return 1.0 / (1.0 + exp(min(float(2 * distance_in_texels + 1) / twice_variance, 80.0)));
}
#endif

/// Each weight stands for a pair. Nearest taps by default: on software rasterisers a linear tap costs two of them.
vec3 blur_direction(vec2 uv)
{
#if direction == direction_horizontal
    vec2 texel = vec2(image_texel().x, 0.0);
#else
    vec2 texel = vec2(0.0, image_texel().y);
#endif
    vec3 sum = image(uv) * weight(0);
    float total = weight(0);
#if sampling == sampling_linear_pairs
    for (int pair = 1; pair <= reach / 2; ++pair) { // every reach is even
        int i = 2 * pair - 1;
        float both = weight(i) + weight(i + 1);
        vec2 offset = (float(i) + share_of_next(i)) * texel; // a linear tap there reads the two by their weights
        sum += (image(uv - offset) + image(uv + offset)) * both;
        total += 2.0 * both;
    }
#else
    for (int i = 1; i <= reach; ++i) {
        vec2 offset = float(i) * texel;
        sum += (image(uv - offset) + image(uv + offset)) * weight(i);
        total += 2.0 * weight(i);
    }
#endif
    return sum / total;
}
