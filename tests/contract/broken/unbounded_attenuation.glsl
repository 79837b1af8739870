/*{
  "pass": "unbounded_attenuation",
  "summary": "Broken on purpose: light thins out with the square of a distance that may be 0.",
  "reads": ["lights"],
  "inputs": { "position": "position" },
  "outputs": { "color": "radiance" },
  "contract": { "range": { "color": [0, "saturated"] }, "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 unbounded_attenuation(vec2 uv)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < light_count(); ++i) {
        vec3 way = light(i).position - position(uv);
        sum += light(i).color / dot(way, way);
    }
    return sum;
}
