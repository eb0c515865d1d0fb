// Light on coats and on bare skin: skin is shaded as skin, and the fringe shows what is behind it.

#include "tests/exhibits/fur/fur_shot.h"

#include <cmath>

namespace vitrine::fur {
namespace {

using namespace test;

class FurLight : public GlTest {};

/// Returns the share of the bodies' pixels whose luminance, times `factor`, has level 8 of 255 or below on a display.
double blackShare(const Picture& p, double factor)
{
    int black = 0, seen = 0;
    p.each([&](int x, int y) {
        // Without the hall, the bodies are on a light floor that fades out.
        if (!p.hit(x, y) || p.alpha(x, y) < 1) return;
        ++seen;
        black += p.luminance(x, y) * factor < 8 / 255.0 / 12.92;
    });
    EXPECT_GT(seen, 300);
    return static_cast<double>(black) / seen;
}

TEST_F(FurLight, BareSkinIsLitAndNotBlack)
{
    const auto shot = [](const auto& change) {
        FurShot s;
        s.withoutFilm();
        change(s);
        return s.take();
    };
    const auto density = [](FurShot& s, int strands) {
        for (const CoatParameters& coat : furTable().coats) s.values().set(coat.density, strands);
    };
    const Picture oneShell = shot([](FurShot& s) { s.shells(1, FurSilhouette::march); });
    const Picture sparse = shot([&](FurShot& s) { density(s, 100); });
    const Picture bald = shot([](FurShot& s) {
        for (const CoatParameters& coat : furTable().coats) s.values().set(coat.length, 0.0);
    });
    const Picture dense = shot([&](FurShot& s) { density(s, 1000000); });
    for (const Picture* p : {&oneShell, &sparse, &bald, &dense}) EXPECT_LT(blackShare(*p, 1), 0.01);
    // Control: with the occlusion of roots, 0.05, as if skin were below fur.
    EXPECT_GT(blackShare(oneShell, 0.05), 0.2);
}

TEST_F(FurLight, ShowsWhatIsBehindTheFringeAndNotTheHallWhereThePitIs)
{
    const auto mean = [](const glm::dvec3& eye, const glm::dvec3& target, double rim) {
        FurShot s;
        s.size(96, 54).see(eye, target).request.frame.camera.fovY = 0.5;
        s.values().set(furTable().lamp, 0.0);
        s.values().set(furTable().sheen, 0.0);
        s.values().set(furTable().rimLight, rim);
        const Picture p = s.take();
        double sum = 0;
        int seen = 0;
        p.each([&](int x, int y) {
            if (!p.hit(x, y) || glm::length(p.normal(x, y)) < 0.5) return;
            sum += p.luminance(x, y);
            ++seen;
        });
        EXPECT_GT(seen, 300);
        return sum / seen;
    };
    // Down at the ball from beyond the edge, with the pit behind it, and up at it, with the hall behind it.
    const glm::dvec3 above(-0.62, 1.8, 0.9), below(-0.62, 0.3, 1.4), ball(-0.62, 0.45, 0);
    const double pit = mean(above, ball, 1) / mean(above, ball, 0);
    const double hall = mean(below, ball + glm::dvec3(0, 0.45, 0), 1) / mean(below, ball + glm::dvec3(0, 0.45, 0), 0);
    std::printf("the rim light adds %.1f %% before the pit, %.1f %% before the hall\n", 100 * (pit - 1),
                100 * (hall - 1));
    EXPECT_LT(pit, 1.01);
    EXPECT_GT(hall, 1.05);
}

}  // namespace
}  // namespace vitrine::fur
