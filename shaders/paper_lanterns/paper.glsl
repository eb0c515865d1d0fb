// A thin translucent sheet. GLSL 4.50 and C++ (exhibits/paper_lanterns/paper_lanterns_cpu.h).

struct Sheet {
    float reflected;    // share of the light that comes back from where it came
    float transmitted;  // share that leaves on the other side; the rest is absorbed
};

// Of diffuse light on a sheet with scattering and absorption, each times its thickness and not negative. Kubelka and
// Munk 1931, "Ein Beitrag zur Optik der Farbanstriche", in the closed form of Kubelka 1948.
Sheet sheetOf(float scatter, float absorb)
{
    // Nothing scatters: absorption alone.
    Sheet sheet;
    sheet.reflected = 0.0;
    sheet.transmitted = exp(-max(absorb, 0.0));
    if (scatter < 1.0e-12) return sheet;
    float a = 1.0 + max(absorb, 0.0) / scatter;
    float b = sqrt(max(a * a - 1.0, 0.0));
    float x = b * scatter;
    // sinh(x) / b goes to the scattering as the absorption goes to 0. Both over cosh(x), which may be large.
    float e = exp(-2.0 * x);
    float tanhOverB = x < 1.0e-3 ? scatter * (1.0 - x * x / 3.0) : (1.0 - e) / ((1.0 + e) * b);
    float perCosh = 2.0 * exp(-x) / (1.0 + e);
    float under = a * tanhOverB + 1.0;
    sheet.reflected = tanhOverB / under;
    sheet.transmitted = perCosh / under;
    return sheet;
}

// How much brighter light that stays in an open tube becomes by its walls lighting each other: 1 / (1 - r f), f the
// share of a wall's light that falls on the walls again. The tube's openings lose the rest.
float tubeGain(float reflected, float radius, float height)
{
    float walls = 2.0 * radius * height + radius * radius;  // over pi: the side and the base, which is as bright
    float open = radius * radius;
    return 1.0 / (1.0 - clamp(reflected, 0.0, 0.999) * walls / (walls + open));
}
