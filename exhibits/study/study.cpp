#include "exhibits/study/study.h"

#include "exhibits/study/study_choice.h"
#include "exhibits/study/study_picture.h"
#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vitrine {
namespace {

constexpr int mostDoublings = 3;
constexpr int heldOutRuns = 3;

/// `count` of `all`, the first and the last among them.
std::vector<std::size_t> spread(std::size_t all, std::size_t count)
{
    std::vector<std::size_t> chosen;
    count = std::clamp<std::size_t>(count, 1, all);
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
    return chosen;
}

}  // namespace

Study::Study(const Museum& museum, render::RenderBackend& backend, StudyRequest request, StudyParts* parts)
    : museum_(museum), backend_(backend), parts_(parts), request_(std::move(request)),
      judge_(museum.subjects(), request_),
      search_(
          museum.subjects(), request_, result_, [this](const Setting& setting) { addSetting(setting); },
          [this] { judge(); })
{
    if (request_.axes.empty())
        throw Failure(Blame::usage,
                      "A study needs a parameter that is marked as quality; `vitrine list --json` names them.");
    if (request_.metric == render::Metric::psnr)
        throw Failure(Blame::usage,
                      "A study goes by an error that falls to 0: study rmse, of which psnr is the decibels.");
    if (parts_ && parts_->isPart() && request_.axes.size() > 2)
        throw Failure(Blame::usage,
                      "A study over three parameters or more searches: which settings it measures depends on those "
                      "before, so it cannot be split; study one or two parameters.");
    request_.runs = std::max(request_.runs, 1);
    if (request_.subject == hallIndex) request_.alone = false;
    situation_ = studySituation(museum_.subjects(), request_);
    result_.changes = situation_.changes;
    result_.exactInReference = situation_.exact;
    addViews();
    for (const StudyAxis& axis : request_.axes)
        result_.exact.push_back(exactness(rowOf(request_.sceneState, axis)).exact);
    findDependentPasses();
    for (std::size_t view = 0; view < views_.size(); ++view) addReference(view, true);
    if (request_.axes.size() > 2) {
        search_.advance();
        return;
    }
    std::vector<Setting> grid(1);
    for (const StudyAxis& axis : request_.axes) {
        std::vector<Setting> longer;
        for (const Setting& start : grid)
            for (std::size_t i = 0; i < axis.values.size(); ++i) {
                longer.push_back(start);
                longer.back().push_back(i);
            }
        grid = std::move(longer);
    }
    for (const Setting& setting : grid) addSetting(setting);
}

Study::~Study() = default;

void Study::addViews()
{
    const std::vector<StudyView>& all = situation_.views;
    for (const std::size_t i : spread(all.size(), static_cast<std::size_t>(std::max(request_.views, 1))))
        views_.push_back({all[i], {}, {}, {}, false});
    for (const View& view : views_) result_.views.push_back(view.view.name);
    result_.references.resize(views_.size());
    if (!request_.maxError && !request_.maxMilliseconds) return;
    const std::vector<View> used = views_;
    for (const StudyView& view : all)
        if (std::none_of(used.begin(), used.end(), [&](const View& v) { return v.view.name == view.name; }))
            views_.push_back({view, {}, {}, {}, true});
    if (views_.size() > used.size()) return;
    for (View turned : used) {
        // An exhibit that names no more views is looked at from aside, and a little later.
        const double angle = 0.44;
        const glm::dvec3 arm = turned.view.camera.eye - turned.view.camera.target;
        turned.view.camera.eye =
            turned.view.camera.target + glm::dvec3(std::cos(angle) * arm.x + std::sin(angle) * arm.z, arm.y,
                                                   std::cos(angle) * arm.z - std::sin(angle) * arm.x);
        turned.view.time += 0.37;
        turned.view.name += ", from aside";
        turned.heldOut = true;
        views_.push_back(std::move(turned));
    }
}

SceneState Study::lookAt(const std::vector<double>& axisValues, std::size_t view) const
{
    SceneState sceneState = situation_.sceneState;
    sceneState.values[request_.subject] = views_[view].view.values;
    for (std::size_t i = 0; i < request_.axes.size(); ++i)
        sceneState.values[request_.axes[i].subject].setRow(request_.axes[i].row, axisValues[i]);
    sceneState.camera = views_[view].view.camera;
    if (!request_.alone && request_.subject != hallIndex)
        sceneState.camera = sceneState.camera.transformed(museum_.worldFromExhibit(request_.subject));
    return sceneState;
}

SceneState Study::referenceLook(std::size_t view) const
{
    SceneState sceneState = lookAt(result_.exact, view);
    for (const StudyRow& row : situation_.exact) {
        ParameterValues& values = sceneState.values[row.subject];
        values.setRow(row.row, *values.rows()[row.row].qualityReference);
    }
    return sceneState;
}

SceneState Study::sceneStateOf(const StudyPoint& point) const
{
    SceneState sceneState = request_.sceneState;
    const std::vector<double> values = valuesOf(point.setting);
    for (std::size_t i = 0; i < request_.axes.size(); ++i)
        sceneState.values[request_.axes[i].subject].setRow(request_.axes[i].row, values[i]);
    return sceneState;
}

std::vector<double> Study::valuesOf(const Setting& setting) const
{
    std::vector<double> values;
    for (std::size_t i = 0; i < setting.size(); ++i) values.push_back(request_.axes[i].values[setting[i]]);
    return values;
}

void Study::renewErrors()
{
    for (StudyPoint& point : result_.points)
        for (std::size_t view = 0; view < point.shots.size(); ++view)
            if (!point.shots[view].picture.empty())
                point.shots[view].errors = judge_.errorsOf(views_[view].reference, point.shots[view].picture);
}

bool Study::refineReference()
{
    renewErrors();
    judge();
    const bool tellsAll = std::none_of(result_.points.begin(), result_.points.end(),
                                       [](const StudyPoint& point) { return point.uncertain; });
    if (tellsAll || doublings_ >= mostDoublings) return false;
    std::vector<double> doubled;
    for (const StudyAxis& axis : request_.axes)
        doubled.push_back(exactness(rowOf(request_.sceneState, axis), doublings_ + 1).exact);
    if (doubled == result_.exact) return false;
    ++doublings_;
    result_.exact = doubled;
    for (std::size_t view = 0; view < result_.views.size(); ++view) {
        views_[view].neighbors = {views_[view].reference};
        addReference(view, false);
    }
    return true;
}

double Study::uncertainty() const
{
    std::vector<double> uncertainties;
    for (std::size_t view = 0; view < result_.views.size(); ++view) {
        const View& v = views_[view];
        if (v.reference.empty()) continue;
        for (std::size_t i = 0; i < v.neighbors.size(); ++i) {
            const double change = judge_.errorsOf(v.reference, v.neighbors[i])[request_.metric];
            if (i == 0)
                uncertainties.push_back(change);
            else
                uncertainties.back() = std::max(uncertainties.back(), change);
        }
    }
    return judge_.pooled(uncertainties);
}

void Study::judge()
{
    result_.uncertainty = uncertainty();
    judge_.judge(result_, doublings_);
}

void Study::tryCandidate()
{
    const std::size_t point = candidates_.back();
    candidates_.pop_back();
    result_.choice = StudyChoice{.point = point, .holds = true};
    for (std::size_t view = result_.views.size(); view < views_.size(); ++view) {
        result_.choice->heldOutViews.push_back(views_[view].view.name);
        const SceneState sceneState = lookAt(valuesOf(result_.points[point].setting), view);
        addPicture({"held_out_" + std::to_string(point) + "_" + std::to_string(view),
                    "held-out view " + views_[view].view.name, sceneState, pictureRequest(sceneState, view)},
                   [this, view, sceneState](const StudyMeasure& measure) {
                       StudyChoice& choice = *result_.choice;
                       const double error = judge_.errorsOf(views_[view].reference, measure.picture)[request_.metric];
                       choice.heldOutError = std::max(choice.heldOutError, error);
                       if (request_.maxError) choice.holds = choice.holds && error <= *request_.maxError;
                       if (!request_.maxMilliseconds) return;
                       std::vector<double> times;
                       for (int run = 0; run < heldOutRuns; ++run)
                           times.push_back(drawTimed(sceneState, view).milliseconds *
                                           pictureRequest(sceneState, view).samples);
                       const double median = render::quantile(times, 0.5);
                       choice.heldOutMilliseconds = std::max(choice.heldOutMilliseconds, median);
                       choice.holds = choice.holds && median <= *request_.maxMilliseconds;
                   });
    }
}

void Study::addExactReferences()
{
    if (!request_.modelError) return;
    for (std::size_t view = 0; view < result_.views.size(); ++view) {
        SceneState sceneState = lookAt(result_.exact, view);
        sceneState.values[request_.subject] = atReference(sceneState.values[request_.subject]);
        for (std::size_t i = 0; i < request_.axes.size(); ++i)
            sceneState.values[request_.axes[i].subject].setRow(request_.axes[i].row, result_.exact[i]);
        addPicture({"exact_" + std::to_string(view) + "_" + std::to_string(doublings_),
                    "everything exact, " + views_[view].view.name, sceneState, referenceRequest(sceneState, view)},
                   [this, view](StudyMeasure measure) {
                       views_[view].exact = std::move(measure.picture);
                       for (StudyPoint& point : result_.points)
                           point.shots[view].modelError =
                               judge_.errorsOf(views_[view].exact, point.shots[view].picture)[request_.metric];
                   });
    }
}

void Study::nextPhase()
{
    switch (phase_) {
    case Phase::pictures:
        if (parts_ && parts_->isPart()) {
            phase_ = Phase::exactReferences;
            return addExactReferences();
        }
        if (request_.axes.size() > 2 ? search_.advance() : refineReference()) return;
        judge();
        phase_ = Phase::exactReferences;
        return addExactReferences();
    case Phase::exactReferences:
        phase_ = Phase::times;
        addTimes();
        return;
    case Phase::times:
        phase_ = Phase::done;
        if (parts_ && parts_->isPart()) return;
        judge();
        if (!request_.maxError && !request_.maxMilliseconds) return;
        candidates_ = choiceCandidates(request_, result_);
        if (candidates_.empty()) return;
        phase_ = Phase::choice;
        for (std::size_t view = result_.views.size(); view < views_.size(); ++view) addReference(view, false);
        tryCandidate();
        return;
    case Phase::choice:
        if (result_.choice->holds || candidates_.empty())
            phase_ = Phase::done;
        else
            tryCandidate();
        return;
    case Phase::done: return;
    }
}

void Study::findJob()
{
    while (jobs_.empty() && phase_ != Phase::done) nextPhase();
    result_.complete = phase_ == Phase::done;
    if (result_.complete) keepColors();
}

/// A result is kept and looked at long after the study: what only its errors needed goes.
void Study::keepColors()
{
    for (View& view : views_) view = {std::move(view.view), {}, {}, {}, view.heldOut};
    if (!goesByColor(request_)) return;
    const auto keep = [](render::Image& picture) {
        if (picture.channels > 4) picture = colorsOf(picture);
    };
    for (render::Image& reference : result_.references) keep(reference);
    for (StudyPoint& point : result_.points)
        for (StudyShot& shot : point.shots) keep(shot.picture);
}

bool Study::step()
{
    findJob();
    if (finished()) return false;
    doing_ = jobs_.front().name;
    if (jobs_.front().step()) {
        jobs_.pop_front();
        ++jobsDone_;
    }
    findJob();
    return true;
}

double Study::progress() const
{
    if (finished()) return 1;
    std::size_t ahead = jobs_.size();
    if (phase_ == Phase::pictures)
        ahead += result_.views.size() + result_.points.size() * static_cast<std::size_t>(request_.runs);
    return static_cast<double>(jobsDone_) / static_cast<double>(std::max<std::size_t>(jobsDone_ + ahead, 1));
}

}  // namespace vitrine
