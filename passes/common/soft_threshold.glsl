// How much of a brightness lies above a threshold that has a soft knee.

/// The part of `brightness` above `threshold`; a parabola joins the two straight parts over threshold * (1 +- knee).
/// Jimenez 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", as written down by Unity's
/// post-processing stack. Value and slope are continuous; a knee of 0 is a hard corner, where 1e-8 avoids 0 / 0.
float above_threshold(float brightness, float threshold, float knee)
{
    float reach = threshold * knee;
    float rise = clamp(brightness - (threshold - reach), 0.0, 2.0 * reach);
    return max(rise * rise / max(4.0 * reach, 1e-8), brightness - threshold);
}

/// That part as a share of the whole, from 0 to 1; black keeps nothing.
float share_above_threshold(float brightness, float threshold, float knee)
{
    return brightness > 0.0 ? above_threshold(brightness, threshold, knee) / brightness : 0.0;
}
