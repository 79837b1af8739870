/*{
  "pass": "original_alpha",
  "summary": "What is left of a G-buffer with material in its alphas when it is drawn with blending into RGB16F targets.",
  "inputs": { "albedo": "albedo", "material": "material", "normal": "normal", "position": "position" },
  "outputs": { "diffuse": "albedo", "matter": "material", "facing": "normal", "place": "position" },
  "source": "reconstructed from the description of the 2017 demo: source alpha blending was on for every draw"
}*/
void original_alpha(vec2 uv, out vec3 diffuse, out vec3 matter, out vec3 facing, out vec3 place)
{
    // color = source * alpha + cleared * (1 - alpha), cleared being black; alpha carries what the packing put there.
    vec3 alphas = material(uv); // specular, roughness, metallic
    diffuse = albedo(uv) * alphas.x;
    facing = normal(uv) * alphas.y;
    place = position(uv) * alphas.z;
    matter = vec3(1.0); // a texture without an alpha channel answers 1
}
