#include "app/print/rendered_views.h"

#include "app/kit/number_option.h"
#include "app/kit/progress.h"
#include "app/queue/parts.h"
#include "exhibits/exhibits.h"
#include "exhibits/museum/picture_settings.h"
#include "exhibits/printing/print_table.h"
#include "exhibits/printing/sheet.h"
#include "exhibits/printing/view_maker.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/gl/context.h"
#include "render/gl/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

namespace vitrine::app {
namespace {

using printing::DepthRange;
using printing::PrintLayout;
using printing::ViewRig;
using printing::ViewShot;

constexpr int longestSide = 1200;  ///< Default of the longer side of a view, in pixels.
constexpr int mostSide = 8192;     ///< A print of a meter at 40 LPI has 1600 lenses.
constexpr int mostOfItself = 24;   ///< Most views by default: more cost time and show little.

template <typename... Args> std::string text(const char* format, Args... args)
{
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(), format, args...);
    return line.data();
}

int countFor(const ViewOptions& options)
{
    if (options.count != 0) return options.count;
    return std::clamp(static_cast<int>(layoutOf(options, 1).pixelsPerLens()), 2, mostOfItself);
}

/// Returns the size of a view: the print's aspect ratio, with no higher resolution than the print has.
std::string sizeFor(const PrintLayout& layout)
{
    const printing::PrintSettings& s = layout.settings();
    const glm::dvec2 print(s.width + 2 * s.bleed, s.height + 2 * s.bleed);
    const double pixels = std::min<double>(longestSide, static_cast<double>(std::max(layout.width(), layout.height())));
    const glm::dvec2 size = glm::max(glm::round(print * (pixels / std::max(print.x, print.y))), glm::dvec2(1));
    return text("%.0fx%.0f", size.x, size.y);
}

/// Returns the value of --baseline-scale; nothing for "fit".
std::optional<double> strengthOf(const ViewOptions& options)
{
    if (options.baselineScale.empty()) return options.turnDegrees == 0 && options.sweeps.empty() ? 1 : 0;
    if (options.baselineScale == "fit") return std::nullopt;
    return readNumber("--baseline-scale", options.baselineScale,
                      rangeOf(printing::printTable(), printing::printTable().baselineScale));
}

/// Splits "morph=0..1" into "morph=0" and "morph=1".
std::array<std::string, 2> endsOf(const std::string& sweep)
{
    const std::size_t equals = sweep.find('=');
    const std::size_t dots = equals == std::string::npos ? equals : sweep.find("..", equals);
    if (dots == std::string::npos || equals == 0 || dots == equals + 1 || dots + 2 == sweep.size())
        throw Failure(ErrorKind::usage, "--sweep \"" + sweep + "\": give name=from..to, such as --sweep morph=0..1.");
    const std::string name = sweep.substr(0, equals + 1);
    return {sweep.substr(0, dots), name + sweep.substr(dots + 2)};
}

void applySweeps(const Museum& museum, const ViewOptions& options, const RequestedPicture& job,
                 std::vector<ViewShot>& shots, std::vector<std::string>& notes)
{
    for (const std::string& typed : options.sweeps) {
        const std::array<std::string, 2> ends = endsOf(typed);
        if (typed.rfind("time=", 0) == 0) {
            const double from = readNumber("--sweep time", ends[0].substr(5), {.unit = Unit::second});
            const double to = readNumber("--sweep time", ends[1].substr(5), {.unit = Unit::second});
            for (std::size_t k = 0; k < shots.size(); ++k)
                shots[k].request.frame.time =
                    from + (to - from) * static_cast<double>(k) /
                               static_cast<double>(std::max<std::size_t>(shots.size() - 1, 1));
            continue;
        }
        SceneState from = job.sceneState;
        SceneState to = job.sceneState;
        applySet(museum, from, job.subject, ends[0], notes);
        applySet(museum, to, job.subject, ends[1], notes);
        printing::sweep(shots, from, to);
    }
}

std::string depthText(double meters)
{
    return std::isinf(meters) ? "the horizon" : text("%.2f m", meters);
}

/// Throws Failure for everything that can be refused before rendering.
void checkOptions(const ViewOptions& options)
{
    if (options.every != 1 || options.pingPong)
        throw Failure(ErrorKind::usage,
                      "--every and --ping-pong apply to pictures; leave them out, and give the number of "
                      "an exhibit's views with --count.");
}

/// Returns the options of the picture that all views have in common, with the size of a view.
PictureOptions sceneOptions(const ViewOptions& options, const PrintLayout& layout)
{
    PictureOptions scene = options.scene;
    scene.size = options.viewSize.empty() ? sizeFor(layout) : options.viewSize;
    const glm::ivec2 size = parseSize("--view-size", scene.size);
    if (size.x > mostSide || size.y > mostSide)
        throw Failure(ErrorKind::usage, "--view-size " + scene.size + ": a view has at most " +
                                            std::to_string(mostSide) + " pixels on a side.");
    return scene;
}

/// Replaces the shots' cameras by those of another rig; turns and sweeps stay.
void takeCameras(std::vector<ViewShot>& shots, const ViewRig& rig)
{
    for (std::size_t k = 0; k < shots.size(); ++k)
        shots[k].sceneState.camera = shots[k].request.frame.camera = rig.camera(static_cast<int>(k));
}

/// Prints the rig, and the depth range that the print can show.
void describe(const ViewRig& rig, const DepthRange& depth, bool reverse, GatheredViews& result)
{
    const DepthRange budget = rig.budget();
    result.numbers.push_back(rig.baseline() == 0 ? std::string("all views from one camera")
                                                 : text("%d cameras over %.3f m (%.3g of true depth), converging at "
                                                        "%.2f m, the perspective of an eye at %.0f mm",
                                                        rig.count(), rig.baseline(), rig.strength(), rig.convergence(),
                                                        rig.convergence() / rig.scale()));
    if (rig.baseline() > 0) {
        result.numbers.push_back(
            text("the scene reaches from %s to %s, and the print holds %s to %s without doubled contours",
                 depthText(depth.nearest).c_str(), depthText(depth.farthest).c_str(), depthText(budget.nearest).c_str(),
                 depthText(budget.farthest).c_str()));
    }
    for (const std::string& warning : printing::warningsOf(rig, depth)) result.notes.push_back(warning);
    if (reverse && rig.baseline() > 0)
        result.notes.emplace_back("With --reverse the depth of rendered views is inside out.");
}

/// Returns the numbers of the rig as JSON.
render::Json rigJson(const ViewOptions& options, const RequestedPicture& picture, const ViewRig& rig)
{
    return {{"baseline", rig.baseline()},       {"baselineScale", rig.strength()},
            {"convergence", rig.convergence()}, {"turnDegrees", options.turnDegrees},
            {"sweeps", options.sweeps},         {"samples", picture.request.samples}};
}

std::string nameOfView(int k)
{
    return text("view_%04d.picture", k);
}

render::Image viewMade(const Parts& parts, int k)
{
    if (auto image = parts.kept(nameOfView(k))) return std::move(*image);
    throw Failure(ErrorKind::check, parts.file(nameOfView(k)).string() + " is missing; make all parts anew.");
}

/// Renders all views; or renders the views of one part into its folder; or reads the views that were rendered in parts.
void takeViews(const Museum& museum, render::RenderBackend& renderer, const std::vector<ViewShot>& shots,
               const ViewOptions& options, const printing::ViewMaker::Take& take)
{
    const int count = static_cast<int>(shots.size());
    for (int k = 0; options.made && k < count; ++k) take(k, viewMade(*options.made, k));
    if (options.made) return;
    std::vector<int> chosen;
    std::vector<ViewShot> rendered;
    for (int k = 0; k < count; ++k) {
        if (options.makes && !options.makes->shard().makes(static_cast<std::size_t>(k))) continue;
        chosen.push_back(k);
        rendered.push_back(shots[static_cast<std::size_t>(k)]);
    }
    ProgressLine line("rendering views");
    printing::ViewMaker maker(museum, renderer, rendered, [&](int i, const render::Image& image) {
        const int k = chosen[static_cast<std::size_t>(i)];
        if (options.makes)
            options.makes->keep(nameOfView(k), image);
        else
            take(k, image);
    });
    while (maker.step())
        if (!line.show(maker.progress()))
            throw Failure(ErrorKind::usage, "Rendering the views was stopped; nothing was written.");
}

}  // namespace

GatheredViews renderedViews(const ViewOptions& options)
{
    const std::optional<double> strength = strengthOf(options);
    checkOptions(options);
    const int count = countFor(options);
    const PrintLayout layout = layoutOf(options, count);
    const PictureOptions scene = sceneOptions(options, layout);
    const render::gl::HeadlessContext context;
    const Museum museum{allExhibits()};
    const RequestedPicture picture = requestedPicture(museum, scene);
    const ViewShot base{picture.sceneState, picture.request};
    const auto rigOf = [&](double s) {
        return ViewRig(layout, picture.sceneState.camera, picture.request.frame.raster.size,
                       {s, options.values[printing::printTable().convergence]});
    };
    ViewRig rig = rigOf(strength.value_or(1));
    std::vector<ViewShot> shots = shotsOf(rig, base);
    GatheredViews result;
    result.notes = picture.notes;
    if (options.turnDegrees != 0) printing::turn(shots, options.turnDegrees * printing::radiansPerDegree);
    applySweeps(museum, options, picture, shots, result.notes);
    if (!options.saveViews.empty() && !options.makes)
        result.folder = std::make_unique<ViewFolder>(options.saveViews, options.viewFormat, count);

    render::gl::Renderer renderer;
    const DepthRange depth = printing::measuredDepth(museum, renderer, base);
    if (!strength) {
        rig = rigOf(std::min(1.0, rig.strengthThatHolds(depth)));
        takeCameras(shots, rig);
    }
    describe(rig, depth, layout.settings().reverse, result);
    for (int k = 0; k < count; ++k) result.sources.names.push_back(scene.subject + ", view " + std::to_string(k));
    result.sources.scene =
        render::Json::parse(pictureSettings(museum, picture.subject, base.sceneState, base.request, "View"));
    result.sources.rig = rigJson(options, picture, rig);
    const auto take = [&](int k, const render::Image& image) {
        result.views.add(image);
        if (result.folder)
            result.folder->add(k, image,
                               pictureSettings(museum, picture.subject, shots[static_cast<std::size_t>(k)].sceneState,
                                               shots[static_cast<std::size_t>(k)].request, "View"));
    };
    takeViews(museum, renderer, shots, options, take);
    result.renderer = context.info().renderer;
    return result;
}

}  // namespace vitrine::app
