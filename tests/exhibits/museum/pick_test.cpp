// Picking with the pointer finds what is drawn; and exhibits cut out of the hall.

#include "tests/support/gallery.h"

#include <cmath>

namespace vitrine {
namespace {

using namespace test;

class PickTest : public test::GlTest {};

/// Compares the distance of the picked point with the drawn depth, pixel by pixel.
void expectWhatIsDrawn(Shot& shot, const char* where)
{
    shot.request.frame.time = 0;
    const Picture p = shot.take();
    const glm::dvec3 forward = glm::normalize(shot.request.frame.camera.target - shot.request.frame.camera.eye);
    const std::size_t panes = *gallery().museum.find("crepuscular_rays");
    const std::size_t fur = *gallery().museum.find("fur");
    const auto prepared = gallery().museum.prepare(shot.sceneState, shot.request.frame);
    int compared = 0, wrong = 0;
    p.each([&](int x, int y) {
        if ((x + y) % 3 != 0) return;  // One query takes a millisecond.
        const glm::dvec2 ndc((x + 0.5) / p.width() * 2 - 1, 1 - (y + 0.5) / p.height() * 2);
        ++compared;
        const auto found = gallery().museum.surroundings().pick(prepared, shot.request.frame, ndc);
        if (!p.hit(x, y)) {
            // The sky is visible through the window; picking its panes is correct.
            wrong += found && found->exhibit != panes;
            return;
        }
        const double cosine = glm::dot(glm::normalize(p.view.direction(ndc)), forward);
        const double distance = gallery().museum.surroundings().distanceTo(prepared, shot.request.frame, ndc) * cosine;
        const double beyond = p.depth(x, y) - distance;
        if (found && found->exhibit == panes && beyond > 0) return;
        // A coat is picked as a whole; the drawn depth is somewhere between its hairs.
        const double tolerance = found && found->exhibit == fur && !found->button ? 0.4 : 0.02 + 0.01 * p.depth(x, y);
        wrong += !(std::abs(beyond) < tolerance);
    });
    // Pixels on outlines, and the margin around buttons.
    EXPECT_LT(wrong, compared / 33) << where << ": " << wrong << " of " << compared;
}

using LongPickTest = PickTest;

TEST_F(LongPickTest, PointsAtWhatIsDrawn)
{
    Shot shot;
    shot.inHall().size(96, 54);
    expectWhatIsDrawn(shot, "the mug's best view");
    shot.see({1.35, 1.65, 10.2}, {-0.35, 2.15, -4.0});
    expectWhatIsDrawn(shot, "the entrance");
    shot.see({1.2, 1.65, 5.2}, {3.3, 0.0, 3.0});
    // The floor is visible through soft tips, but coats are picked as a whole.
    ParameterValues& coats = shot.sceneState.values[*gallery().museum.find("fur")];
    coats.setParameter(*coats.table().find("tipSoftness"), 0.0);
    expectWhatIsDrawn(shot, "the pit");
    shot.see({-3.0, 1.5, 4.6}, {-3.2, 1.1, 3.0});
    expectWhatIsDrawn(shot, "the card");
}

TEST_F(PickTest, AnExhibitCutOutOfTheHallIsTheExhibitInTheHallsLight)
{
    Shot shot;
    shot.inHall().size(96, 54);
    const std::size_t rays = *gallery().museum.find("crepuscular_rays");
    ParameterValues& air = shot.sceneState.values[rays];
    air.setParameter(*air.table().find("airDensity"), 0.0);
    shot.request.frame.transparent = false;
    const Picture whole = shot.take();
    shot.request.frame.cutOut = shot.exhibit;
    const Picture cut = shot.take();
    const auto prepared = gallery().museum.prepare(shot.sceneState, shot.request.frame);
    int inside = 0, outside = 0;
    double worst = 0;
    cut.each([&](int x, int y) {
        const glm::dvec2 ndc((x + 0.5) / cut.width() * 2 - 1, 1 - (y + 0.5) / cut.height() * 2);
        EXPECT_EQ(cut.alpha(x, y), cut.hit(x, y) ? 1 : 0);
        EXPECT_EQ(whole.alpha(x, y), 1);
        const auto found = gallery().museum.surroundings().pick(prepared, shot.request.frame, ndc);
        const bool pointed = found && found->exhibit == shot.exhibit && !found->button;
        inside += pointed && cut.hit(x, y);
        outside += !pointed && !cut.hit(x, y);
        if (pointed && cut.hit(x, y)) worst = std::max(worst, glm::length(cut.color(x, y) - whole.color(x, y)));
    });
    EXPECT_GT(inside, 300);
    EXPECT_GT(outside, 300);
    EXPECT_GT(inside + outside, 96 * 54 * 97 / 100);
    EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace vitrine
