// Prints how many evaluations of a scene's field, and of its shapes, a pixel takes: all shapes at every point, and
// those of the cell that the point is in. Counts are exact and do not depend on the machine.

#include "exhibits/sdf_scenes/near_scene.h"
#include "exhibits/sdf_scenes/scene_field.h"
#include "exhibits/sdf_scenes/scene_reader.h"
#include "render/glsl/cpu.h"
#include "tests/bench/many_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace vitrine;
using glm::dvec3;

constexpr int width = 320, height = 200, block = 8;
constexpr double farthest = 100;  // Meters, as the source has it.
constexpr int cellsAcross = 64;

struct View {
    dvec3 eye{0}, forward{0}, right{0}, up{0};
    double tanHalf = 0.4;  ///< From the middle to the upper edge.

    View(const dvec3& from, const dvec3& target, const dvec3& upward, double fovY)
        : eye(from), forward(glm::normalize(target - from)), right(glm::normalize(glm::cross(forward, upward))),
          up(glm::cross(right, forward)), tanHalf(std::tan(0.5 * fovY))
    {
    }
    /// Pixel coordinates; centers are at halves.
    [[nodiscard]] dvec3 ray(double x, double y) const
    {
        const double u = (x / width * 2 - 1) * tanHalf * width / height;
        return glm::normalize(forward + right * u + up * ((1 - y / height * 2) * tanHalf));
    }
    [[nodiscard]] double halfPixel() const { return tanHalf / height; }
};

/// A field that counts what it is asked.
class CountedField {
public:
    /// Nothing of the scene is outside of `box`.
    CountedField(const scenes::SceneField& scene, std::span<const scenes::Step> steps,
                 std::span<const scenes::SceneCells> cells, const render::Box& box)
        : steps_(steps), cells_(cells), walk_(scene.program(), scene.words().words, false), box_(box),
          held_(!cells.empty() && cells.back().box.contains(box.low) && cells.back().box.contains(box.high))
    {
    }

    double operator()(const dvec3& p)
    {
        for (const scenes::SceneCells& cells : cells_) {
            if (!cells.box.contains(p)) continue;
            const std::size_t cell = cells.cellAt(p);
            if (cells.cells[cell].count > 0) return asked(cells.stepsOf(cells.cells[cell]), p);
            ++looks;
            return cells.clearance(cell, p);
        }
        if (held_) {  // The cells hold all of the scene, and more.
            ++looks;
            return glm::length(glm::max(glm::max(box_.low - p, p - box_.high), dvec3(0)));
        }
        return asked(steps_, p);
    }
    [[nodiscard]] std::size_t shapes() const { return walk_.shapesAsked(); }

    std::int64_t evaluations = 0, looks = 0;

private:
    double asked(std::span<const scenes::Step> steps, const dvec3& p)
    {
        if (steps.empty()) return 1e9;
        ++evaluations;
        walk_.run(steps, p);
        return walk_.state(0).distance;
    }

    std::span<const scenes::Step> steps_;
    std::span<const scenes::SceneCells> cells_;
    scenes::SceneWalk walk_;
    render::Box box_;
    bool held_;
};

struct Way {
    const char* name;
    double tolerance = 0;  ///< Meters; 0 is half a pixel.
    int stepLimit = 1000;
    bool relaxed = false;
    int largestCone = 0, smallestCone = 0;  ///< One march for each block of so many pixels, and of half as many, ...
    bool pruned = false;
    bool closedPlanes = false;  ///< Planes are met in closed form, and the rest by what is left of the way.
};
constexpr Way classic{"classic, half a pixel"};
constexpr Way sourcesWay{"the source's march: 255 steps, 1 mm", 0.001, 255};
constexpr Way fineWay{"classic, 0.1 mm", 1e-4};
constexpr Way kitsWay{"relaxed steps, cones", 0, 1000, true, block, block};
constexpr Way withCells{"relaxed steps, cones, cells", 0, 1000, true, block, block, true};
constexpr Way coneTree{"relaxed steps, cones of 32 to 2", 0, 1000, true, 32, 2};
constexpr Way coneTreeWithCells{"relaxed steps, cones of 32 to 2, cells", 0, 1000, true, 32, 2, true};
constexpr Way best{"the same, planes in closed form", 0, 1000, true, 32, 2, true, true};

/// Per pixel.
struct Found {
    double evaluations = 0, shapes = 0, looks = 0;
    int missed = 0, extra = 0, pixels = 0;
};

/// A scene, from where it is seen, what is hit, and its cells.
class Picture {
public:
    /// `reach`: how far the eye is from what it looks at. `stride`: only every so many blocks of 32 pixels, both ways.
    Picture(const scenes::SceneField& scene, const View& view, double reach, int stride, int across)
        : scene_(scene), view_(view), box_(scene.box()), rest_(scene.program(), scene.words(), 4), stride_(stride),
          truth_(width * height)
    {
        const auto finite = [](const render::Box& box) { return std::isfinite(glm::length(box.high - box.low)); };
        if (finite(box_)) box_ = scenes::occupiedBox(scene.program(), scene.words(), scene.program().steps(), box_);
        // Cells over all of a scene, or over what is around the target where it has no end, and wider and wider.
        const dvec3 middle = view.eye + view.forward * reach;
        const auto addCells = [&](std::span<const scenes::Step> steps, const render::Box& whole,
                                  std::vector<scenes::SceneCells>& into) {
            for (const double wide : {1.0, 4.0, 16.0}) {
                render::Box box = whole;
                if (!finite(whole))
                    box = {glm::max(box.low, middle - wide * reach), glm::min(box.high, middle + wide * reach)};
                into.push_back(cellsOf(steps, box, across));
                if (finite(whole)) break;
            }
        };
        addCells(scene.program().steps(), box_, cells_);
        if (!rest_.steps.empty()) {
            if (finite(rest_.box))
                rest_.box = scenes::occupiedBox(scene.program(), scene.words(), rest_.steps, rest_.box);
            addCells(rest_.steps, rest_.box, restCells_);
        }
        findTruth();
    }

    [[nodiscard]] const scenes::SceneCells& cells() const { return cells_.front(); }
    [[nodiscard]] double covered() const
    {
        return 100 * double(std::count(truth_.begin(), truth_.end(), 1)) * stride_ * stride_ / (width * height);
    }

    [[nodiscard]] Found measure(const Way& way) const
    {
        std::array<Found, 2> halves;
        {
            const std::jthread other([&] { measureHalf(way, 1, halves[1]); });
            measureHalf(way, 0, halves[0]);
        }
        Found found = halves[0];
        found.missed += halves[1].missed;
        found.extra += halves[1].extra;
        const double pixels = halves[0].pixels + halves[1].pixels;
        found.evaluations = (halves[0].evaluations + halves[1].evaluations) / pixels;
        found.shapes = (halves[0].shapes + halves[1].shapes) / pixels;
        found.looks = (halves[0].looks + halves[1].looks) / pixels;
        return found;
    }

private:
    static constexpr int large = 32;

    [[nodiscard]] scenes::SceneCells cellsOf(std::span<const scenes::Step> steps, render::Box box, int across) const
    {
        const dvec3 size = box.high - box.low;
        const double longest = std::max({size.x, size.y, size.z});
        box = scenes::grown(box, 0.05 * longest);
        const double cell = 1.1 * longest / across;
        const glm::ivec3 count = glm::max(glm::ivec3(glm::ceil(2.0 * box.halfSize() / cell - 1e-9)), glm::ivec3(1));
        return scenes::pruneCells(scene_.program(), scene_.words(), steps, box, count);
    }

    [[nodiscard]] bool isChosen(int x, int y) const { return x / large % stride_ == 0 && y / large % stride_ == 0; }

    /// Where a ray first is on a surface, by Hart's method at float64, unrelaxed, of all shapes, to 1e-9 m.
    void findTruth()
    {
        const auto rows = [&](int first) {
            CountedField field(scene_, scene_.program().steps(), {}, box_);
            glsl::Tracer tracer{[&](const dvec3& p) { return field(p); }};
            auto settings = tracer.marchSettings(0, farthest, 0);
            settings.toleranceFloor = 1e-9;
            settings.stepLimit = 100000;
            settings.relaxation = tracer.RELAXATION_NONE;
            for (int y = first; y < height; y += 2)
                for (int x = 0; x < width; ++x)
                    if (isChosen(x, y))
                        truth_[std::size_t(y * width + x)] =
                            tracer.sphereTrace(view_.eye, view_.ray(x + 0.5, y + 0.5), settings).hit;
        };
        const std::jthread other(rows, 1);
        rows(0);
    }

    void measureHalf(const Way& way, int half, Found& found) const
    {
        const std::vector<scenes::SceneCells>& cells = way.closedPlanes ? restCells_ : cells_;
        CountedField field(scene_,
                           way.closedPlanes ? std::span<const scenes::Step>(rest_.steps) : scene_.program().steps(),
                           way.pruned ? std::span(cells) : std::span<const scenes::SceneCells>(), boxOf(way));
        glsl::Tracer tracer{[&](const dvec3& p) { return field(p); }};
        for (int y = 0; y < height; y += large)
            for (int x = 0; x < width; x += large)
                if (isChosen(x, y) && (x + y) / large / stride_ % 2 == half)
                    trace(tracer, way, {x, y}, large, 0, found);
        found.evaluations = double(field.evaluations);
        found.shapes = double(field.shapes());
        found.looks = double(field.looks);
    }

    /// A block of pixels, none of which is hit before `start`.
    template <typename Tracer>
    void trace(Tracer& tracer, const Way& way, const glm::ivec2& at, int size, double start, Found& found) const
    {
        if (at.x >= width || at.y >= height) return;
        const dvec3 low = glm::clamp(boxOf(way).low, dvec3(-1e6), dvec3(1e6)),
                    high = glm::clamp(boxOf(way).high, dvec3(-1e6), dvec3(1e6));
        auto settings = tracer.marchSettings(start, farthest, way.tolerance > 0 ? 0 : view_.halfPixel());
        if (way.tolerance > 0) settings.toleranceFloor = way.tolerance;
        settings.stepLimit = way.stepLimit;
        settings.relaxation = way.relaxed ? tracer.RELAXATION_AUTOMATIC : tracer.RELAXATION_NONE;
        if (size > 1) {
            if (size <= way.largestCone && size >= way.smallestCone && start < farthest) {
                const dvec3 axis = view_.ray(at.x + 0.5 * size, at.y + 0.5 * size);
                double chord = 0;
                for (int corner = 0; corner < 4; ++corner)
                    chord = std::max(chord, tracer.coneChord(axis, view_.ray(at.x + size * (corner & 1),
                                                                             at.y + size * (corner >> 1))));
                const glm::dvec2 span = tracer.coneBox(view_.eye, axis, chord, low, high);
                settings.tMin = std::max(start, span.x);
                settings.tMax = std::min(span.y, farthest);
                const auto cone = tracer.coneMarch(view_.eye, axis, chord, settings);
                start = cone.empty ? 2 * farthest : cone.t;
            }
            for (int corner = 0; corner < 4; ++corner)
                trace(tracer, way, at + size / 2 * glm::ivec2(corner & 1, corner >> 1), size / 2, start, found);
            return;
        }
        const dvec3 ray = view_.ray(at.x + 0.5, at.y + 0.5);
        if (way.relaxed) {
            const glm::dvec2 span = tracer.rayBox(view_.eye, ray, low, high);
            settings.tMin = std::max(start, span.x);
            settings.tMax = std::min(farthest, span.y);
        }
        const double plane = way.closedPlanes ? planeAhead(ray) : 2 * farthest;
        settings.tMax = std::min(settings.tMax, plane);
        const bool hit = tracer.sphereTrace(view_.eye, ray, settings).hit || plane <= farthest;
        const bool isHit = truth_[std::size_t(at.y * width + at.x)] != 0;
        ++found.pixels;
        found.missed += isHit && !hit;
        found.extra += !isHit && hit;
    }

    [[nodiscard]] const render::Box& boxOf(const Way& way) const { return way.closedPlanes ? rest_.box : box_; }

    /// The eye is outside of all planes.
    [[nodiscard]] double planeAhead(const dvec3& ray) const
    {
        double first = 2 * farthest;
        for (const scenes::SceneWithoutPlanes::Plane& plane : rest_.planes) {
            const double towards = -glm::dot(plane.normal, ray);
            if (towards > 0) first = std::min(first, (glm::dot(plane.normal, view_.eye) - plane.height) / towards);
        }
        return first;
    }

    const scenes::SceneField& scene_;
    View view_;
    render::Box box_;
    scenes::SceneWithoutPlanes rest_;
    std::vector<scenes::SceneCells> restCells_;
    int stride_;
    std::vector<char> truth_;
    std::vector<scenes::SceneCells> cells_;
};

void print(const Way& way, const Found& found)
{
    std::printf("  %-38s %9.2f %11.2f %7.2f %8d %7d\n", way.name, found.evaluations, found.shapes, found.looks,
                found.missed, found.extra);
}

void printColumns()
{
    std::printf("  %-38s %9s %11s %7s %8s %7s\n", "", "fields", "shapes", "cells", "missed", "extra");
}

scenes::SceneField sceneOf(const std::string& root)
{
    const auto none = [](const std::string&) { return std::string(); };
    const auto read =
        scenes::readScene("{\"format\": \"vitrine-scene\", \"version\": 1, \"root\": " + root + "}", "bench", none);
    if (!read.scene) {
        std::fprintf(stderr, "%s\n", read.findings.front().text().c_str());
        std::exit(1);
    }
    return scenes::SceneField(read.scene);
}

/// Sixteen shapes, added, cut and shared, on a floor.
constexpr const char* sixteenOnAFloor = R"({"kind": "union", "children": [
    {"kind": "plane"},
    {"kind": "subtraction", "translate": [-1.1, 0.5, 0], "children": [
        {"kind": "box", "size": 1}, {"kind": "sphere", "radius": 0.62},
        {"kind": "cylinder", "radius": 0.2, "height": 2}, {"kind": "cylinder", "radius": 0.2, "height": 2, "rotate": [90, 0, 0]}]},
    {"kind": "intersection", "translate": [0.3, 0.5, 0.3], "rotate": [0, 30, 0], "children": [
        {"kind": "box", "size": 0.9}, {"kind": "sphere", "radius": 0.6}, {"kind": "octahedron", "radius": 0.75}]},
    {"kind": "union", "blend": "quadratic", "blendWidth": 0.2, "translate": [1.5, 0, -0.2], "children": [
        {"kind": "cappedCone", "height": 0.8, "bottomRadius": 0.4, "topRadius": 0.2, "translate": [0, 0.4, 0]},
        {"kind": "sphere", "radius": 0.3, "translate": [0, 0.95, 0]},
        {"kind": "torus", "majorRadius": 0.35, "minorRadius": 0.08, "translate": [0, 0.6, 0]},
        {"kind": "capsule", "start": [-0.5, 0.7, 0], "end": [0.5, 0.9, 0], "radius": 0.08}]},
    {"kind": "subtraction", "translate": [0, 0.2, 1.4], "children": [
        {"kind": "cylinder", "radius": 0.5, "height": 0.4}, {"kind": "cylinder", "radius": 0.42, "height": 0.4, "translate": [0, 0.05, 0]},
        {"kind": "box", "size": [0.3, 0.2, 2]}]},
    {"kind": "link", "translate": [-0.6, 0.1, 1.2], "rotate": [90, 20, 0]},
    {"kind": "hexagonalPrism", "translate": [0.9, 0.3, 1.1], "height": 0.5, "inradius": 0.25}]})";

struct Shapes {
    double all = 0, pruned = 0, each = 0;  ///< Per pixel; per evaluation with cells.
};

Shapes smoothUnion(int count)
{
    const scenes::SceneField scene = sceneOf(bench::manyShapes(count));
    const Picture picture(scene, View({2.2, 1.6, 3.2}, dvec3(0), {0, 1, 0}, 0.7), 4, count >= 256 ? 2 : 1,
                          count >= 256 ? 2 * cellsAcross : cellsAcross);
    const scenes::SceneCells& cells = picture.cells();
    std::printf(
        "\n%d shapes in one smooth union: %.1f %% of the pixels; of %zu cells %zu have shapes, %.2f each, %zu at "
        "most\n",
        count, picture.covered(), cells.cells.size(), cells.withSteps, cells.meanShapes, cells.mostShapes);
    printColumns();
    Shapes shapes;
    for (const Way& way : {classic, kitsWay, withCells, coneTreeWithCells}) {
        const Found found = picture.measure(way);
        print(way, found);
        if (way.name == kitsWay.name) shapes.all = found.shapes;
        if (way.name != withCells.name) continue;
        shapes.pruned = found.shapes;
        shapes.each = found.shapes / found.evaluations;
    }
    return shapes;
}

void onAFloor(const char* from, const View& view)
{
    const scenes::SceneField scene = sceneOf(sixteenOnAFloor);
    const Picture picture(scene, view, 5, 1, cellsAcross);
    std::printf("\nSixteen shapes, added, cut and shared, on a floor, %s\n", from);
    printColumns();
    Found least, plain;
    for (const Way& way : {fineWay, sourcesWay, classic, kitsWay, withCells, coneTree, coneTreeWithCells, best}) {
        const Found found = picture.measure(way);
        print(way, found);
        if (way.name == fineWay.name) plain = found;
        least = found;
    }
    std::printf(
        "\nSixteen shapes on a floor, %s, take %.2f field evaluations and %.1f shapes per pixel (goal: 5 fields) "
        "and miss %d pixels; classic sphere tracing to 0.1 mm takes %.2f and %.1f.\n",
        from, least.evaluations, least.shapes, least.missed, plain.evaluations, plain.shapes);
}

void compositions(const std::string& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::printf("\nThe scenes that come with the program: the source's march, every shape at every point, and ours\n"
                "  %-28s %7s %9s %9s %7s %9s %9s %7s %7s\n",
                "", "shapes", "fields", "asked", "missed", "fields", "asked", "cells", "missed");
    int missed = 0;
    for (const auto& file : files) {
        const scenes::ReadScene read = scenes::readSceneFile(file);
        if (!read.scene) continue;
        const scenes::SceneField scene(read.scene, 1);
        const std::vector<double> numbers = read.scene->numbersAt(1);
        const double* c = &numbers[read.scene->camera.numbers];
        const dvec3 eye(c[0], c[1], c[2]), target(c[3], c[4], c[5]);
        const Picture picture(scene, View(eye, target, {c[6], c[7], c[8]}, c[9]), glm::distance(eye, target), 1,
                              cellsAcross);
        const Found source = picture.measure(sourcesWay);
        const Found ours = picture.measure(best);
        std::size_t shapes = 0;
        for (const scenes::ProgramNode& node : scene.program().nodes()) shapes += node.firstChild == scenes::none;
        std::printf("  %-28s %7zu %9.2f %9.2f %7d %9.2f %9.2f %7.2f %7d\n", file.stem().c_str(), shapes,
                    source.evaluations, source.shapes, source.missed, ours.evaluations, ours.shapes, ours.looks,
                    ours.missed);
        missed += ours.missed;
    }
    std::printf("\nOurs misses %d pixels of all scenes.\n", missed);
}

}  // namespace

int main(int argc, char** argv)
{
    std::printf(
        "Per pixel of the whole %d x %d frame, float64. Fields: evaluations of the scene; shapes, asked: of its\n"
        "shapes; cells: looks at a cell that has none. Missed and extra: pixels against a trace of all shapes to\n"
        "1e-9 m, without relaxation. Cones: one march for each block of %d x %d pixels unless stated, included.\n"
        "Cells: %d along the longest side; a scene without end has them around the target, and four and sixteen times "
        "as\n"
        "large around these. Of 256 shapes and more, twice as many cells, and a quarter of the pixels, in blocks.\n",
        width, height, block, block, cellsAcross);
    onAFloor("up to the horizon", View({2.5, 2, 4.5}, {0, 0.4, 0.3}, {0, 1, 0}, 0.7));
    onAFloor("from above", View({2, 3.2, 3.4}, {0, 0.3, 0.3}, {0, 1, 0}, 0.6));
    Shapes at16, last;
    for (const int count : {4, 16, 64, 256, 1024}) {
        last = smoothUnion(count);
        if (count == 16) at16 = last;
    }
    std::printf(
        "\n1024 shapes take %.1f times the shapes of 16 per pixel where all are asked, and %.1f times with cells "
        "(per evaluation: %.1f times); of 1024, cells ask %.1f per pixel where all are %.0f.\n",
        last.all / at16.all, last.pruned / at16.pruned, last.each / at16.each, last.pruned, last.all);
    compositions(argc > 1 ? argv[1] : "assets/scenes");
    return 0;
}
