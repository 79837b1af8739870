/*{
  "pass": "not_its_input",
  "summary": "Broken on purpose: says it is its input at an amount of 0, where it still brightens a little.",
  "inputs": { "image": "display" },
  "outputs": { "color": "display" },
  "params": { "amount": { "type": "float", "default": 1, "range": [0, 1] } },
  "identity": { "when": "amount == 0", "is": "image" },
  "contract": { "non_finite": "contained" },
  "source": "a mistake seen in many renderers"
}*/
vec3 not_its_input(vec2 uv)
{
    vec3 seen = image(uv);
    return mix(seen, sqrt(seen), 0.01 + 0.99 * amount);
}
