/*{
  "pass": "gains_energy",
  "summary": "Broken on purpose: a diffuse reflection that forgot to divide by pi.",
  "inputs": { "albedo": "albedo", "arriving": "radiance" },
  "outputs": { "color": "radiance" },
  "contract": { "range": { "color": [0, "saturated"] }, "non_finite": "contained", "laws": ["black", "energy", "scale"] },
  "source": "a mistake seen in many renderers"
}*/
vec3 gains_energy(vec2 uv)
{
    return albedo(uv) * arriving(uv) * 3.14159265;
}
