// Directions of vectors that may have none.

/// `v` at length 1, or `fallback` where v is zero or not finite.
/// Scaled by its largest component first, because the squares of 1e-20 and 1e20 leave binary32.
vec3 unit_vector_or(vec3 v, vec3 fallback)
{
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    vec3 scaled = v / largest;
    float squared = dot(scaled, scaled); // from 1 to 3 for every direction there is; no comparison holds for NaN
    return squared > 0.9 && squared < 3.1 ? scaled * inversesqrt(squared) : fallback;
}
