// The filmic curve as a table.

/// The curve of Hable 2010 with the constants of the 2017 demo (shoulder 0.22, linear 0.30 at 0.10, toe 0.20, 0.01, 0.30)
/// at sqrt(x) = u / (1 - u), u = 0, 1/32, ..., 1, joined by straight lines; own choice of places: equal steps of u are
/// fine where the toe bends, and the last reaches infinity. At most 0.004 of white off, which is 0.6 of an 8-bit code.
float filmic_from_table(float x)
{
    const float samples[33] = float[33](
        0.000000000, 0.000348882, 0.001517660, 0.003769806, 0.007501992, 0.013267466,
        0.021778241, 0.033876428, 0.050471294, 0.072447375, 0.100556636, 0.135311292,
        0.176893014, 0.225090793, 0.279275893, 0.338418836, 0.401149425, 0.465855564,
        0.530810099, 0.594309047, 0.654801614, 0.710993994, 0.761914889, 0.806938982,
        0.845772595, 0.878411277, 0.905081216, 0.926175585, 0.942194310, 0.953692496,
        0.961239833, 0.965391113, 0.966666667);
    float root = sqrt(x);
    float place = 32.0 * root / (1.0 + root);
    int left = clamp(int(place), 0, 31);
    return mix(samples[left], samples[left + 1], place - float(left));
}
