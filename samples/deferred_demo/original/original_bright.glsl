/*{
  "pass": "original_bright",
  "summary": "What is brighter than a threshold; where the original left its output unwritten, the black it hoped for.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "radiance" },
  "params": { "threshold": { "type": "float", "default": 0.8, "range": [0, 65504] } },
  "source": "reconstructed from the description of the 2017 demo"
}*/
#include "luminance.glsl"

vec3 original_bright(vec2 uv)
{
    vec3 seen = image(uv);
    return luminance(seen) > threshold ? seen : vec3(0.0);
}
