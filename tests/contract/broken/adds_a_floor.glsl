/*{
  "pass": "adds_a_floor",
  "summary": "Broken on purpose: lifts black, and says it does not.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "radiance" },
  "contract": { "domain": { "image": [0, 1000] }, "non_finite": "contained", "laws": ["black", "scale"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 adds_a_floor(vec2 uv)
{
    return image(uv) + 1e-3;
}
