#include "exhibits/sdf_scenes/scene_grid.h"

#include "render/hash.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>

namespace vitrine::scenes {
namespace {

constexpr std::uint32_t nothing = ~std::uint32_t{0};

constexpr int fewestCells = 8;  ///< Along the longest side; fewer cells would exclude no shapes.

bool isFinite(const render::Box& box)
{
    return std::isfinite(glm::length(box.high - box.low));
}

/// Returns whether a node is a hard union without a transformation.
bool isPlainUnion(const SceneProgram& program, const SceneConstants& words, const ProgramNode& node)
{
    const bool moved = node.translate != noIndex || node.rotate != noIndex || node.scale != noIndex;
    return !moved && program.kind(node).name == "union" && words.words[node.numbers + 1] == 0;
}

/// Header of the grid, as in shaders/sdf_scenes/near.glsl.
struct GridHead {
    glm::vec4 low, high, heldLow, heldHigh;
    glm::uvec4 count;
    glm::vec4 planes[SceneGrid::mostPlanes];
    std::uint32_t planeMaterials[SceneGrid::mostPlanes];
};

template <typename T> void append(render::Bytes& bytes, const T* first, std::size_t count)
{
    const std::size_t at = bytes.size();
    bytes.resize(at + count * sizeof(T));
    if (count > 0) std::memcpy(bytes.data() + at, first, count * sizeof(T));
}

/// Lists of cells without duplicates, and the start of each list.
struct PackedLists {
    std::vector<ListStep> steps;
    std::vector<std::uint32_t> startOf;  ///< By `SceneCell::first`; `nothing` for all other indices.
};

/// Adds the list of a cell, which is in `steps`; those packed already begin at `begin`.
void packList(PackedLists& packed, const SceneCell& cell, const std::vector<Step>& steps, std::uint32_t begin,
              ListWriter& writer)
{
    if (cell.count == 0) return;
    packed.startOf.resize(steps.size(), nothing);
    if (packed.startOf[cell.first] != nothing) return;
    packed.startOf[cell.first] = begin + std::uint32_t(packed.steps.size());
    const std::vector<ListStep> list = writer.write(std::span(steps).subspan(cell.first, cell.count));
    packed.steps.insert(packed.steps.end(), list.begin(), list.end());
}

GridHead gridHead(const SceneGrid& near, const SceneWithoutPlanes& rest, const ListRecords& records)
{
    GridHead head{};
    const GridCells& cells = near.cells;
    const glm::dvec3 perMeter = near.hasCells() ? 1.0 / cells.cellSize() : glm::dvec3(1);
    head.low = glm::vec4(glm::dvec4(near.hasCells() ? cells.box.low : glm::dvec3(0), perMeter.x));
    head.high = glm::vec4(glm::dvec4(near.hasCells() ? cells.box.high : glm::dvec3(0), perMeter.y));
    const glm::dvec3 far(1e6);
    head.heldLow = glm::vec4(glm::dvec4(glm::clamp(near.box.low, -far, far), perMeter.z));
    head.heldHigh = glm::vec4(glm::dvec4(glm::clamp(near.box.high, -far, far), 0));
    head.count = near.hasCells() ? glm::uvec4(glm::uvec3(cells.count), 1) : glm::uvec4(0);
    for (std::size_t i = 0; i < rest.planes.size(); ++i) {
        head.planes[i] = glm::vec4(glm::dvec4(rest.planes[i].normal, rest.planes[i].height));
        head.planeMaterials[i] = records.ofMaterial(rest.planes[i].material);
    }
    return head;
}

/// Returns a cell as the shader reads it: the start of its list, and the bits of its distance.
glm::uvec2 gridEntry(const SceneCell& cell, const PackedLists& packed)
{
    glm::uvec2 entry(cell.count > 0 ? packed.startOf[cell.first] : nothing, 0);
    std::memcpy(&entry.y, &cell.distance, sizeof(float));
    return entry;
}

render::Bytes gridBytes(const GridHead& head, const GridCells& cells, const PackedLists& packed)
{
    render::Bytes bytes;
    append(bytes, &head, 1);
    std::vector<glm::uvec2> entries;
    entries.reserve(cells.cells.size());
    for (const SceneCell& cell : cells.cells) entries.push_back(gridEntry(cell, packed));
    if (entries.size() % 2 != 0 || entries.empty()) entries.resize(entries.size() / 2 * 2 + 2);  // Whole texels.
    append(bytes, entries.data(), entries.size());
    return bytes;
}

}  // namespace

SceneWithoutPlanes::SceneWithoutPlanes(const SceneProgram& program, const SceneConstants& words, std::size_t mostPlanes)
{
    const std::vector<ProgramNode>& nodes = program.nodes();
    std::vector<char> plain(nodes.size(), 0), gone(nodes.size(), 0);
    std::vector<std::uint32_t> left(nodes.size(), 0);
    const ListRecords ways(program, words, nullptr);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const bool inPlain = nodes[i].parent == noIndex || plain[nodes[i].parent] != 0;
        plain[i] = inPlain && isPlainUnion(program, words, nodes[i]);
        left[i] = nodes[i].children;
        if (!inPlain || program.kind(nodes[i]).name != "plane" || planes.size() >= mostPlanes) continue;
        const double* v = words.words.data() + nodes[i].numbers;
        const ListRecords::Way& way = ways.way(i);
        const glm::dvec3 normal(v[0], v[1], v[2]);
        const glm::dvec3 turned = way.scale * (glm::transpose(way.turn) * normal);
        if (std::abs(glm::length(turned) - 1) > 1e-9) continue;  // A non-uniform scale makes the distance a mere bound.
        gone[i] = 1;
        planes.push_back({turned, way.scale * (v[3] - glm::dot(normal, way.shift)), nodes[i].material});
    }
    for (std::uint32_t i = static_cast<std::uint32_t>(nodes.size()); i-- > 0;) {
        if (plain[i] != 0 && left[i] == 0) gone[i] = 1;
        if (gone[i] != 0 && nodes[i].parent != noIndex) --left[nodes[i].parent];
    }
    // The boxes of children of plain unions are in scene space.
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const bool whole = gone[i] == 0 && plain[i] == 0 && (nodes[i].parent == noIndex || plain[nodes[i].parent] != 0);
        if (!whole) continue;
        box.include(words.extents[i].box.low);
        box.include(words.extents[i].box.high);
    }
    std::vector<char> joined(nodes.size(), 0);
    for (const Step& step : program.steps()) {
        const bool joins = step.type == Step::Type::first || step.type == Step::Type::combine;
        if (gone[step.node] != 0 || (joins && gone[step.child] != 0)) continue;
        steps.push_back(step);
        if (joins && joined[step.node] == 0) steps.back().type = Step::Type::first;
        if (joins) joined[step.node] = 1;
    }
}

int cellsAcross(std::size_t shapes)
{
    // 14 cells per shape along each axis, if the shapes are distributed evenly. In a scene of few shapes that are close
    // together, fewer than 64 would list too many of them: the dahlia takes 21 % longer with 38, and 4 % less with 96.
    return std::clamp(static_cast<int>(14 * std::cbrt(static_cast<double>(shapes))), 64, 144);
}

namespace {

/// Returns a hash of everything in a program but its numbers, of the steps that are in cells, and of what is folded.
std::uint64_t structureOf(const SceneProgram& program, const SceneConstants& words, const std::vector<Step>& steps)
{
    render::NumberHash hash(steps.size());
    for (std::uint32_t i = 0; i < program.nodes().size(); ++i) {
        const ProgramNode& node = program.nodes()[i];
        hash.add(isFolded(program, words, i));
        hash.add(reinterpret_cast<std::uintptr_t>(&program.kind(node)));
        for (const std::uint32_t part :
             {node.parent, node.children, node.translate, node.rotate, node.scale, node.numbers, node.material})
            hash.add(part);
    }
    for (const Step& step : steps) {
        hash.add(std::uint64_t{step.node} << 32U | step.child);
        hash.add(std::uint64_t{step.back} << 8U | static_cast<std::uint64_t>(step.type));
    }
    return hash.value();
}

/// Returns for each node whether one of its own numbers is not what it was. Those of materials move no surface.
std::vector<char> changedNodes(const SceneProgram& program, const std::vector<double>& before,
                               const std::vector<double>& now)
{
    std::vector<char> changed;
    changed.reserve(program.nodes().size());
    const auto differ = [&](std::uint32_t first, std::size_t count) {
        return first != noIndex &&
               !std::equal(now.begin() + first, now.begin() + first + std::ptrdiff_t(count), before.begin() + first);
    };
    for (const ProgramNode& node : program.nodes()) {
        const NodeKind& kind = program.kind(node);
        const std::size_t numbers = kind.numbers() + (kind.form == Form::repeater ? numbersOfRepeatRange : 0);
        changed.push_back(differ(node.numbers, numbers) || differ(node.translate, 3) || differ(node.rotate, 9) ||
                          differ(node.scale, 4));
    }
    return changed;
}

bool isSameBox(const render::Box& a, const render::Box& b)
{
    return a.low == b.low && a.high == b.high;
}

/// Makes a grid.
class GridMaker {
public:
    GridMaker(const SceneProgram& program, const SceneConstants& words, const ListVocabulary& vocabulary, int across,
              const PruneBudget& budget)
        : program_(program), words_(words), budget_(budget),
          rest_(program, words, across > 0 ? SceneGrid::mostPlanes : 0), records_(program, words, &vocabulary),
          writer_(program, words, vocabulary, &records_), near_(std::make_shared<SceneGrid>())
    {
        near_->planes = static_cast<std::uint32_t>(rest_.planes.size());
        near_->box = rest_.box;
        near_->words = words.words;
        near_->structure = structureOf(program, words, rest_.steps);
        near_->around = rest_.box;
        near_->across = across;
    }

    [[nodiscard]] std::shared_ptr<SceneGrid> make(const SceneGrid* former)
    {
        const bool isAlike = former && former->hasCells() && former->across == near_->across &&
                             former->words.size() == words_.words.size() && former->structure == near_->structure &&
                             isSameBox(former->around, near_->around);
        std::vector<char> changed;
        if (isAlike) changed = changedNodes(program_, former->words, words_.words);
        if (near_->across > 0 && isFinite(rest_.box) && !rest_.steps.empty()) {
            const std::optional<FormerBox> before =
                isAlike ? std::optional<FormerBox>({former->occupied, changed}) : std::nullopt;
            near_->occupied = occupiedBox(program_, words_, rest_.steps, rest_.box, before ? &*before : nullptr);
        }
        near_->records = render::bytesOf(records_.records());
        const bool again =
            isAlike && isSameBox(former->occupied.box, near_->occupied.box) && change(*former, std::move(changed));
        if (!again) makeAll();
        return near_;
    }

private:
    /// Makes the cells that have changed. Returns false if all must be made.
    bool change(const SceneGrid& former, std::vector<char> nodes)
    {
        if (former.lists->size() > 2 * former.listsWithoutWaste) return false;
        ChangedCells changed = pruneChangedCells(program_, {words_, std::move(nodes), former.cells.split}, rest_.steps,
                                                 {former.cells.box, former.cells.count}, Pruner::asShaders, budget_);
        if (!changed.whole) return false;
        near_->again = true;
        near_->box = former.box;
        near_->cells.box = former.cells.box;
        near_->cells.count = former.cells.count;
        near_->cells.evaluations = changed.evaluations;
        near_->cells.split = std::move(changed.split);
        near_->listsWithoutWaste = former.listsWithoutWaste;
        PackedLists packed;
        const auto begin = static_cast<std::uint32_t>(former.lists->size() / sizeof(ListStep));
        for (const auto& [index, cell] : changed.cells) packList(packed, cell, changed.steps, begin, writer_);
        render::Bytes lists = *former.lists;
        append(lists, packed.steps.data(), packed.steps.size());
        render::Bytes grid = *former.grid;
        const GridHead head = gridHead(*near_, rest_, records_);
        std::memcpy(grid.data(), &head, sizeof head);
        for (const auto& [index, cell] : changed.cells) {
            const glm::uvec2 entry = gridEntry(cell, packed);
            std::memcpy(grid.data() + sizeof head + index * sizeof entry, &entry, sizeof entry);
        }
        near_->lists = std::make_shared<const render::Bytes>(std::move(lists));
        near_->grid = std::make_shared<const render::Bytes>(std::move(grid));
        return true;
    }

    void makeAll()
    {
        if (!near_->occupied.box.empty()) makeCells();
        PackedLists packed;
        if (near_->hasCells())
            for (const SceneCell& cell : near_->cells.cells) packList(packed, cell, near_->cells.steps, 0, writer_);
        else
            packed.steps = writer_.write(rest_.steps);
        near_->lists = render::bytesOf(packed.steps);
        near_->listsWithoutWaste = near_->lists->size();
        near_->grid =
            std::make_shared<const render::Bytes>(gridBytes(gridHead(*near_, rest_, records_), near_->cells, packed));
    }

    void makeCells()
    {
        near_->box = near_->occupied.box;
        const double longest = std::max({near_->box.high.x - near_->box.low.x, near_->box.high.y - near_->box.low.y,
                                         near_->box.high.z - near_->box.low.z, 1e-3});
        const render::Box box = grown(near_->box, 0.05 * longest);
        const auto shapes = static_cast<std::size_t>(std::count_if(
            rest_.steps.begin(), rest_.steps.end(), [](const Step& step) { return step.type == Step::Type::shape; }));
        // Larger cells take less time to find, and each contains more shapes.
        for (int cells = near_->across;; cells /= 2) {
            const double cell = 1.1 * longest / cells;
            const glm::ivec3 count = glm::max(glm::ivec3(glm::ceil(2.0 * box.halfSize() / cell - 1e-9)), glm::ivec3(1));
            near_->cells = pruneCells(program_, words_, rest_.steps, {box, count}, Pruner::asShaders, budget_);
            // If small blocks exclude hardly any shapes, larger ones exclude even fewer.
            const bool holdsAll = near_->cells.evaluations > near_->cells.looks * shapes / 4;
            if (near_->cells.whole || holdsAll || cells < 2 * fewestCells) break;
        }
        near_->crowded = !near_->cells.whole;
        if (near_->crowded) near_->cells = {};
    }

    const SceneProgram& program_;
    const SceneConstants& words_;
    const PruneBudget& budget_;
    SceneWithoutPlanes rest_;
    const ListRecords records_;
    ListWriter writer_;
    std::shared_ptr<SceneGrid> near_;
};

}  // namespace

std::shared_ptr<const SceneGrid> sceneGrid(const SceneProgram& program, const SceneConstants& words,
                                           const ListVocabulary& vocabulary, int across, const PruneBudget& budget,
                                           const SceneGrid* former)
{
    const auto begun = std::chrono::steady_clock::now();
    std::shared_ptr<SceneGrid> near = GridMaker(program, words, vocabulary, across, budget).make(former);
    near->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return near;
}

}  // namespace vitrine::scenes
