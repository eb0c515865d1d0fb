#pragma once

#include "exhibits/sdf_scenes/scene_walk.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace vitrine::scenes {

/// Steps of a program that matter in a part of space.
struct PrunedSteps {
    std::vector<Step> steps;
    double distance = 1e9;   ///< Distance of the whole scene, at the center of that part.
    std::size_t shapes = 0;  ///< Number of shapes among the steps; copies of repeated content count once.
};

/// Removes steps from a program that cannot matter in a ball. Distances change by at most a meter per meter. So the
/// values at the center bound the values of two operands in the ball. If an operation returns exactly one of the
/// operands at all four extremes, it returns that one everywhere in between. The other operand, with all nodes below
/// it, is then removed; a blend does this beyond its width. An operand among several that are joined in turn is also
/// removed if its effect is within a tolerance. The effect is multiplied by the largest weights of the intermediate
/// result in all later joints. The method is the same for every kind of node. (For unions of two: Barbier et al. 2025,
/// "Lipschitz Pruning"; here for any operation with several operands.) Repeated content is kept as a whole.
///
/// In the ball, the remaining steps give the same distance, material and node as all steps, up to the tolerance for
/// each operation with several operands. Outside the result is undefined. Reuses its memory between calls. Not
/// thread-safe: use one per thread.
class Pruner {
public:
    /// Tolerances in meters: below the rounding error of float64 some meters from the origin, and about that of
    /// float32.
    static constexpr double exact = 1e-13, asShaders = 1e-6;

    /// Program and numbers must outlive it. `tolerance` is in meters of the space of each operation.
    Pruner(const SceneProgram&, const SceneConstants&, double tolerance = exact);

    /// Prunes `steps` (all, or those left for a ball that contains this one) for a ball of `radius` around `center`.
    [[nodiscard]] PrunedSteps prune(std::span<const Step> steps, const glm::dvec3& center, double radius);
    /// The same, but reuses the memory of `into`; `steps` must not be part of it.
    void prune(std::span<const Step> steps, const glm::dvec3& center, double radius, PrunedSteps& into);
    /// Number of shapes evaluated since construction.
    [[nodiscard]] std::size_t evaluations() const { return walk_.primitiveEvaluations(); }

private:
    /// Direction in which an operation changes its first operand, for all values that this may have in the ball.
    enum class Moves : std::uint8_t { neither, down, up, upOfFirst };
    /// A joint whose two operands are both kept so far.
    struct Joint {
        std::size_t child = 0, combined = 0;  // Indices in kept_: start of the operand, and the step that joins it.
        double effect = 0;                    // Largest change of the result by the operand.
        double effectOfFormer = 0;            // Largest change of the result by everything before it.
        double formerShare = 0;               // Largest weight of everything before it.
        Moves moves = Moves::neither;
    };

    [[nodiscard]] double reachInside(std::uint32_t node, double outside) const;
    void copyRepeated(std::span<const Step> steps, std::size_t& i, const glm::dvec3& center);
    [[nodiscard]] bool operand(std::span<const Step> steps, const glm::dvec3& center);
    static void weigh(Joint&, const NodeKind&, const double* v, double a, double b, double reach);
    void combine(const Step&);
    void startWith(const Step&);
    void leave(std::uint32_t node);
    void drop(std::size_t from, std::size_t to);
    void dropAll();

    const SceneProgram& program_;
    const SceneConstants& words_;
    double tolerance_;
    SceneWalk walk_;
    std::vector<Step> kept_;
    std::vector<double> reach_;         // By node: distance between the points at which its children are evaluated.
    std::vector<std::size_t> entered_;  // By node: index of the kept step that enters it.
    std::vector<std::vector<Joint>> joints_;  // By node: its joints so far.
    // Ranges of removed steps, as indices of kept steps: from and to; the last range first.
    std::vector<std::pair<std::size_t, std::size_t>> dropped_;
};

/// Cell of the acceleration grid.
struct SceneCell {
    std::uint32_t first = 0, count = 0;  ///< Range in `GridCells::steps`; empty if every surface is far from the cell.
    float distance = 0;                  ///< Distance at its center, or a value closer to 0; negative inside.
    std::uint32_t shapes = 0;
};

/// Blocks of cells that were split, by the cells at their corners, with a hash of the steps that matter in each. By
/// these, `pruneChangedCells` finds the blocks that a change of numbers does not reach.
using SplitBlocks = std::unordered_map<std::uint64_t, std::uint64_t>;

/// Acceleration grid over a part of space: for each cell the steps that matter in it, in flat arrays for shaders. A
/// cell has no steps if its center is farther from any surface than the cell's diagonal. The distance at its center,
/// minus the distance from the center, is then a safe step, and at least half a diagonal.
struct GridCells {
    render::Box box;
    glm::ivec3 count{0};
    std::vector<SceneCell> cells;  ///< In order of x, then y, then z.
    /// Lists of all cells; equal lists are stored once. Jumps in a list count from its beginning.
    std::vector<Step> steps;

    std::size_t withSurface = 0;  ///< Number of cells that a surface may pass through, as far as was determined.
    std::size_t withSteps = 0;    ///< Number of these cells and of the cells near them.
    std::size_t lists = 0;        ///< Number of different lists.
    std::size_t mostShapes = 0;   ///< Largest number of shapes in a cell.
    double meanShapes = 0;        ///< Mean number of shapes in the cells with steps.
    std::size_t evaluations = 0;  ///< Number of shape evaluations needed to build the grid.
    std::size_t looks = 0;        ///< Number of parts of the box, from large to small, that were examined.
    /// False: the budget was exhausted before all cells were examined, so that the grid must not be used.
    bool whole = true;
    SplitBlocks split = {};

    /// Returns the index of the cell that contains a point; points outside of the box are clamped to it.
    [[nodiscard]] std::size_t cellAt(const glm::dvec3& p) const;
    [[nodiscard]] std::span<const Step> stepsOf(const SceneCell& cell) const
    {
        return {steps.data() + cell.first, cell.count};
    }
    [[nodiscard]] glm::dvec3 cellSize() const { return 2.0 * box.halfSize() / glm::dvec3(count); }
    /// Returns a lower bound on the distance to any surface, for a cell without steps; negative inside.
    [[nodiscard]] double clearance(std::size_t cell, const glm::dvec3& p) const;
};

/// Part of a box that contains a scene.
struct OccupiedBox {
    render::Box box;  ///< Empty if nothing was found.
    /// Small boxes that contain a surface, by the side of `box` that they touch: low x, high x, low y, ...
    std::array<render::Box, 6> touching = {};
    SplitBlocks split = {};  ///< Larger parts that were split, by the halves that lead to them.
};

/// Part of the same box that contained the scene with other numbers.
struct FormerBox {
    const OccupiedBox& found;
    const std::vector<char>& nodes;  ///< For each node of the program whether one of its own numbers has changed.
};

/// Returns the part of a finite box outside of which the box contains no part of the scene, to about a hundredth of its
/// longest side. `SceneConstants::extents` are much larger where many operands blend. With a former box, only what the
/// changed numbers reach is searched, with the same result.
[[nodiscard]] OccupiedBox occupiedBox(const SceneProgram&, const SceneConstants&, std::span<const Step> steps,
                                      const render::Box&, const FormerBox* former = nullptr);

/// Limits for building the grid. Without them, a scene whose shapes all lie within the width of one blend would list
/// every shape in every cell.
struct PruneBudget {
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();        ///< Size of the lists.
    std::uint64_t evaluations = std::numeric_limits<std::uint64_t>::max();  ///< Number of shape evaluations.
};

/// Division of a finite box into cells.
struct CellGrid {
    render::Box box;
    glm::ivec3 count{1};  ///< Cells along each axis.
};

/// Prunes steps of a program for every cell of the grid, from large parts of it to small ones. Parts that are far
/// from every surface are not subdivided.
[[nodiscard]] GridCells pruneCells(const SceneProgram&, const SceneConstants&, std::span<const Step> steps,
                                   const CellGrid&, double tolerance = Pruner::asShaders, const PruneBudget& = {});

/// Cells that a change of numbers reaches.
struct ChangedCells {
    std::vector<std::pair<std::uint32_t, SceneCell>> cells;  ///< With their indices; the last one of an index counts.
    std::vector<Step> steps;                                 ///< Lists of these cells.
    SplitBlocks split;                                       ///< Blocks of the whole grid, for the next change.
    std::size_t evaluations = 0;
    bool whole = true;  ///< False: the budget was exhausted, and nothing must be used.
};

/// Numbers of which some have changed since a grid was made.
struct ChangedNumbers {
    const SceneConstants& now;
    std::vector<char> nodes;   ///< For each node of the program whether one of its own numbers has changed.
    const SplitBlocks& split;  ///< Blocks of the grid as it is.
};

/// Prunes the cells of a grid that a change of numbers reaches: all others are as `pruneCells` would find them again.
/// The steps are the same as before.
[[nodiscard]] ChangedCells pruneChangedCells(const SceneProgram&, const ChangedNumbers&, std::span<const Step> steps,
                                             const CellGrid&, double tolerance = Pruner::asShaders,
                                             const PruneBudget& = {});

}  // namespace vitrine::scenes
