// Evaluations of the field per pixel by the tracing variants of lib/sphere_tracing.glsl, and pixels that they miss.
// Counts are exact and do not depend on the machine.

#include "tests/bench/bench.h"

#include "exhibits/sdf_morph/torus_mug_cpu.h"
#include "exhibits/sdf_morph/torus_mug_cpu32.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <utility>
#include <vector>

namespace vitrine::bench {
namespace {

namespace exact = vitrine::glsl;
namespace gpu = vitrine::glsl32;

constexpr int width = 320;
constexpr int height = 200;
constexpr int block = 8;
constexpr double tanHalfFovY = 0.26;  // 29 degrees.
constexpr double farthest = 20;       // Length of a ray without a bounding box, in meters.
constexpr double pixelCone = tanHalfFovY / height;

/// View from a distance at which the object covers a fifth of the frame: slightly from above and from the side of the
/// handle.
struct View {
    glm::dvec3 eye{1.05, 0.75, 2.05};
    glm::dvec3 forward = glm::normalize(glm::dvec3(0, -0.05, 0) - eye);
    glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    glm::dvec3 up = glm::cross(right, forward);

    /// Returns the ray through a pixel; pixel centers are at halves.
    [[nodiscard]] glm::dvec3 ray(double x, double y) const
    {
        const double u = (x / width * 2 - 1) * tanHalfFovY * width / height;
        const double v = (1 - y / height * 2) * tanHalfFovY;
        return glm::normalize(forward + right * u + up * v);
    }
};

exact::TorusMug mug64(double morph)
{
    return {morph, 0.35, 0.12, 0.28, 0.66, 0.045, 0.165, 0.09, 0.06};
}
gpu::TorusMug mug32(double morph)
{
    return {static_cast<float>(morph), 0.35F, 0.12F, 0.28F, 0.66F, 0.045F, 0.165F, 0.09F, 0.06F};
}

/// Returns the hits of Hart's method at float64, unrelaxed, to a tolerance of 1e-9 m.
std::vector<bool> reference(const View& view, double morph)
{
    const auto shape = exact::torusMugShape(mug64(morph));
    exact::Tracer tracer{[&](const glm::dvec3& p) { return exact::sdfTorusMug(p, shape); }};
    auto settings = tracer.marchSettings(0, farthest, 0);
    settings.toleranceFloor = 1e-9;
    settings.stepLimit = 100000;
    settings.relaxation = tracer.RELAXATION_NONE;
    std::vector<bool> hits;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            hits.push_back(tracer.sphereTrace(view.eye, view.ray(x + 0.5, y + 0.5), settings).hit);
    return hits;
}

struct Variant {
    const char* name;
    int relaxation = 0;
    double omega = 1;
    bool box = false;
    bool cone = false;
    double absoluteTolerance = 0;  ///< Meters; 0 means half a pixel.
};

/// Evaluations per pixel of a variant, and the number of missed pixels.
struct Found {
    double evaluations = 0;
    int missed = 0;
};

Found measure(const View& view, double morph, const std::vector<bool>& truth, const Variant& variant)
{
    const auto shape = gpu::torusMugShape(mug32(morph));
    std::int64_t calls = 0;
    gpu::Tracer tracer{[&](const glm::vec3& p) {
        ++calls;
        return gpu::sdfTorusMug(p, shape);
    }};
    const auto bounds = gpu::torusMugBox(shape);
    const glm::vec3 low = bounds.center - bounds.halfSize, high = bounds.center + bounds.halfSize;
    const glm::vec3 eye(view.eye);

    auto settings = tracer.marchSettings(0, farthest, variant.absoluteTolerance > 0 ? 0.0F : float(pixelCone));
    if (variant.absoluteTolerance > 0) settings.toleranceFloor = float(variant.absoluteTolerance);
    settings.stepLimit = 1000;
    settings.relaxation = variant.relaxation;
    settings.omega = float(variant.omega);

    std::int64_t inCones = 0, counted = 0;
    int missed = 0, extra = 0;
    for (int by = 0; by < height; by += block) {
        for (int bx = 0; bx < width; bx += block) {
            glm::vec2 blockSpan(0, farthest);
            if (variant.cone) {
                const glm::vec3 axis(view.ray(bx + block / 2, by + block / 2));
                float chord = 0;
                for (int corner = 0; corner < 4; ++corner)
                    chord = std::max(chord, tracer.coneChord(axis, glm::vec3(view.ray(bx + block * (corner & 1),
                                                                                      by + block * (corner >> 1)))));
                chord *= 1.0001F;  // Margin for the rounding of the directions.
                if (variant.box) blockSpan = tracer.coneBox(eye, axis, chord, low, high);
                auto coneSettings = settings;
                coneSettings.tMin = blockSpan.x;
                coneSettings.tMax = blockSpan.y;
                const auto cone = tracer.coneMarch(eye, axis, chord, coneSettings);
                inCones += cone.evaluations;
                blockSpan.x = cone.empty ? 2 * float(farthest) : cone.t;
            }
            for (int y = by; y < by + block; ++y) {
                for (int x = bx; x < bx + block; ++x) {
                    const glm::vec3 direction(view.ray(x + 0.5, y + 0.5));
                    glm::vec2 span(0, farthest);
                    if (variant.box) span = glsl::rayBox(eye, direction, low, high);
                    settings.tMin = std::max(span.x, blockSpan.x);
                    settings.tMax = span.y;
                    const auto march = tracer.sphereTrace(eye, direction, settings);
                    counted += march.evaluations;
                    const bool hit = truth[std::size_t(y * width + x)];
                    missed += hit && !march.hit;
                    extra += !hit && march.hit;
                }
            }
        }
    }
    const double pixels = width * height;
    std::printf("  %-38s %7.2f %7.2f %9d %8d%s\n", variant.name, double(counted + inCones) / pixels,
                double(inCones) / pixels, missed, extra, calls == counted + inCones ? "" : "   COUNTERS DISAGREE");
    return {double(counted + inCones) / pixels, missed};
}

/// The same for shadows, compared with 400 hard rays over the light's disk at float64.
void shadows(const View& view, double morph)
{
    const auto shape = exact::torusMugShape(mug64(morph));
    exact::Tracer tracer{[&](const glm::dvec3& p) { return std::min(exact::sdfTorusMug(p, shape), p.y + 0.47); }};
    const glm::dvec3 toLight = glm::normalize(glm::dvec3(-0.5, 1, 0.7));
    const double tanRadius = 0.06;
    struct Row {
        const char* name;
        double squares = 0, penumbraSquares = 0, evaluations = 0;
    };
    std::vector<Row> rows{{"hard"}, {"classic"}, {"Aaltonen"}, {"signed (default)"}, {"area 4"}, {"area 16"}};
    int points = 0, penumbra = 0;
    for (int y = 0; y < height; y += 3) {
        for (int x = 0; x < width; x += 3) {
            const glm::dvec3 ray = view.ray(x + 0.5, y + 0.5);
            const auto march = tracer.sphereTrace(view.eye, ray, tracer.marchSettings(0, 6, pixelCone));
            if (!march.hit) continue;
            const glm::dvec3 at = view.eye + ray * march.t;
            const glm::dvec3 normal = tracer.fieldNormal(at, 3e-4, tracer.NORMAL_CENTRAL, -ray);
            if (glm::dot(normal, toLight) <= 0.1) continue;
            const glm::dvec3 p = at + normal * 0.004;
            constexpr double start = 0.004, end = 4;
            constexpr int limit = 256;
            const double truth = tracer.shadowArea(p, toLight, tanRadius, start, end, limit, 400, 0).visibility;
            const double rotation = exact::unitFromBits(exact::pcg(std::uint32_t(y * width + x))) * 6.283185307;
            const decltype(tracer.shadowHard(p, toLight, start, end, limit)) found[] = {
                tracer.shadowHard(p, toLight, start, end, limit),
                tracer.shadowClassic(p, toLight, tanRadius, start, end, limit),
                tracer.shadowAaltonen(p, toLight, tanRadius, start, end, limit),
                tracer.shadowSigned(p, toLight, tanRadius, start, end, limit),
                tracer.shadowArea(p, toLight, tanRadius, start, end, limit, 4, rotation),
                tracer.shadowArea(p, toLight, tanRadius, start, end, limit, 16, rotation),
            };
            const bool partly = truth > 0 && truth < 1;
            ++points;
            penumbra += partly;
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const double error = found[i].visibility - truth;
                rows[i].squares += error * error;
                if (partly) rows[i].penumbraSquares += error * error;
                rows[i].evaluations += found[i].evaluations;
            }
        }
    }
    std::printf("\nShadows at morph %.2g on a floor: %d points, %d in the penumbra; light's half angle atan(0.06);\n"
                "truth: 400 rays over its disk, float64\n  %-38s %7s %9s %9s\n",
                morph, points, penumbra, "method", "evals", "RMSE", "penumbra");
    for (const Row& row : rows)
        std::printf("  %-38s %7.1f %9.4f %9.4f\n", row.name, row.evaluations / points, std::sqrt(row.squares / points),
                    std::sqrt(row.penumbraSquares / std::max(penumbra, 1)));
}

/// Prints the angle between float32 normals and float64 central differences with a step of 1e-6.
void normals(const View& view)
{
    const auto shape64 = exact::torusMugShape(mug64(1));
    const auto shape32 = gpu::torusMugShape(mug32(1));
    exact::Tracer truth{[&](const glm::dvec3& p) { return exact::sdfTorusMug(p, shape64); }};
    gpu::Tracer tracer{[&](const glm::vec3& p) { return gpu::sdfTorusMug(p, shape32); }};
    std::vector<std::pair<glm::dvec3, glm::dvec3>> points;
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; x += 2) {
            const glm::dvec3 ray = view.ray(x + 0.5, y + 0.5);
            const auto march = truth.sphereTrace(view.eye, ray, truth.marchSettings(0, 6, pixelCone));
            if (!march.hit) continue;
            const glm::dvec3 p(glm::vec3(view.eye + ray * march.t));
            points.emplace_back(p, truth.fieldNormal(p, 1e-6, truth.NORMAL_CENTRAL, -ray));
        }
    }
    std::printf("\nNormals of the mug at float32, degrees off (%zu points)\n  %-14s %6s %9s %9s %9s\n", points.size(),
                "method", "step", "median", "95 %", "largest");
    const char* const names[] = {"forward", "tetrahedron", "central"};
    for (const double step : {1e-2, 1e-3, 3e-4, 1e-5, 1e-6}) {
        for (int method = 0; method < 3; ++method) {
            std::vector<double> errors;
            for (const auto& [p, n] : points) {
                const glm::dvec3 found(tracer.fieldNormal(glm::vec3(p), float(step), method, glm::vec3(0, 0, 1)));
                errors.push_back(glm::degrees(std::atan2(glm::length(glm::cross(found, n)), glm::dot(found, n))));
            }
            std::sort(errors.begin(), errors.end());
            std::printf("  %-14s %6.0e %9.4f %9.4f %9.4f\n", names[method], step, errors[errors.size() / 2],
                        errors[errors.size() * 95 / 100], errors.back());
        }
    }
}

}  // namespace

bool sdfEvaluations(const Options&)
{
    const View view;
    const Variant variants[] = {
        {"classic, 1e-4 m", 0, 1, false, false, 1e-4},
        {"classic, half a pixel", 0},
        {"over-relaxation 1.2", 1, 1.2},
        {"over-relaxation 1.6", 1, 1.6},
        {"automatic relaxation", 2},
        {"classic + box", 0, 1, true},
        {"automatic relaxation + box", 2, 1, true},
        {"classic + cones", 0, 1, false, true},
        {"automatic relaxation + cones", 2, 1, false, true},
        {"automatic relaxation + box + cones", 2, 1, true, true},
    };
    std::printf(
        "```\nEvaluations per pixel of the whole %d x %d frame, float32; tolerance half a pixel unless stated.\n"
        "Missed and extra: pixels against a float64 trace to 1e-9 m. Cones: one march per %d x %d pixels, included.\n",
        width, height, block, block);
    std::vector<Found> plain, best;
    for (const double morph : {0.0, 0.5, 1.0}) {
        const std::vector<bool> truth = reference(view, morph);
        std::printf("\n%s (morph %.1f): %.1f %% of the pixels\n  %-38s %7s %7s %9s %8s\n",
                    morph == 0   ? "Torus"
                    : morph == 1 ? "Mug"
                                 : "Half melted",
                    morph, 100.0 * double(std::count(truth.begin(), truth.end(), true)) / (width * height), "variant",
                    "all", "cones", "missed", "extra");
        for (const Variant& variant : variants) {
            const Found found = measure(view, morph, truth, variant);
            if (&variant == &variants[1]) plain.push_back(found);
            if (&variant == &variants[std::size(variants) - 1]) best.push_back(found);
        }
    }
    std::printf(
        "\nBox, cones and automatic relaxation find torus, half melted and mug with %.2f, %.2f and %.2f field "
        "evaluations per pixel of "
        "the frame at half-pixel tolerance and miss %d pixels; classic sphere tracing takes %.2f, %.2f and %.2f.\n",
        best[0].evaluations, best[1].evaluations, best[2].evaluations, best[0].missed + best[1].missed + best[2].missed,
        plain[0].evaluations, plain[1].evaluations, plain[2].evaluations);
    shadows(view, 1);
    normals(view);
    std::printf("```\n");
    return true;
}

}  // namespace vitrine::bench
