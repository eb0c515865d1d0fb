// Prints how many solids an ice cream asks for each pixel: as its source does, all of them at every point, and as the
// exhibit does. Counts are exact and do not depend on the machine.

#include "exhibits/ice_cream/ice_cream_cpu.h"
#include "exhibits/ice_cream/ice_cream_cpu32.h"
#include "exhibits/ice_cream/sprinkles.h"
#include "tests/exhibits/ice_cream/every_solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace vitrine;
using glm::dvec3;

constexpr int width = 784, height = 441, block = 8;
constexpr int samplesAcross = 2;  // Of a pixel, each way.
constexpr double halfPixel = 0.5 / height;
const dvec3 eye(0, 1.5, 2);
const dvec3 toSun = glm::normalize(dvec3(-16, 12, 4));

dvec3 rayThrough(double x, double y)
{
    static const dvec3 forward = glm::normalize(dvec3(0, 0.5, 0) - eye);
    static const dvec3 right(1, 0, 0), up = glm::cross(right, forward);
    return glm::normalize(forward + right * ((x - 0.5 * width) / height) + up * ((0.5 * height - y) / height));
}

/// Solids asked, by what for.
struct Solids {
    double march = 0, normals = 0, shadows = 0, occlusion = 0;
    int pixels = 0, missed = 0;

    [[nodiscard]] double all() const { return march + normals + shadows + occlusion; }
};

const IceCreamTable& table()
{
    static const IceCreamTable made;
    return made;
}

ParameterValues sourceValues()
{
    ParameterValues values = table().initial();
    values.set(table().lighting, IceCreamLighting::source);
    return values;
}

/// The source: every solid and the ground at every point; hits nearer than 1e-5 of the way; central differences;
/// improved shadows up to 5 m; five samples of occlusion; all of it for each of four samples. `stride` skips pixels of
/// both axes.
Solids sourcesWay(const IceCreamShape& shape, int stride, bool shadows, bool occlusion)
{
    const test::EverySolid every(shape);
    const double each = every.solids() + 1;
    const auto level = [&](const dvec3& p) { return std::min(every.level(p), p.y); };
    Solids found;
    for (int y = 0; y < height; y += stride)
        for (int x = 0; x < width; x += stride) {
            ++found.pixels;
            for (int s = 0; s < samplesAcross * samplesAcross; ++s) {
                const dvec3 ray = rayThrough(x + (s % 2 + 0.5) / 2, y + (s / 2 + 0.5) / 2.0);
                double t = 1;
                for (int i = 0; i < 128 && t < 1e8; ++i) {
                    const double d = level(eye + ray * t);
                    found.march += each;
                    if (d < 1e-5 * t) break;
                    t += d;
                }
                if (t >= 1e8) continue;
                found.normals += 6 * each;
                if (occlusion) found.occlusion += 5 * each;
                if (!shadows) continue;
                const dvec3 p = eye + ray * t;
                double seen = 1, previous = 1e20;
                for (double along = 0.07; along < 5 && seen > 1e-5;) {
                    const double d = level(p + toSun * along);
                    found.shadows += each;
                    if (d < 1e-5) break;
                    const double back = d * d / (2 * previous);
                    seen = std::min(seen,
                                    32 * std::sqrt(std::max(d * d - back * back, 0.0)) / std::max(along - back, 1e-9));
                    previous = d;
                    along += d;
                }
            }
        }
    return found;
}

/// The exhibit: box, cones, relaxed steps, the few solids that decide; the ground found without a march, and its shadow
/// rays only where they pass the box.
class OurWay {
public:
    OurWay(const IceCreamShape& shape, const Sprinkles* sprinkles, bool shadows, bool occlusion)
        : shadows_(shadows), occlusion_(occlusion)
    {
        copyShape(solids_.shape, shape);
        if (sprinkles) {
            solids_.shape.gridLow = sprinkles->low;
            solids_.shape.gridCell = sprinkles->cell;
            solids_.shape.gridCells = sprinkles->cells;
            solids_.sprinkles.ends = sprinkles->ends;
            for (const Sprinkles::Cell& cell : sprinkles->grid)
                solids_.sprinkles.cells.push_back({cell.first, cell.end, cell.clear});
        }
        const render::Box box = boxOf(shape);
        low_ = glm::vec3(box.low);
        high_ = glm::vec3(box.high);
    }

    /// Blocks of 8 x 8 pixels, every `stride`-th along both axes. `truth` tells whether a ray hits, at float64.
    template <typename Truth> Solids measure(int stride, const Truth& truth)
    {
        Solids found;
        for (int by = 0; by + block <= height; by += block * stride)
            for (int bx = 0; bx + block <= width; bx += block * stride)
                for (int s = 0; s < samplesAcross * samplesAcross; ++s) blockOf(bx, by, s, truth, found);
        found.pixels /= samplesAcross * samplesAcross;
        return found;
    }

private:
    glsl32::IceCream solids_;
    glm::vec3 low_{0}, high_{0};
    bool shadows_, occlusion_;

    template <typename Truth> void blockOf(int bx, int by, int s, const Truth& truth, Solids& found)
    {
        glsl32::Tracer tracer{[this](const glm::vec3& p) { return solids_.iceCreamDistance(p); }};
        glsl32::Tracer level{[this](const glm::vec3& p) { return solids_.iceCreamLevel(p); }};
        const glm::vec3 from(eye);
        const glm::vec3 axis(rayThrough(bx + 0.5 * block, by + 0.5 * block));
        float chord = 0;
        for (int corner = 0; corner < 4; ++corner)
            chord = std::max(chord, tracer.coneChord(axis, glm::vec3(rayThrough(bx + block * (corner & 1),
                                                                                by + block * (corner >> 1)))));
        const glm::vec2 coneSpan = tracer.coneBox(from, axis, chord * 1.0001F, low_, high_);
        float start = 1e30F;
        if (coneSpan.x <= coneSpan.y) {
            take();
            const auto cone = tracer.coneMarch(from, axis, chord * 1.0001F,
                                               tracer.marchSettings(coneSpan.x, coneSpan.y, float(halfPixel)));
            found.march += take();
            if (!cone.empty) start = cone.t;
        }
        for (int y = by; y < by + block; ++y)
            for (int x = bx; x < bx + block; ++x) {
                ++found.pixels;
                const dvec3 ray = rayThrough(x + (s % 2 + 0.5) / 2, y + (s / 2 + 0.5) / 2.0);
                const glm::vec3 direction(ray);
                glm::vec2 span = tracer.rayBox(from, direction, low_, high_);
                span.x = std::max(span.x, start);
                take();
                const auto march =
                    tracer.sphereTrace(from, direction, tracer.marchSettings(span.x, span.y, float(halfPixel)));
                found.march += take();
                if (s == 0 && (x + y) % 4 == 0) found.missed += !march.hit && truth(ray);
                glm::vec3 p = from + direction * march.t, n(0, 1, 0);
                if (march.hit) {
                    n = level.fieldNormal(p, 3e-4F, level.NORMAL_CENTRAL, -direction);
                    found.normals += take();
                } else {
                    if (!(ray.y < 0)) continue;
                    p = glm::vec3(eye + ray * (-eye.y / ray.y));
                }
                shade(tracer, march.hit, p, n, found);
            }
    }

    template <typename Tracer>
    void shade(Tracer& tracer, bool hit, const glm::vec3& p, const glm::vec3& n, Solids& found)
    {
        const glm::vec3 sun(toSun);
        const float width_ = 1.0F / 32;
        if (shadows_ && glm::dot(n, sun) > 0) {
            glm::vec3 margin(0);
            if (!hit) margin = glm::vec3(width_ * glm::length(glm::max(glm::abs(low_ - p), glm::abs(high_ - p))));
            const glm::vec3 at = p + n * 1e-3F;
            const glm::vec2 span = tracer.rayBox(at, sun, low_ - margin, high_ + margin);
            take();
            if (span.x < span.y) (void)tracer.shadowAaltonen(at, sun, width_, std::max(span.x, 0.004F), span.y, 128);
            found.shadows += take();
        }
        const bool near = glm::length(glm::max(glm::max(low_ - p, p - high_), glm::vec3(0))) < 0.6F;
        if (!occlusion_ || !near) return;
        take();
        for (int i = 0; i < 5; ++i) (void)solids_.iceCreamLevel(p + n * (1e-5F + 0.15F * static_cast<float>(i)));
        found.occlusion += take();
    }

    /// Those asked since it was called last.
    double take()
    {
        const int count = solids_.solids;
        solids_.solids = 0;
        return count;
    }
};

void print(const char* name, const Solids& s)
{
    std::printf("  %-42s %9.1f %9.1f %9.1f %9.1f %10.1f\n", name, s.march / s.pixels, s.normals / s.pixels,
                s.shadows / s.pixels, s.occlusion / s.pixels, s.all() / s.pixels);
}

const char* const columns = "\n  %-42s %9s %9s %9s %9s %10s\n";

/// Whether a ray meets the ice cream, at float64 by short steps of the level.
auto truthOf(const IceCreamShape& shape)
{
    return [every = test::EverySolid(shape)](const dvec3& ray) {
        double t = 0.5;
        for (int i = 0; i < 4000 && t < 4.5; ++i) {
            const double d = every.level(eye + ray * t);
            if (d < 1e-9) return true;
            t += d / 3;  // The steepest twist is less steep than 3 within the cream.
        }
        return false;
    };
}

void stages()
{
    std::printf(columns, "stage", "march", "normals", "shadows", "occlusion", "all");
    struct Stage {
        const char* name;
        IceCreamStage stage;
    };
    Solids source, exhibit;
    int missed = 0;
    for (const Stage& stage :
         {Stage{"first frustum", IceCreamStage::foot}, Stage{"five parts", IceCreamStage::bars},
          Stage{"smooth wafer", IceCreamStage::wafer}, Stage{"cones repeated", IceCreamStage::repeated},
          Stage{"twisted", IceCreamStage::twist}, Stage{"both layers", IceCreamStage::layers},
          Stage{"candies", IceCreamStage::candies}, Stage{"soft shadow", IceCreamStage::improved},
          Stage{"occlusion", IceCreamStage::finished}}) {
        ParameterValues values = sourceValues();
        values.set(table().stage, stage.stage);
        const IceCreamShape shape = iceCreamShape(table(), values, 0);
        const bool shadows = stage.stage >= IceCreamStage::classic, occlusion = stage.stage >= IceCreamStage::occlusion;
        source = sourcesWay(shape, 7, shadows, occlusion);
        exhibit = OurWay(shape, nullptr, shadows, occlusion).measure(2, truthOf(shape));
        print((std::string(stage.name) + ", the source's way").c_str(), source);
        print((std::string(stage.name) + ", ours").c_str(), exhibit);
        missed += exhibit.missed;
    }
    const double theirs = source.all() / source.pixels, ours = exhibit.all() / exhibit.pixels;
    std::printf(
        "\nWith all of its light, the source's way asks %.0f solids for each pixel, ours %.1f: %.0f times fewer; %d "
        "pixels are missed against float64 over all stages.\n",
        theirs, ours, theirs / ours, missed);
}

void sprinkled()
{
    std::printf(columns, "sprinkles, ours", "march", "normals", "shadows", "occlusion", "all");
    double ten = 0, thousand = 0;
    for (const int count : {0, 10, 100, 1000}) {
        ParameterValues values = sourceValues();
        values.set(table().sprinkles, count);
        const IceCreamShape shape = iceCreamShape(table(), values, 0);
        const Sprinkles sprinkles = strewn(shape, {count, 1, values[table().sprinkleLength]});
        const Solids found =
            OurWay(shape, count > 0 ? &sprinkles : nullptr, true, true).measure(2, [](const dvec3&) { return false; });
        print(std::to_string(count).c_str(), found);
        if (count == 10) ten = found.all() / found.pixels;
        if (count == 1000) thousand = found.all() / found.pixels;
    }
    std::printf("\nA thousand sprinkles cost %.2f times the solids that ten cost.\n", thousand / ten);
}

}  // namespace

int main()
{
    std::printf(
        "Solids asked for each pixel at %d x %d with %d samples, from the source's first view.\n"
        "The source's way: every 7th pixel along both axes. Ours, at float32: every second block of 8 x 8 pixels; a "
        "sixteenth of its rays is held against float64.\n",
        width, height, samplesAcross * samplesAcross);
    stages();
    sprinkled();
    return 0;
}
