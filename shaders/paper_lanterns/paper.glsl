// A thin translucent sheet. GLSL 4.50 and C++ (exhibits/paper_lanterns/paper_lanterns_cpu.h).

// Mean cosine of light that passes the sheet and is scattered forwards by its fibers.
const float SHEET_FORWARD = 0.8;

// Share per steradian of that light by the cosine of its deflection (Henyey and Greenstein 1941).
float forwardLobe(float cosine)
{
    float squared = 1.0 + SHEET_FORWARD * SHEET_FORWARD - 2.0 * SHEET_FORWARD * cosine;
    return (1.0 - SHEET_FORWARD * SHEET_FORWARD) / (4.0 * PI * squared * sqrt(squared));
}

struct Sheet {
    float reflected;    // reflectance
    float transmitted;  // transmittance; the rest is absorbed
};

// Diffuse reflectance and transmittance of a sheet, for scattering and absorption coefficients times its thickness, not
// negative. Kubelka and Munk 1931, "Ein Beitrag zur Optik der Farbanstriche", in the closed form of Kubelka 1948.
Sheet sheetOf(float scatter, float absorb)
{
    // Without scattering, only absorption remains.
    Sheet sheet;
    sheet.reflected = 0.0;
    sheet.transmitted = exp(-max(absorb, 0.0));
    if (scatter < 1.0e-12) return sheet;
    float a = 1.0 + max(absorb, 0.0) / scatter;
    float b = sqrt(max(a * a - 1.0, 0.0));
    float x = b * scatter;
    // sinh(x) / b approaches `scatter` as the absorption approaches 0. Both are divided by cosh(x), which may be large.
    float e = exp(-2.0 * x);
    float tanhOverB = x < 1.0e-3 ? scatter * (1.0 - x * x / 3.0) : (1.0 - e) / ((1.0 + e) * b);
    float perCosh = 2.0 * exp(-x) / (1.0 + e);
    float under = a * tanhOverB + 1.0;
    sheet.reflected = tanhOverB / under;
    sheet.transmitted = perCosh / under;
    return sheet;
}

// Gain of brightness in an open tube by light that its walls reflect to each other: 1 / (1 - r f). f is the share of a
// wall's light that hits the walls again; the rest leaves through the openings.
float tubeGain(float reflected, float radius, float height)
{
    // areas over pi: the side and the base, which is equally bright
    float walls = 2.0 * radius * height + radius * radius;
    float open = radius * radius;
    return 1.0 / (1.0 - clamp(reflected, 0.0, 0.999) * walls / (walls + open));
}
