/*{
  "pass": "position_from_depth",
  "summary": "Places in view space from depth: along the pixel's ray, as far as the depth says.",
  "reads": ["camera"],
  "inputs": { "depth": "depth" },
  "outputs": { "position": "position" },
  "contract": { "non_finite": "replaced" },
  "source": "own derivation; relative error 2^-23 with reversed depth32f, where an inverse view-projection is metres off"
}*/
vec3 position_from_depth(vec2 uv)
{
    // Depth 0 is the far end of everything, where no surface is: the viewer's own place says so.
    float seen = depth(uv);
    return seen > 0.0 ? view_ray(uv) * view_distance(seen) : vec3(0.0);
}
