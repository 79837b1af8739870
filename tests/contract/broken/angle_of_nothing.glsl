/*{
  "pass": "angle_of_nothing",
  "summary": "Broken: the hue of what has none.",
  "inputs": { "image": "radiance" },
  "outputs": { "hue": "mask" }
}*/
float angle_of_nothing(vec2 uv)
{
    vec3 seen = image(uv);
    return 0.5 + 0.5 * sin(atan(1.7320508 * (seen.g - seen.b), 2.0 * seen.r - seen.g - seen.b));
}
