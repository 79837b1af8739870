/*{
  "pass": "log_of_zero",
  "summary": "Broken on purpose: the logarithm of a black pixel's luminance.",
  "inputs": { "image": "radiance" },
  "outputs": { "weight": "mask" },
  "contract": { "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
float log_of_zero(vec2 uv)
{
    float luminance = dot(image(uv), vec3(0.2126, 0.7152, 0.0722));
    return clamp(0.5 + 0.05 * log2(luminance), 0.0, 1.0);
}
