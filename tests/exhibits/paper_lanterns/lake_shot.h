#pragma once

#include "tests/exhibits/paper_lanterns/lake_at_float64.h"
#include "tests/support/gallery.h"

namespace vitrine::test {

/// Small picture of the lake, alone.
struct LakeShot : ExhibitShot<paper_lanterns::PaperLanternsTable> {
    LakeShot() : ExhibitShot("paper_lanterns") { size(96, 60); }
    /// Shows only lanterns and calm water under a black sky.
    LakeShot& inTheDark()
    {
        const paper_lanterns::PaperLanternsTable& t = lanternsTable();
        set(t.moon, 0.0).set(t.stars, 0.0).set(t.dusk, 0.0).set(t.fog, 0.0);
        set(t.ripples, 0.0).set(t.waveHeight, 0.0).set(t.colors, 0.0);
        return *this;
    }
    /// Shows one lantern that is not rotated; returns it.
    glsl::Lake::Lantern withOneLantern()
    {
        const paper_lanterns::PaperLanternsTable& t = lanternsTable();
        set(t.lanterns, 1).set(t.crowding, 1.0).set(t.irregularity, 0.0).set(t.turned, 0.0);
        return lakeAtFloat64(values(), lakeTime(t, values(), 0)).lanternOfCell({0, 0});
    }
    /// Places the camera in the lake's world.
    LakeShot& from(const glm::dvec3& eye, const glm::dvec3& target, double fovY)
    {
        const glm::dmat4 exhibitFromLake = glm::inverse(lakePortal(lanternsTable(), values()).workFromExhibit);
        request.frame.camera = {glm::dvec3(exhibitFromLake * glm::dvec4(eye, 1)),
                                glm::dvec3(exhibitFromLake * glm::dvec4(target, 1)), fovY};
        return *this;
    }
    /// Returns the pixel that shows a place of the lake's world, from the top left.
    [[nodiscard]] glm::dvec2 pixelOf(const Picture& p, const glm::dvec3& place)
    {
        const glm::dmat4 lakeFromExhibit = lakePortal(lanternsTable(), values()).workFromExhibit;
        const glm::dvec4 clip = p.view.clipFromWorld * glm::inverse(lakeFromExhibit) * glm::dvec4(place, 1);
        const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
        return {(0.5 + 0.5 * ndc.x) * p.width(), (0.5 - 0.5 * ndc.y) * p.height()};
    }
};

}  // namespace vitrine::test
