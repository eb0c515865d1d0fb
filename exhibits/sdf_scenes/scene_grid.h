#pragma once

#include "exhibits/sdf_scenes/pruning.h"
#include "exhibits/sdf_scenes/step_lists.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vitrine::scenes {

/// A scene without the planes that are joined by hard unions. Ray tracing intersects these analytically, and the rest
/// is often finite.
struct SceneWithoutPlanes {
    /// Half space below a plane, in scene space.
    struct Plane {
        glm::dvec3 normal{0};  ///< Unit normal, outward.
        double height = 0;     ///< Offset along the normal, in meters.
        std::uint32_t material = 0;
    };
    std::vector<Plane> planes;
    std::vector<Step> steps;  ///< Steps of the rest of the scene; empty if there is none.
    render::Box box;          ///< Bounding box of the rest; empty if there is none.

    /// Removes planes that are children of hard unions without a transformation, starting at the root.
    SceneWithoutPlanes(const SceneProgram&, const SceneConstants&, std::size_t mostPlanes);
};

/// Shapes that are near each place of a scene, in the buffers that shaders/sdf_scenes/near.glsl reads.
struct SceneGrid {
    static constexpr std::size_t mostPlanes = 4;

    std::shared_ptr<const render::Bytes> records, lists, grid;
    std::uint32_t planes = 0;
    render::Box box;  ///< Bounding box of everything except the planes.
    GridCells cells;  ///< Empty if the scene is unbounded, if none were requested, or if `crowded`.
    /// Cells would exceed their budget: too many shapes lie within the width of one blend.
    bool crowded = false;
    double seconds = 0;  ///< Time that it took to make.
    [[nodiscard]] std::uint64_t bytes() const { return records->size() + lists->size() + grid->size(); }
};

/// Returns a good number of cells along the longest side for a scene of `shapes` shapes.
[[nodiscard]] int cellsAcross(std::size_t shapes);

/// Budget of the cells: a thousand shapes take 20 MB and 6 million evaluations. Beyond this budget a picture would wait
/// for seconds.
inline constexpr PruneBudget cellBudget{128U << 20U, 60'000'000};

/// Makes the lists. `across` is the number of cells along the longest side of everything except the planes. With 0
/// there are no cells and every place has all steps. If the cells would exceed the budget, they are larger and fewer,
/// or there are none.
[[nodiscard]] std::shared_ptr<const SceneGrid> sceneGrid(const SceneProgram&, const SceneConstants&,
                                                         const ListVocabulary&, int across,
                                                         const PruneBudget& = cellBudget);

}  // namespace vitrine::scenes
