/*{
  "pass": "pow_of_negative",
  "summary": "Broken on purpose: a power of what is negative in the dark.",
  "inputs": { "image": "radiance" },
  "outputs": { "color": "display" },
  "contract": { "domain": { "image": [0, 1] }, "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 pow_of_negative(vec2 uv)
{
    vec3 lifted = (image(uv) - 0.1) / 0.9;
    return min(pow(lifted, vec3(1.0 / 2.2)), vec3(1.0));
}
