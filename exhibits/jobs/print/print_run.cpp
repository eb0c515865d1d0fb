#include "exhibits/jobs/print/print_run.h"

#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/number_text.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace vitrine::jobs {

using printing::DepthRange;
using printing::PrintLayout;
using printing::printTable;
using printing::ViewOrigin;
using printing::ViewShot;

namespace print_run {
namespace {

template <typename... Args> std::string text(const char* format, Args... args)
{
    std::array<char, 256> line{};
    std::snprintf(line.data(), line.size(), format, args...);
    return line.data();
}

std::string depthText(double meters)
{
    return std::isinf(meters) ? "the horizon" : text("%.2f m", meters);
}

std::string nameOfView(int k)
{
    return text("view_%04d.picture", k);
}

/// Throws Failure if nothing can be written into the folder of the output. Called before the views are rendered, which
/// takes minutes.
void requireFolder(const std::filesystem::path& out)
{
    const std::filesystem::path folder = ::vitrine::render::PartFile(out).target().parent_path();
    if (::access(folder.empty() ? "." : folder.c_str(), W_OK) == 0) return;
    throw Failure(ErrorKind::file,
                  "Cannot write " + out.string() + ": " + std::strerror(errno) + "; choose another folder.");
}

/// Runs `work` with a progress callback. A failure of work that `watch` stopped becomes Stopped.
template <typename Work> auto stoppable(const Watch& watch, double& progress, const Work& work)
{
    bool isStopped = false;
    const printing::Progress show = [&](double part) {
        isStopped = isStopped || !watch(progress = part);
        return !isStopped;
    };
    try {
        return work(show);
    } catch (const Failure&) {
        if (isStopped) throw Stopped();
        throw;
    }
}

}  // namespace
}  // namespace print_run

JobRun::Next PrintRun::next() const
{
    if (stage_ == Stage::done) return Next::done;
    return stage_ == Stage::render ? Next::draw : Next::work;
}

void PrintRun::step(const Watch& watch)
{
    if (stage_ == Stage::begin)
        begin(watch);
    else if (stage_ == Stage::render)
        render();
    else
        write(watch);
}

double PrintRun::progress() const
{
    return maker_ ? maker_->progress() : progress_;
}

std::string_view PrintRun::doing() const
{
    if (stage_ == Stage::render) return "rendering views";
    return stage_ == Stage::begin ? "reading views" : "interlacing";
}

void PrintRun::begin(const Watch& watch)
{
    const ParameterValues& values = order_.values;
    const ViewOrigin origin = values[printTable().origin];
    const bool isRead = origin == ViewOrigin::files || origin == ViewOrigin::quilt;
    const PrintLayout layout(printing::printSettings(values, isRead ? 1 : printing::viewCount(values)));
    if (!order_.out.empty() && !order_.share.makes) {
        print_run::requireFolder(order_.out);
        printing::requireRoom(layout, printing::printFile(values, order_.out, profile()));
    }
    if (isRead)
        views_ = print_run::stoppable(watch, progress_, [&](const printing::Progress& show) {
            return printing::readViews(values, show, printing::ViewUse::print);
        });
    if (origin == ViewOrigin::shown)
        beginScene(layout);
    else
        stage_ = Stage::write;
    progress_ = 0;
}

void PrintRun::beginScene(const PrintLayout& layout)
{
    const ParameterValues& values = order_.values;
    const JobScene& scene = order_.scene;
    ViewShot base{scene.state, {}};
    base.request.frame = scene.frame;
    base.request.frame.raster.size = printing::viewSize(layout, values);
    base.request.largestTile = order_.largestTile;
    const int samples = values[printTable().samples];
    base.request.samples = samples > 0               ? samples
                           : scene.usual.samples > 0 ? scene.usual.samples
                                                     : usualSamples(scene.state.hall());
    printing::SweptScene swept{scene.museum, scene.subject};
    rendered_.emplace(values, layout, std::move(base), swept);
    report_.warnings = std::move(swept.notes);
    const std::string& folder = values[printTable().saveViews];
    if (!folder.empty() && !order_.share.makes)
        folder_ = std::make_unique<ViewFolder>(
            folder, printing::viewFormats().at(static_cast<std::size_t>(values[printTable().viewFormat])),
            layout.settings().views);
    stage_ = Stage::render;
}

void PrintRun::render()
{
    if (!backend_) {
        beginRendering();
        return;
    }
    const int count = static_cast<int>(rendered_->shots().size());
    if (order_.share.kept)
        for (int k = 0; k < count; ++k) take(k, order_.share.kept(print_run::nameOfView(k)));
    if (order_.share.kept || !maker_->step()) endRendering();
}

void PrintRun::beginRendering()
{
    backend_ = order_.backend ? order_.backend() : nullptr;
    if (!backend_) throw Failure(ErrorKind::openGl, "No views can be rendered: there is no graphics context.");
    const Museum& museum = *order_.scene.museum;
    const DepthRange depth = printing::measuredDepth(museum, *backend_, rendered_->base());
    rendered_->fit(depth);
    describeRig(depth);
    renderedViews_ = std::make_shared<printing::PrintViews>(printing::ViewUse::print);
    std::vector<ViewShot> shots;
    std::vector<int> numbers;
    for (int k = 0; k < static_cast<int>(rendered_->shots().size()); ++k) {
        if (order_.share.makes && !order_.share.makes(k)) continue;
        shots.push_back(rendered_->shots()[static_cast<std::size_t>(k)]);
        numbers.push_back(k);
    }
    maker_ = std::make_unique<printing::ViewMaker>(museum, *backend_, std::move(shots),
                                                   [this, numbers](int i, const ::vitrine::render::Image& image) {
                                                       const int k = numbers[static_cast<std::size_t>(i)];
                                                       if (order_.share.makes)
                                                           order_.share.keep(print_run::nameOfView(k), image);
                                                       else
                                                           take(k, image);
                                                   });
}

void PrintRun::take(int view, const ::vitrine::render::Image& image)
{
    const Museum& museum = *order_.scene.museum;
    const std::size_t subject = order_.scene.subject;
    const ViewShot& shot = rendered_->shots()[static_cast<std::size_t>(view)];
    renderedViews_->add(image, 0, std::string(museum.subject(subject).name()) + ", view " + std::to_string(view));
    if (folder_) folder_->add(view, image, pictureSettings(museum, subject, shot.sceneState, shot.request, "View"));
}

void PrintRun::endRendering()
{
    const printing::ViewRig& rig = rendered_->rig();
    const ViewShot& base = rendered_->base();
    const ParameterValues& values = order_.values;
    renderedViews_->setScenePreset(
        pictureSettings(*order_.scene.museum, order_.scene.subject, base.sceneState, base.request, "View"));
    renderedViews_->setRig({{"baseline", rig.baseline()},
                            {"baselineScale", rig.strength()},
                            {"convergence", rig.convergence()},
                            {"turnDegrees", values[printTable().turn] / printing::radiansPerDegree},
                            {"sweeps", linesOf(values[printTable().sweeps])},
                            {"samples", base.request.samples}});
    views_ = std::move(renderedViews_);
    maker_.reset();
    backend_.reset();
    stage_ = order_.share.makes ? Stage::done : Stage::write;
}

void PrintRun::describeRig(const DepthRange& depth)
{
    using print_run::depthText;
    const printing::ViewRig& rig = rendered_->rig();
    const DepthRange budget = rig.budget();
    report_.facts.push_back({"Rig", rig.baseline() == 0
                                        ? std::string("all views from one camera")
                                        : print_run::text("%d cameras over %.3f m (%.3g of true depth), converging "
                                                          "at %.2f m, the perspective of an eye at %.0f mm",
                                                          rig.count(), rig.baseline(), rig.strength(),
                                                          rig.convergence(), rig.convergence() / rig.scale())});
    if (rig.baseline() > 0)
        report_.facts.push_back({"Scene", "from " + depthText(depth.nearest) + " to " + depthText(depth.farthest) +
                                              "; the print holds " + depthText(budget.nearest) + " to " +
                                              depthText(budget.farthest) + " without doubled contours"});
    for (const std::string& warning : printing::warningsOf(rig, depth)) report_.warnings.push_back(warning);
    if (order_.values[printTable().reverse] && rig.baseline() > 0)
        report_.warnings.emplace_back("With --reverse the depth of rendered views is inside out.");
}

void PrintRun::write(const Watch& watch)
{
    const ParameterValues& values = order_.values;
    std::optional<printing::CrossTalk> compensated;
    if (!order_.out.empty()) {
        printing::PrintFile file = printing::printFile(values, order_.out, profile());
        file.report = order_.reportFile;
        file.json = printing::printText(values, views_.get(), order_.out, &compensated);
        staged_ = print_run::stoppable(watch, progress_, [&](const printing::Progress& show) {
            file.progress = show;
            return printing::stagedPrint(values, views_.get(), file);
        });
    } else if (!order_.reportFile.empty()) {
        staged_.parts.push_back(
            ::vitrine::render::stagedFile(order_.reportFile, printing::printText(values, views_.get(), order_.out)));
    }
    tell(compensated);
    stage_ = Stage::done;
}

void PrintRun::tell(const std::optional<printing::CrossTalk>& compensated)
{
    std::vector<Fact> ofRig = std::move(report_.facts);
    report_.facts.clear();
    if (order_.out.empty()) {
        for (const std::string& note : views_->notes()) report_.warnings.push_back(note);
    } else {
        const printing::PrintPlan plan = printing::printPlan(order_.values, views_.get(), order_.out, profile());
        for (const std::string& warning : plan.warnings) report_.warnings.push_back(warning);
        report_.facts = printFacts(plan, views_ != nullptr);
    }
    if (compensated)
        report_.facts.push_back(
            {"Compensation",
             print_run::text("cross-talk %.4f before, %.4f after (root mean square, simulated); %.1f %% "
                             "beyond black or white",
                             compensated->before, compensated->after, 100 * compensated->clipped)});
    report_.facts.insert(report_.facts.end(), ofRig.begin(), ofRig.end());
    if (folder_) report_.facts.push_back({"Saved views", static_cast<double>(views_->count())});
    for (const std::filesystem::path& picture : staged_.pictures)
        report_.files.insert(report_.files.end(), {picture, picture.string() + ".json"});
    if (!order_.reportFile.empty()) report_.files.push_back(order_.reportFile);
    if (folder_) report_.files.emplace_back(order_.values[printTable().saveViews]);
}

void PrintRun::publish()
{
    staged_.publish();
    if (folder_) folder_->publish();
}

std::vector<Fact> printFacts(const printing::PrintPlan& plan, bool ofViews)
{
    const printing::PrintNumbers& numbers = plan.numbers;
    std::vector<Fact> facts{
        {"Raster", std::to_string(plan.layout->width()) + " × " + std::to_string(plan.layout->height()), "px"},
        {"Pixels per lens", numbers.pixelsPerLens},
        {"Lenses per inch as stored", print_run::text("%.6f", numbers.effectiveLpi)}};
    if (!ofViews) return facts;
    const auto [least, most] = std::minmax_element(numbers.ownShare.begin(), numbers.ownShare.end());
    facts.insert(facts.end(),
                 {{"Zone", numbers.zoneDegrees, "°"},
                  {"Depth", numbers.depthBudget, "mm"},
                  {"Cross-talk", print_run::text("%.0f to %.0f", 100 * (1 - *most), 100 * (1 - *least)), "%"},
                  {"Distinguishable views", std::round(numbers.effectiveViews)}});
    return facts;
}

}  // namespace vitrine::jobs
