/*{
  "pass": "original_blur",
  "summary": "Nine linear taps along a row or column, the center counted twice, so that the weights sum to 1.227.",
  "inputs": { "image": { "signal": "color", "filter": "linear" } },
  "outputs": { "blurred": "color" },
  "choices": { "direction": ["horizontal", "vertical"] },
  "source": "reconstructed from the description of the 2017 demo; weights: de Vries, LearnOpenGL, Bloom"
}*/
vec3 original_blur(vec2 uv)
{
#if direction == direction_horizontal
    vec2 texel = vec2(image_texel().x, 0.0);
#else
    vec2 texel = vec2(0.0, image_texel().y);
#endif
    const float weight[5] = float[5](0.227027, 0.1945946, 0.1216216, 0.054054, 0.016216);
    vec3 sum = image(uv) * weight[0];
    for (int i = 0; i < 5; ++i) // begins at 0, and so adds the center once more
        sum += (image(uv + float(i) * texel) + image(uv - float(i) * texel)) * (i == 0 ? 0.5 : 1.0) * weight[i];
    return sum;
}
