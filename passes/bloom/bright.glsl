/*{
  "pass": "bright",
  "summary": "Keeps what is brighter than a threshold, with a soft knee, and is black elsewhere.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "radiance" },
  "params": {
    "threshold": { "type": "float", "default": 0.8, "range": [0, 65504], "label": "Luminance where bloom begins" },
    "knee": { "type": "float", "default": 0.5, "range": [0, 1], "label": "Softness, as a share of the threshold" }
  },
  "identity": { "when": "threshold == 0", "is": "image" },
  // The luminance of a color is at most its largest channel; 1e-5 is for the roundings of a sum of three.
  "bound": "image * 1.00001 <= threshold - threshold * knee ? 0 : image * 1.00001",
  "black": ["image"],
  // Where the parabola of share_above_threshold begins, operation by operation: no difference is above 0 up to there.
  "skip": { "when": "luminance(image(uv)) <= threshold - threshold * knee", "value": 0 },
  "contract": { "non_finite": "contained", "laws": ["black", "energy", "monotone", "mirror"] },
  "source": "Jimenez 2014, Next Generation Post Processing in Call of Duty: Advanced Warfare"
}*/
#include "luminance.glsl"
#include "soft_threshold.glsl"

vec3 bright(vec2 uv)
{
    vec3 seen = image(uv);
    return seen * share_above_threshold(luminance(seen), threshold, knee); // one share for all channels keeps the hue
}
