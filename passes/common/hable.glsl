// The filmic curve of "Uncharted 2".

/// Hable 2010, "Uncharted 2: HDR Lighting": ((x (A x + C B) + D E) / (x (A x + B) + D F)) - E / F, where `abc` are the
/// shoulder's strength, the linear part's strength and angle, `def` the toe's strength, numerator and denominator.
/// Brought to one fraction, so that 0 gives exactly 0 and nothing cancels in the dark:
/// x (A (F - E) x + B (C F - E)) / (F (x (A x + B) + D F)).
float hable_curve(float x, vec3 abc, vec3 def)
{
    float above = x * (abc.x * (def.z - def.y) * x + abc.y * (abc.z * def.z - def.y));
    float below = def.z * (x * (abc.x * x + abc.y) + def.x * def.z);
    return above / below;
}

/// The curve scaled so that `white` and everything brighter becomes 1; NaN and negative values are black.
float hable(float x, float white, vec3 abc, vec3 def)
{
    float limited = x > 0.0 ? min(x, white) : 0.0;
    return hable_curve(limited, abc, def) * (1.0 / hable_curve(white, abc, def)); // a constant where white is one
}
