/*{
  "pass": "keep_normal",
  "summary": "Stores normals once more, to see what a codec makes of them.",
  "inputs": { "image": "normal" },
  "outputs": { "kept": "normal" },
  "source": "the identity"
}*/
vec3 keep_normal(vec2 uv)
{
    return image(uv);
}
