#include "exhibits/framework/table/random_values.h"
#include "exhibits/museum/picture.h"
#include "exhibits/stability/poison.h"
#include "exhibits/stability/stability_cases.h"
#include "exhibits/stability/stability_scan.h"
#include "shaders/lib/bindings.glsl"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace vitrine::stability {
namespace {

/// Returns the largest difference of any channel; infinite if sizes differ, or if only one value is a number somewhere.
double difference(const render::Image& a, const render::Image& b)
{
    if (a.pixels.size() != b.pixels.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (a.pixels[i] == b.pixels[i] || (std::isnan(a.pixels[i]) && std::isnan(b.pixels[i]))) continue;
        const double d = std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]));
        largest = std::isfinite(d) ? std::max(largest, d) : std::numeric_limits<double>::infinity();
    }
    return largest;
}

/// The initial view of the exhibit at index `i`, alone, in light that is cheap to capture.
struct Still {
    SceneState sceneState;
    PictureRequest request;
};

Still still(const Museum& museum, std::size_t i)
{
    Still s{museum.initialSceneState(), {}};
    s.sceneState.hall() = cheapestValues(museum.hall().parameters());
    s.request.frame.alone = i;
    s.request.frame.camera = museum.subject(i).bestView(s.sceneState.values[i]);
    s.request.frame.raster.size = {45, 27};
    s.request.frame.averageIn = AverageIn::radiance;
    return s;
}

render::Image picture(const Museum& museum, render::RenderBackend& backend, const Still& s)
{
    PictureMaker maker(museum, backend, s.sceneState, s.request);
    while (maker.step()) {
    }
    return maker.picture();
}

/// Returns the frame drawn over memory filled with `poison`.
render::Image over(const Poison& poison, const Museum& museum, render::RenderBackend& backend, const Still& s)
{
    FrameRequest frame = s.request.frame;
    frame.finished = true;  // With its own programs: see scanCase.
    const render::FramePlan plan = museum.plan(museum.prepare(s.sceneState, frame), frame, backend.persistentState());
    (void)backend.draw(poisoned(plan, poison));
    return backend.read("frame");
}

/// Number, text and limit of a case that compares pictures of every exhibit.
struct PictureCase {
    std::string number, what;
    double limit;
};

/// Computes a difference for every exhibit that must not exceed the limit, and keeps the largest.
template <typename Difference>
StabilityResult overExhibits(const Museum& museum, const PictureCase& c, const StabilityProgress& progress,
                             const Difference& differenceOf)
{
    StabilityResult result{c.number, c.what, true, 0, c.limit, {}};
    const std::span<const MuseumExhibit> all = museum.exhibits();
    std::size_t tried = 0;
    for (const auto& [i, exhibit] : all) {
        if (progress && !progress(static_cast<double>(tried) / static_cast<double>(all.size()))) break;
        const double d = differenceOf(i);
        ++tried;
        if (d <= result.value) continue;
        result.value = d;
        result.passed = d <= c.limit;
        result.detail = std::string(exhibit.name());
    }
    result.tried = tried > 0 || all.empty();
    if (tried < all.size())
        result.detail += (result.detail.empty() ? "" : "; ") + std::to_string(tried) + " of " +
                         std::to_string(all.size()) + " exhibits within the time";
    return result;
}

StabilityResult meanOfThousands(render::RenderBackend& backend)
{
    constexpr int samples = 4096;
    render::FramePlan plan;
    plan.view = render::makeView({}, {.size = {1, 1}});
    plan.image({.name = "one", .format = render::Format::rgba16f});
    plan.image({.name = "sum", .format = render::Format::r16f});
    plan.image({.name = "mean", .format = render::Format::rgba32f});
    const auto pass = [](std::string name, const char* target, render::Load load, float value) {
        render::Pass p;
        p.name = std::move(name);
        p.shader = {.vertex = "lib/fullscreen.vert", .fragment = "lib/copy.frag"};
        p.colors = {{.image = target, .load = load, .clear = glm::vec4(value)}};
        p.inputs = {{UNIT_SOURCE, std::string("one")}};
        return p;
    };
    plan.add(pass("one", "one", render::Load::clear, 1));
    plan.add(pass("no sum", "sum", render::Load::clear, 0));
    plan.add(pass("no mean", "mean", render::Load::clear, 0));
    for (int i = 0; i < samples; ++i) {
        render::Pass add = pass("add " + std::to_string(i), "sum", render::Load::keep, 0);
        add.draws = {render::Draw{}};
        add.state.blend = render::Blend::add;
        plan.add(std::move(add));
        render::Pass average = pass("average " + std::to_string(i), "mean", render::Load::keep, 0);
        average.draws = {render::Draw{}};
        average.state.blend = render::Blend::mean;
        average.state.meanWeight = 1.0F / static_cast<float>(i + 1);
        plan.add(std::move(average));
    }
    (void)backend.draw(plan);
    StabilityResult result{"H115", "Mean of 4096 samples of one",
                           false,  std::abs(1.0 - static_cast<double>(backend.read("mean").at(0, 0, 0))),
                           1e-6,   {}};
    result.passed = result.value <= result.limit;
    result.detail = "a sum in half precision ends at " +
                    std::to_string(static_cast<int>(backend.read("sum").at(0, 0, 0))) + " here";
    return result;
}

}  // namespace

std::vector<StabilityResult> pictureCases(const Museum& museum, render::RenderBackend& backend,
                                          const StabilityProgress& progress)
{
    std::vector<StabilityResult> results;
    const auto add = [&](const PictureCase& c, const auto& differenceOf) {
        const auto before = static_cast<double>(results.size());
        StabilityProgress part;
        if (progress) part = [&progress, before](double done) { return progress((before + done) / 4); };
        results.push_back(overExhibits(museum, c, part, differenceOf));
    };
    add({"", "The same picture twice", 0}, [&](std::size_t i) {
        const Still s = still(museum, i);
        return difference(picture(museum, backend, s), picture(museum, backend, s));
    });
    // Rays are bitwise equal. Rasterized surfaces are interpolated from other corners, within half a level.
    add({"", "The same picture in tiles", 0.5 / 255}, [&](std::size_t i) {
        Still s = still(museum, i);
        const render::Image whole = picture(museum, backend, s);
        s.request.largestTile = 16;
        return difference(whole, picture(museum, backend, s));
    });
    add({"", "The same picture with every pass run", 0}, [&](std::size_t i) {
        Still s = still(museum, i);
        const render::Image called = picture(museum, backend, s);
        s.request.frame.runEverything = true;
        return difference(called, picture(museum, backend, s));
    });
    add({"H108", "The same picture whatever was in memory", 0}, [&](std::size_t i) {
        const Still s = still(museum, i);
        const render::Image one = over(spreadingPoison(), museum, backend, s);
        return difference(one, over({glm::vec4(3e4F, -3e4F, 7, 0.5F), 0.25F}, museum, backend, s));
    });
    results.push_back(meanOfThousands(backend));
    return results;
}

StabilityResult scanExhibit(const Museum& museum, render::RenderBackend& backend, std::size_t exhibit,
                            std::uint64_t first, int count, const StabilityProgress& progress)
{
    StabilityResult result{"", {}, true, 0, 0, {}};
    int drawn = 0;
    while (drawn < count && result.value < 3 && (!progress || progress(static_cast<double>(drawn) / count))) {
        const std::uint64_t seed = first + static_cast<std::uint64_t>(drawn);
        const ScanCase c = scanCase(museum, exhibit, seed);
        const std::string fault = faultOf(museum, backend, c);
        ++drawn;
        if (!fault.empty()) {
            result.passed = false;
            result.value += 1;
        }
        if (!fault.empty() && result.detail.empty()) {
            result.detail = "seed " + std::to_string(seed) + ": " + fault + ", because of";
            for (const std::string& cause : causesOf(museum, backend, c)) result.detail += " [" + cause + ']';
        }
    }
    result.tried = drawn > 0;
    result.what = std::string(museum.subject(exhibit).name()) + ": NaN, infinity or unwritten texels in " +
                  std::to_string(drawn) + (drawn == 1 ? " picture" : " pictures");
    return result;
}

}  // namespace vitrine::stability
