#include "exhibits/sdf_scenes/scene_grid.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <map>

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
    const bool moved = node.translate != none || node.rotate != none || node.scale != none;
    return !moved && program.kind(node).name == "union" && words.words[node.numbers + 1] == 0;
}

/// Header of the grid buffer (std430), as in shaders/sdf_scenes/near.glsl.
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

template <typename T> std::shared_ptr<const render::Bytes> bytesOf(const std::vector<T>& all)
{
    render::Bytes bytes;
    append(bytes, all.data(), all.size());
    return std::make_shared<const render::Bytes>(std::move(bytes));
}

/// Lists of all cells without duplicates, and the start of each list.
struct PackedLists {
    std::vector<ListStep> steps;
    std::map<std::uint32_t, std::uint32_t> startOf;  ///< Key: `SceneCell::first`.
};

PackedLists packLists(const GridCells& cells, ListWriter& writer)
{
    PackedLists packed;
    for (const SceneCell& cell : cells.cells) {
        if (cell.count == 0) continue;
        const auto [found, isNew] = packed.startOf.try_emplace(cell.first, std::uint32_t(packed.steps.size()));
        if (!isNew) continue;
        const std::vector<ListStep> list = writer.write(cells.stepsOf(cell));
        packed.steps.insert(packed.steps.end(), list.begin(), list.end());
    }
    return packed;
}

render::Bytes gridBytes(const SceneGrid& near, const SceneWithoutPlanes& rest, const ListRecords& records,
                        const PackedLists& packed)
{
    GridHead head{};
    const GridCells& cells = near.cells;
    const glm::dvec3 perMeter = cells.cells.empty() ? glm::dvec3(1) : 1.0 / cells.cellSize();
    head.low = glm::vec4(glm::dvec4(cells.cells.empty() ? glm::dvec3(0) : cells.box.low, perMeter.x));
    head.high = glm::vec4(glm::dvec4(cells.cells.empty() ? glm::dvec3(0) : cells.box.high, perMeter.y));
    const glm::dvec3 far(1e6);
    head.heldLow = glm::vec4(glm::dvec4(glm::clamp(near.box.low, -far, far), perMeter.z));
    head.heldHigh = glm::vec4(glm::dvec4(glm::clamp(near.box.high, -far, far), 0));
    head.count = cells.cells.empty() ? glm::uvec4(0) : glm::uvec4(glm::uvec3(cells.count), 1);
    for (std::size_t i = 0; i < rest.planes.size(); ++i) {
        head.planes[i] = glm::vec4(glm::dvec4(rest.planes[i].normal, rest.planes[i].height));
        head.planeMaterials[i] = records.ofMaterial(rest.planes[i].material);
    }
    render::Bytes bytes;
    append(bytes, &head, 1);
    std::vector<glm::uvec2> entries;
    entries.reserve(cells.cells.size());
    for (const SceneCell& cell : cells.cells) {
        glm::uvec2 entry(cell.count > 0 ? packed.startOf.at(cell.first) : nothing, 0);
        std::memcpy(&entry.y, &cell.distance, sizeof(float));
        entries.push_back(entry);
    }
    if (entries.empty()) entries.emplace_back(0, 0);
    append(bytes, entries.data(), entries.size());
    return bytes;
}

}  // namespace

SceneWithoutPlanes::SceneWithoutPlanes(const SceneProgram& program, const SceneConstants& words, std::size_t mostPlanes)
{
    const std::vector<ProgramNode>& nodes = program.nodes();
    std::vector<char> plain(nodes.size(), 0), gone(nodes.size(), 0);
    std::vector<std::uint32_t> left(nodes.size(), 0);
    const ListRecords ways(program, words);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const bool inPlain = nodes[i].parent == none || plain[nodes[i].parent] != 0;
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
        if (gone[i] != 0 && nodes[i].parent != none) --left[nodes[i].parent];
    }
    // The boxes of children of plain unions are in scene space.
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        const bool whole = gone[i] == 0 && plain[i] == 0 && (nodes[i].parent == none || plain[nodes[i].parent] != 0);
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
    // 14 cells per shape along each axis, if the shapes are distributed evenly.
    return std::clamp(static_cast<int>(14 * std::cbrt(static_cast<double>(shapes))), 24, 144);
}

std::shared_ptr<const SceneGrid> sceneGrid(const SceneProgram& program, const SceneConstants& words,
                                           const ListVocabulary& vocabulary, int across, const PruneBudget& budget)
{
    const auto begun = std::chrono::steady_clock::now();
    auto near = std::make_shared<SceneGrid>();
    SceneWithoutPlanes rest(program, words, across > 0 ? SceneGrid::mostPlanes : 0);
    near->planes = static_cast<std::uint32_t>(rest.planes.size());
    near->box = rest.box;
    const ListRecords records(program, words);
    ListWriter writer(program, vocabulary, &records);
    PackedLists packed;
    const bool ends = across > 0 && isFinite(rest.box) && !rest.steps.empty();
    const render::Box occupied = ends ? occupiedBox(program, words, rest.steps, rest.box) : render::Box{};
    if (!occupied.empty()) {
        near->box = occupied;
        const double longest = std::max({near->box.high.x - near->box.low.x, near->box.high.y - near->box.low.y,
                                         near->box.high.z - near->box.low.z, 1e-3});
        const render::Box box = grown(near->box, 0.05 * longest);
        const auto shapes = static_cast<std::size_t>(std::count_if(
            rest.steps.begin(), rest.steps.end(), [](const Step& step) { return step.type == Step::Type::shape; }));
        // Larger cells take less time to find, and each contains more shapes.
        for (int cells = across;; cells /= 2) {
            const double cell = 1.1 * longest / cells;
            const glm::ivec3 count = glm::max(glm::ivec3(glm::ceil(2.0 * box.halfSize() / cell - 1e-9)), glm::ivec3(1));
            near->cells = pruneCells(program, words, rest.steps, {box, count}, Pruner::asShaders, budget);
            // If small blocks exclude hardly any shapes, larger ones exclude even fewer.
            const bool holdsAll = near->cells.evaluations > near->cells.looks * shapes / 4;
            if (near->cells.whole || holdsAll || cells < 2 * fewestCells) break;
        }
        near->crowded = !near->cells.whole;
        if (near->crowded) near->cells = {};
    }
    if (near->cells.cells.empty())
        packed.steps = writer.write(rest.steps);
    else
        packed = packLists(near->cells, writer);
    if (packed.steps.empty()) packed.steps.emplace_back();
    near->records = bytesOf(records.records());
    near->lists = bytesOf(packed.steps);
    near->grid = std::make_shared<const render::Bytes>(gridBytes(*near, rest, records, packed));
    near->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return near;
}

}  // namespace vitrine::scenes
