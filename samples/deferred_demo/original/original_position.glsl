/*{
  "pass": "original_position",
  "summary": "A place rebuilt from a radial distance as if it had been a perspective depth.",
  "reads": ["camera"],
  "inputs": { "position": "position" },
  "outputs": { "place": "position" },
  "params": { "near": 1, "far": 2001 },
  "source": "reconstructed from the description of the 2017 demo"
}*/
vec3 original_position(vec2 uv)
{
    float stored = length(position(uv)) / far;                                  // what went into the target
    float z = 2.0 * near * far / (far + near - (2.0 * stored - 1.0) * (far - near)); // what it was taken for
    return stored > 0.0 ? view_ray(uv) * z : vec3(0.0);
}
