#include "exhibits/sdf_scenes/scene_mesh.h"

#include "exhibits/sdf_scenes/mesh_leaf.h"
#include "exhibits/sdf_scenes/mesh_stitch.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace vitrine::scenes {
namespace {

/// Upper bound on the memory per cell near the surface, in total, while a mesh is made, checked and written: a vertex,
/// two triangles and a crossed edge (116 bytes), the edges and fans of the check (84), the file and its copy (150).
constexpr std::uint64_t bytesPerCell = 350;
/// Cell size relative to the extent of the scene at which vertices a share of a cell apart still differ in float32.
constexpr double finestCell = 4e-5;
constexpr double partOfPlan = 0.25;  ///< Approximate share of the total work.

std::string text(double x)
{
    return render::shortNumber(x);
}

/// Returns the next larger number with two digits.
double roundedUp(double x)
{
    const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1);
    return std::ceil(x / unit - 1e-9) * unit;
}

/// Returns half a sentence that names the node which makes the scene infinite, with its position.
std::string endlessPart(const SceneField& field)
{
    const SceneProgram& program = field.program();
    const auto ends = [&](std::uint32_t i) {
        const render::Box& box = field.words().extents[i].box;
        return std::isfinite(glm::length(box.low)) && std::isfinite(glm::length(box.high));
    };
    std::uint32_t i = 0;
    for (std::uint32_t c = program.nodes()[i].firstChild; c != noIndex;) {
        // A node that stretches space too much needs its child at any distance: it is the cause, not its child.
        if (program.scene().nodes[program.nodes()[i].node].kind->childLevelWithin) break;
        if (ends(c)) {
            c = program.nodes()[c].next;
        } else {
            i = c;
            c = program.nodes()[i].firstChild;
        }
    }
    const Node& node = program.scene().nodes[program.nodes()[i].node];
    const render::JsonText& file = *program.scene().files[node.origin.file].text;
    const bool isAlone = program.nodes()[i].firstChild == noIndex;
    return "the " + std::string(node.kind->name) + " in line " + std::to_string(file.position(node.origin.value).line) +
           " of " + file.name() +
           (isAlone || node.kind->form == Form::repeater
                ? " goes on without end"
                : " is stretched too much: inside a blended, rounded or displaced node, no bound of its "
                  "distance is known");
}

/// Runs `work` for 0 to count - 1 on all processors, and calls `progress` meanwhile. Returns false if that canceled.
template <typename Work>
bool inParallel(std::size_t count, std::size_t threads, const MeshProgress& progress, double from, double to,
                const Work& work)
{
    std::atomic<std::size_t> next = 0, done = 0;
    std::atomic<bool> stopped = false;
    render::onThreads(threads, [&](std::size_t thread) {
        try {
            for (std::size_t i = next++; i < count && !stopped; i = next++, ++done) {
                work(thread, i);
                const double part = static_cast<double>(done) / static_cast<double>(count);
                if (thread == 0 && progress && !progress(from + (to - from) * part)) stopped = true;
            }
        } catch (...) {
            stopped = true;
            throw;
        }
    });
    return !stopped;
}

}  // namespace

render::Box meshedBox(const SceneField& scene, const MeshRequest& request)
{
    render::Box box = scene.box();
    if (request.part) box = box.intersection(*request.part);
    if (box.empty())
        throw Failure(ErrorKind::usage, "Nothing of the scene lies between --low and --high; give other corners.");
    const glm::dvec3 size = box.high - box.low;
    if (!std::isfinite(size.x + size.y + size.z))
        throw Failure(ErrorKind::usage, "The scene has no end: " + endlessPart(scene) +
                                            ". Say with --low and --high what part of it is to be meshed.");
    // Only the occupied part: the bounds of many blended operands are much larger.
    const render::Box occupied = occupiedBox(scene.program(), scene.words(), scene.program().steps(), box).box;
    if (!occupied.empty()) box = occupied;
    const double reach = std::max({glm::length(box.low), glm::length(box.high)});
    if (request.cell < finestCell * reach)
        throw Failure(ErrorKind::usage, "Cells of " + text(request.cell) +
                                            " m are too small for a scene that reaches " + text(reach) +
                                            " m; give --cell " + text(roundedUp(finestCell * reach)) + "m or more.");
    return box;
}

struct SceneMesher::Work {
    MeshField field;
    std::vector<MeshLeaf> leaves;
    std::vector<std::unique_ptr<LeafMesher>> threads{};
    Pruner pruner;
    std::uint64_t mostBytes = 0;
    bool stopped = false;

    Work(const SceneField& scene, const render::Box& part) : field{scene, part}, pruner(scene.program(), scene.words())
    {
        const std::size_t count = std::clamp(std::thread::hardware_concurrency(), 1U, 16U);
        for (std::size_t i = 0; i < count; ++i) threads.push_back(std::make_unique<LeafMesher>(field));
    }

    /// Returns whether a surface may pass through a block of `size` cells; `left` receives the steps that matter in it.
    bool isNear(const std::vector<Step>& steps, const glm::ivec3& low, int size, PrunedSteps& left)
    {
        const glm::dvec3 center = field.at(glm::dvec3(low) + 0.5 * size);
        const double radius = 0.5 * size * std::sqrt(3.0) * field.cell;
        left = pruner.prune(steps, center, radius + 0.01 * field.cell);
        return std::abs(field.cut(center, left.distance)) <= radius * (1 + 2e-6) + 1e-9;
    }

    /// Counts blocks of this many cells that a surface may pass through, inside a larger one; stops above `most`.
    void count(const std::vector<Step>& steps, const glm::ivec3& low, int size, int smallest, std::uint64_t& found)
    {
        PrunedSteps left;
        if (!isNear(steps, low, size, left)) return;
        if (size <= smallest) {
            ++found;
            return;
        }
        for (int corner = 0; corner < 8; ++corner)
            count(left.steps, low + size / 2 * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), size / 2, smallest,
                  found);
    }

    void addLeaves(const std::shared_ptr<const std::vector<Step>>& steps, const glm::ivec3& low, int size,
                   const MeshProgress& progress)
    {
        PrunedSteps left;
        if (stopped || !isNear(*steps, low, size, left)) return;
        const bool same = left.steps.size() == steps->size();
        const auto own = same ? steps : std::make_shared<const std::vector<Step>>(std::move(left.steps));
        if (size == leafCells) {
            leaves.push_back({low, own, {}, {}});
            stopped = leaves.size() % 256 == 0 && progress && !progress(0);
            return;
        }
        for (int corner = 0; corner < 8; ++corner)
            addLeaves(own, low + size / 2 * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2), size / 2, progress);
    }

    /// Estimates the number of cells from the blocks of a coarse level, before any are stored.
    [[nodiscard]] double estimatedCells(int size)
    {
        const int coarse = std::max(size / 64, leafCells);
        std::uint64_t blocks = 0;
        count(field.scene.program().steps(), glm::ivec3(0), size, coarse, blocks);
        return static_cast<double>(blocks) * coarse * coarse;
    }

    [[noreturn]] void refuse(double cells) const
    {
        const double bytes = cells * bytesPerCell;
        const double fits = field.cell * std::sqrt(bytes / static_cast<double>(mostBytes)) * 1.15;
        throw Failure(ErrorKind::usage, "A mesh with cells of " + text(field.cell) + " m would take about " +
                                            text(bytes / 1e9) + " GB of memory, more than " +
                                            text(static_cast<double>(mostBytes) / 1e9) + " GB; give --cell " +
                                            text(roundedUp(fits)) + "m or more, or a smaller part.");
    }
};

SceneMesher::SceneMesher(const SceneField& scene, const MeshRequest& request, const MeshProgress& progress)
{
    if (!(request.cell > 0)) throw Failure(ErrorKind::usage, "The size of a cell must be above 0; give a larger one.");
    const render::Box box = meshedBox(scene, request);
    work_ = std::make_unique<Work>(scene, request.part ? *request.part : endlessBox());
    Work& work = *work_;
    work.mostBytes = request.mostBytes;
    work.field.cell = request.cell;
    // An offset, so that faces at round numbers do not lie on the lattice, whatever the cell size.
    work.field.low = box.low - 1.381966 * request.cell;
    plan_.cells = glm::ivec3(glm::ceil((box.high - work.field.low) / request.cell)) + 1;
    int size = leafCells;
    while (size < std::max({plan_.cells.x, plan_.cells.y, plan_.cells.z})) size *= 2;
    const double estimate = work.estimatedCells(size);
    if (estimate * bytesPerCell > 2 * static_cast<double>(work.mostBytes)) work.refuse(estimate);
    work.addLeaves(std::make_shared<const std::vector<Step>>(scene.program().steps()), glm::ivec3(0), size, progress);
    work.stopped = work.stopped || !inParallel(work.leaves.size(), work.threads.size(), progress, 0, partOfPlan,
                                               [&](std::size_t thread, std::size_t i) {
                                                   work.threads[thread]->findNear(work.leaves[i]);
                                               });
    std::erase_if(work.leaves, [](const MeshLeaf& leaf) { return leaf.near.none(); });
    for (const MeshLeaf& leaf : work.leaves) {
        plan_.nearSurface += leaf.near.count();
        plan_.bytes += sizeof(MeshLeaf) + sizeof(LeafSurface) + sizeof(Step) * leaf.steps->size();
    }
    plan_.bytes += plan_.nearSurface * bytesPerCell;
    if (!work.stopped && plan_.bytes > work.mostBytes) work.refuse(static_cast<double>(plan_.bytes) / bytesPerCell);
}

SceneMesher::~SceneMesher() = default;

std::optional<SceneMesh> SceneMesher::mesh(const MeshProgress& progress)
{
    Work& work = *work_;
    if (work.stopped) return std::nullopt;
    std::vector<LeafSurface> surfaces(work.leaves.size());
    std::atomic<std::uint64_t> lost = 0;
    const bool done = inParallel(work.leaves.size(), work.threads.size(), progress, partOfPlan, 0.95,
                                 [&](std::size_t thread, std::size_t i) {
                                     lost += work.threads[thread]->findSurface(work.leaves[i], surfaces[i]);
                                 });
    plan_.lost = lost;
    if (!done) return std::nullopt;
    return stitched(work.leaves, std::move(surfaces), work.field);
}

std::uint64_t SceneMesher::primitiveEvaluations() const
{
    std::uint64_t sum = 0;
    for (const auto& thread : work_->threads) sum += thread->primitiveEvaluations();
    return sum;
}

std::uint64_t SceneMesher::evaluations() const
{
    std::uint64_t sum = 0;
    for (const auto& thread : work_->threads) sum += thread->evaluations();
    return sum;
}

}  // namespace vitrine::scenes
