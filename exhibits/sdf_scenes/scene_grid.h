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
    bool again = false;  ///< It was made by changing another one.

    /// Returns whether there are cells. `cells` has their number, and if it was not made again, the cells.
    [[nodiscard]] bool hasCells() const { return cells.count.x > 0; }
    [[nodiscard]] std::uint64_t bytes() const { return records->size() + lists->size() + grid->size(); }

    // By these, it can be changed.
    std::vector<double> words = {};  ///< Numbers that it was made from.
    std::uint64_t structure = 0;     ///< Hash of the program, and of the steps without planes.
    render::Box around = {};         ///< Box in which `occupied` was searched.
    OccupiedBox occupied = {};
    int across = 0;
    std::size_t listsWithoutWaste = 0;  ///< Size of `lists` when all cells were made.
};

/// Returns a good number of cells along the longest side for a scene of `shapes` shapes.
[[nodiscard]] int cellsAcross(std::size_t shapes);

/// Budget of the cells: a thousand shapes take 20 MB and 6 million evaluations. Beyond this budget a picture would wait
/// for seconds.
inline constexpr PruneBudget cellBudget{128U << 20U, 60'000'000};

/// Makes the lists. `across` is the number of cells along the longest side of everything except the planes. With 0
/// there are no cells and every place has all steps. If the cells would exceed the budget, they are larger and fewer,
/// or there are none.
///
/// `former`: a grid of a program with the same steps. If few numbers have changed and the scene fills the same box,
/// only the cells that they reach are made again; all are then as they would be otherwise.
[[nodiscard]] std::shared_ptr<const SceneGrid> sceneGrid(const SceneProgram&, const SceneConstants&,
                                                         const ListVocabulary&, int across,
                                                         const PruneBudget& = cellBudget,
                                                         const SceneGrid* former = nullptr);

}  // namespace vitrine::scenes
