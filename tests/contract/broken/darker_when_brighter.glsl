/*{
  "pass": "darker_when_brighter",
  "summary": "Broken on purpose: a tone curve that comes down again beyond its peak.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "display" },
  "contract": { "domain": { "image": [0, 100] }, "non_finite": "contained", "laws": ["black", "monotone"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 darker_when_brighter(vec2 uv)
{
    vec3 seen = image(uv);
    return 2.0 * seen / (1.0 + seen * seen);
}
