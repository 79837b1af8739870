/*{
  "pass": "vignette",
  "summary": "Darkens a picture towards its corners.",
  "inputs": { "image": "color" },
  "outputs": { "color": "color" },
  "params": {
    "amount": { "type": "float", "default": 1, "range": [0, 1], "label": "Darkness outside" },
    "inner": { "type": "float", "default": 0.5, "range": [0, 2], "label": "Radius where it begins; a corner has 1" },
    "outer": { "type": "float", "default": 0.9, "range": [0, 2], "label": "Radius where it is complete" }
  },
  // An ellipse follows the picture's aspect and touches all four sides alike; a circle is round on the screen.
  "choices": { "shape": { "items": ["ellipse", "circle"], "default": "ellipse" } },
  "identity": { "when": "amount == 0", "is": "image" },
  "black": ["image"],
  "contract": { "non_finite": "contained", "laws": ["black", "energy", "monotone", "mirror", "scale"] },
  "source": "the 2017 demo, which subtracted and so went below black"
}*/
vec3 vignette(vec2 uv)
{
#if shape == shape_circle
    vec2 extent = vec2(image_size());
    float radius = 2.0 * length((uv - 0.5) * extent) / length(extent);
#else
    float radius = 1.41421356 * length(uv - 0.5); // sqrt(2): the corner, at 1/sqrt(2), has radius 1
#endif
    // smoothstep written out, because GLSL leaves it undefined where inner >= outer; here that is a sharp edge at inner.
    float t = clamp((radius - inner) / max(outer - inner, 1e-4), 0.0, 1.0);
    return image(uv) * (1.0 - amount * (t * t * (3.0 - 2.0 * t)));
}
