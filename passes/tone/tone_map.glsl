/*{
  "pass": "tone_map",
  "summary": "Brings radiance onto a display: the filmic curve of Uncharted 2, then the one and only sRGB encoding.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "display" },
  "params": {
    "exposure": { "type": "float", "default": 1, "range": [0.01, 100], "scale": "log" },
    "white": { "type": "float", "default": 11.2, "range": [1, 100], "static": true, "label": "Radiance shown as white" }
  },
  // rational is 0.03 of an 8-bit code off, less than its rounding, in less time.
  "ladders": {
    "curve": { "items": ["table", "exact"], "default": "exact", "reference": "filmic_display" },
    "transfer": { "items": ["gamma_2_2", "rational", "exact"], "default": "rational", "reference": "filmic_display" }
  },
  "black": ["image"],
  "contract": { "non_finite": "replaced", "laws": ["black", "monotone", "mirror"] },
  "source": "Hable 2010, Uncharted 2: HDR Lighting; IEC 61966-2-1"
}*/
#include "filmic_table.glsl"
#include "hable.glsl"
#include "srgb.glsl"

float filmic(float x)
{
    // The 2017 demo's curve: shoulder 0.22, linear 0.30, angle 0.10; toe 0.20, its numerator 0.01, denominator 0.30.
#if curve == curve_table
    float limited = x > 0.0 ? min(x, white) : 0.0;
    return filmic_from_table(limited) / filmic_from_table(white);
#else
    return hable(x, white, vec3(0.22, 0.30, 0.10), vec3(0.20, 0.01, 0.30));
#endif
}

vec3 tone_map(vec2 uv)
{
    vec3 exposed = exposure * image(uv);
    vec3 toned = vec3(filmic(exposed.x), filmic(exposed.y), filmic(exposed.z));
#if transfer == transfer_gamma_2_2
    return gamma_2_2_encode(toned);
#elif transfer == transfer_rational
    return srgb_encode_rational(toned);
#else
    return srgb_encode(toned);
#endif
}
