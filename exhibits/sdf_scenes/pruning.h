#pragma once

#include "exhibits/sdf_scenes/scene_walk.h"

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace vitrine::scenes {

/// The steps of a program that matter in a part of space.
struct PrunedSteps {
    std::vector<Step> steps;
    double distance = 1e9;   ///< Of the whole scene, at the center of that part.
    std::size_t shapes = 0;  ///< How many are among the steps; each copy of what is repeated is the same one.
};

/// Leaves out of a program what cannot matter in a ball. Distances change by at most a meter per meter, so from those
/// at the center it is known between what values two operands stay in it. Where an operation gives one of them exactly
/// at all four extremes, it gives that one everywhere between, and the other one and all below it are left out: beyond
/// its width a blend collapses. Of several operands joined in turn, one is left out as well where its effect, times the
/// largest shares of the result so far in all later joints, is within a tolerance. This asks no kind for its name. (For
/// unions of two: Barbier et al. 2025, "Lipschitz Pruning"; here for any operation of several.) What is repeated stays
/// whole.
///
/// In the ball, what is left gives the same distance, material and node as the whole, up to the tolerance for each
/// operation with several operands. Outside it may give anything. Keeps its memory between calls; for one thread at a
/// time.
class Pruner {
public:
    /// Meters: what is below the rounding of float64 some meters from the origin, and what is about that of float32.
    static constexpr double exact = 1e-13, asShaders = 1e-6;

    /// Both must outlive it. `tolerance` is in meters of the space of each operation.
    Pruner(const SceneProgram&, const SceneWords&, double tolerance = exact);

    /// Of `steps` (all, or what was left for a ball that holds this one), those for a ball of `radius` around `center`.
    [[nodiscard]] PrunedSteps prune(std::span<const Step> steps, const glm::dvec3& center, double radius);
    /// The same into what was there, whose memory it takes; `steps` must not be of it.
    void prune(std::span<const Step> steps, const glm::dvec3& center, double radius, PrunedSteps& into);
    /// Of shapes, since it was made.
    [[nodiscard]] std::size_t evaluations() const { return walk_.shapesAsked(); }

private:
    /// In what direction an operation moves its first operand, for all values that it may have in the ball.
    enum class Moves : std::uint8_t { neither, down, up, upOfFirst };
    /// A joint whose two operands are both kept so far.
    struct Joint {
        std::size_t child = 0, combined = 0;  // In kept_: where the operand begins, and the step that joins it.
        double effect = 0;                    // By how much the operand may change the result.
        double effectOfFormer = 0;            // By how much all before it may.
        double formerShare = 0;               // The largest share of all before it.
        Moves moves = Moves::neither;
    };

    [[nodiscard]] double reachInside(std::uint32_t node, double outside) const;
    void copyRepeated(std::span<const Step> steps, std::size_t& i, const glm::dvec3& center);
    [[nodiscard]] bool operand(std::span<const Step> steps, const glm::dvec3& center);
    void combine(const Step&);
    void startWith(const Step&);
    void leave(std::uint32_t node);
    void drop(std::size_t from, std::size_t to);
    void dropAll();

    const SceneProgram& program_;
    const SceneWords& words_;
    double tolerance_;
    SceneWalk walk_;
    std::vector<Step> kept_;
    std::vector<double> reach_;               // By node: how far apart the points are at which its children are asked.
    std::vector<std::size_t> entered_;        // By node: which of the kept steps enters it.
    std::vector<std::vector<Joint>> joints_;  // By node.
    std::vector<std::pair<std::size_t, std::size_t>> dropped_;  // Of the kept steps: from and to; the last first.
};

/// What is in a cell of a grid.
struct SceneCell {
    std::uint32_t first = 0, count = 0;  ///< Of `SceneCells::steps`; none where every surface is far from the cell.
    float distance = 0;                  ///< At its center, or nearer to 0 than there; negative inside.
    std::uint32_t shapes = 0;
};

/// A grid of cells over a part of space, each with the steps that matter in it: in flat arrays, as a shader reads them.
/// A cell whose center is farther from any surface than the whole diagonal has none: the distance at its center, less
/// that from the center, is a step there, and at least half a diagonal.
struct SceneCells {
    render::Box box;
    glm::ivec3 count{0};
    std::vector<SceneCell> cells;  ///< x first, then y, then z.
    /// Lists of all cells, those that are the same once. Steps count from the beginning of their list.
    std::vector<Step> steps;

    std::size_t withSurface = 0;  ///< Cells that a surface may pass through, as far as was looked.
    std::size_t withSteps = 0;    ///< These and those near them.
    std::size_t lists = 0;        ///< That differ.
    std::size_t mostShapes = 0;   ///< Of a cell.
    double meanShapes = 0;        ///< Over the cells with steps.
    std::size_t evaluations = 0;  ///< Of shapes, that finding all this took.
    std::size_t looks = 0;        ///< Parts of the box, from large to small, that were looked into for that.
    bool whole = true;            ///< False: the budget ended before all cells were looked into; none is to be used.

    /// The one that holds a point of the box; those outside are brought to the nearest cell.
    [[nodiscard]] std::size_t cellAt(const glm::dvec3& p) const;
    [[nodiscard]] std::span<const Step> stepsOf(const SceneCell& cell) const
    {
        return {steps.data() + cell.first, cell.count};
    }
    [[nodiscard]] glm::dvec3 cellSize() const { return 2.0 * box.halfSize() / glm::dvec3(count); }
    /// In a cell without steps: a distance to no surface, negative inside.
    [[nodiscard]] double clearance(std::size_t cell, const glm::dvec3& p) const;
};

/// The part of a finite box outside of which nothing of the scene is in it, to about a hundredth of its longest side:
/// what `SceneWords::extents` know is much wider where many operands blend. Empty where nothing is.
[[nodiscard]] render::Box occupiedBox(const SceneProgram&, const SceneWords&, std::span<const Step> steps,
                                      const render::Box&);

/// Limits for making the cells. Without them a scene whose shapes all lie within the width of one blend would list
/// every shape in every cell.
struct PruneBudget {
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();        ///< Of lists.
    std::uint64_t evaluations = std::numeric_limits<std::uint64_t>::max();  ///< Of shapes, to find them.
};

/// Prunes steps of a program for every cell of a finite box, from large parts of it to small ones. Parts that are far
/// from every surface are not looked into.
[[nodiscard]] SceneCells pruneCells(const SceneProgram&, const SceneWords&, std::span<const Step> steps,
                                    const render::Box&, const glm::ivec3& count, double tolerance = Pruner::asShaders,
                                    const PruneBudget& = {});

}  // namespace vitrine::scenes
