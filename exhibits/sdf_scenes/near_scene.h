#pragma once

#include "exhibits/sdf_scenes/pruning.h"
#include "exhibits/sdf_scenes/step_lists.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vitrine::scenes {

/// A scene without the planes that it only adds: whoever traces a ray meets those in closed form, and what is left is
/// often finite.
struct SceneWithoutPlanes {
    /// A half space of the whole scene.
    struct Plane {
        glm::dvec3 normal{0};  ///< Unit; out of the solid.
        double height = 0;     ///< Along it, meters.
        std::uint32_t material = 0;
    };
    std::vector<Plane> planes;
    std::vector<Step> steps;  ///< Of the rest; empty where there is none.
    render::Box box;          ///< Holds the rest; empty where there is none.

    /// Planes are taken from hard unions that stand where the scene does: from the root, and from unions in it.
    SceneWithoutPlanes(const SceneProgram&, const SceneWords&, std::size_t mostPlanes);
};

/// What of a scene is near each place, as shaders/sdf_scenes/near.glsl reads it.
struct NearScene {
    static constexpr std::size_t mostPlanes = 4;

    std::shared_ptr<const render::Bytes> records, lists, grid;
    std::uint32_t planes = 0;
    render::Box box;   ///< Holds all but the planes.
    SceneCells cells;  ///< None where the scene has no end, none were asked for, or `crowded`.
    /// Cells would take more than their budget: too many shapes are within the width of one blend.
    bool crowded = false;
    double seconds = 0;  ///< That making it took.
    [[nodiscard]] std::uint64_t bytes() const { return records->size() + lists->size() + grid->size(); }
};

/// Cells along the longest side that serve a scene of so many shapes well.
[[nodiscard]] int cellsAcross(std::size_t shapes);

/// Budget of its cells: a thousand shapes take 20 MB and 6 million evaluations; beyond this, a picture
/// waits for seconds.
inline constexpr PruneBudget cellBudget{128U << 20U, 60'000'000};

/// `across`: cells along the longest side of what is not a plane; 0: without cells, every place has all steps. Where
/// they would take more than the budget, there are fewer and larger ones, or none.
[[nodiscard]] std::shared_ptr<const NearScene> nearScene(const SceneProgram&, const SceneWords&, const ListVocabulary&,
                                                         int across, const PruneBudget& = cellBudget);

/// How many planes a scene's lists leave out, which its shader has to know.
[[nodiscard]] std::uint32_t planesOf(const SceneProgram&, const SceneWords&);

}  // namespace vitrine::scenes
