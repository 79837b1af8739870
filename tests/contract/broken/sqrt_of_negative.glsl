/*{
  "pass": "sqrt_of_negative",
  "summary": "Broken on purpose: rebuilds a normal's z from x and y that are longer than 1 together.",
  "inputs": { "codes": "material" },
  "outputs": { "normal": "normal" },
  "contract": { "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 sqrt_of_negative(vec2 uv)
{
    vec2 xy = codes(uv).xy * 2.0 - 1.0;
    vec3 n = vec3(xy, sqrt(1.0 - dot(xy, xy)));
    return n / length(n);
}
