/*{
  "pass": "acos_above_one",
  "summary": "Broken on purpose: the angle between a vector and itself, whose cosine rounds above 1.",
  "inputs": { "normal": "normal" },
  "outputs": { "angle": "mask" },
  "contract": { "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
float acos_above_one(vec2 uv)
{
    vec3 n = normal(uv);
    return acos(dot(n, n)) / 3.14159266;
}
