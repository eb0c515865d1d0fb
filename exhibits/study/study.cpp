#include "exhibits/study/study.h"

#include "exhibits/study/point_time.h"
#include "exhibits/study/study_choice.h"
#include "exhibits/study/study_picture.h"
#include "render/failure.h"
#include "render/measure/distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vitrine::study {
namespace {

constexpr int mostDoublings = 3;
constexpr int heldOutRuns = 3;

/// Returns `count` of `all` indices, evenly spaced, including the first and the last.
std::vector<std::size_t> spread(std::size_t all, std::size_t count)
{
    std::vector<std::size_t> chosen;
    count = std::clamp<std::size_t>(count, 1, all);
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
    return chosen;
}

}  // namespace

Study::Study(const Museum& museum, render::RenderBackend& backend, StudyRequest request, StudyParts* parts)
    : museum_(museum), backend_(backend), queue_(parts), request_(std::move(request)),
      judge_(museum.subjects(), request_),
      search_(
          museum.subjects(), request_, result_, [this](const Setting& setting) { addSetting(setting); },
          [this] { judge(); })
{
    if (request_.axes.empty())
        throw Failure(ErrorKind::usage,
                      "A study needs a parameter that is marked as quality; `vitrine list --json` names them.");
    if (render::metricInfo(request_.metric).falls)
        throw Failure(ErrorKind::usage,
                      "A study needs a measure that falls to 0, and psnr rises without end; give rmse, "
                      "the same error not in decibels.");
    if (queue_.isPart() && request_.axes.size() > 2)
        throw Failure(ErrorKind::usage,
                      "A study over three parameters or more searches: which settings it measures depends on those "
                      "before, so it cannot be split; study one or two parameters.");
    request_.runs = std::max(request_.runs, 1);
    if (request_.subject == hallIndex) request_.alone = false;
    situation_ = studySituation(museum_.subjects(), request_);
    result_.changes = situation_.changes;
    result_.exactInReference = situation_.exact;
    addViews();
    for (const StudyAxis& axis : request_.axes)
        result_.exact.push_back(exactness(parameterOf(request_.sceneState, axis)).exact);
    findDependentPasses();
    const bool searches = request_.axes.size() > 2;
    std::vector<Setting> grid(searches ? 0 : 1);
    for (const StudyAxis& axis : request_.axes) {
        std::vector<Setting> longer;
        for (const Setting& start : grid)
            for (std::size_t i = 0; i < axis.values.size(); ++i) {
                longer.push_back(start);
                longer.back().push_back(i);
            }
        grid = std::move(longer);
    }
    for (const Setting& setting : grid) addPoint(setting);
    for (std::size_t view = 0; view < views_.size(); ++view) addReference(view, true);
    if (searches) search_.advance();
    for (const Setting& setting : grid)
        for (std::size_t view = 0; view < result_.views.size(); ++view)
            if (views_[view].setting != setting) addShot(setting, view);
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
        // If an exhibit has no more views, a view from the side and a little later is held out.
        const double angle = 0.44;
        const glm::dvec3 arm = turned.view.camera.eye - turned.view.camera.target;
        turned.view.camera.eye =
            turned.view.camera.target + glm::dvec3(std::cos(angle) * arm.x + std::sin(angle) * arm.z, arm.y,
                                                   std::cos(angle) * arm.z - std::sin(angle) * arm.x);
        turned.view.time += 0.37;
        turned.view.name += ", from the side";
        turned.heldOut = true;
        views_.push_back(std::move(turned));
    }
}

SceneState Study::lookAt(const std::vector<double>& axisValues, std::size_t view) const
{
    SceneState sceneState = situation_.sceneState;
    sceneState.values[request_.subject] = views_[view].view.values;
    for (std::size_t i = 0; i < request_.axes.size(); ++i)
        sceneState.values[request_.axes[i].subject].setParameter(request_.axes[i].row, axisValues[i]);
    sceneState.camera = views_[view].view.camera;
    if (!request_.alone && request_.subject != hallIndex)
        sceneState.camera = sceneState.camera.transformed(museum_.worldFromExhibit(request_.subject));
    return sceneState;
}

SceneState Study::referenceLook(const std::vector<double>& axisValues, std::size_t view) const
{
    SceneState sceneState = lookAt(axisValues, view);
    for (const StudyParameter& row : situation_.exact) {
        ParameterValues& values = sceneState.values[row.subject];
        values.setParameter(row.row, *values.rows()[row.row].qualityReference);
    }
    return sceneState;
}

SceneState Study::sceneStateOf(const StudyPoint& point) const
{
    SceneState sceneState = request_.sceneState;
    const std::vector<double> values = valuesOf(point.setting);
    for (std::size_t i = 0; i < request_.axes.size(); ++i)
        sceneState.values[request_.axes[i].subject].setParameter(request_.axes[i].row, values[i]);
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
    if (doublings_ > 0) renewErrors();  // Before, every error was measured with the present reference.
    judge();
    const bool tellsAll = std::none_of(result_.points.begin(), result_.points.end(),
                                       [](const StudyPoint& point) { return point.uncertain; });
    if (tellsAll || doublings_ >= mostDoublings) return false;
    std::vector<double> doubled;
    for (const StudyAxis& axis : request_.axes)
        doubled.push_back(exactness(parameterOf(request_.sceneState, axis), doublings_ + 1).exact);
    if (doubled == result_.exact) return false;
    ++doublings_;
    result_.exact = doubled;
    for (std::size_t view = 0; view < result_.views.size(); ++view) {
        views_[view].neighbors = {views_[view].reference};
        views_[view].changes.clear();
        addReference(view, false);
    }
    return true;
}

double Study::uncertainty()
{
    std::vector<double> uncertainties;
    for (std::size_t view = 0; view < result_.views.size(); ++view) {
        View& v = views_[view];
        if (v.reference.empty() || v.neighbors.empty()) continue;
        while (v.changes.size() < v.neighbors.size())
            v.changes.push_back(judge_.errorOf(v.reference, v.neighbors[v.changes.size()]));
        uncertainties.push_back(*std::max_element(v.changes.begin(), v.changes.end()));
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
                       const double error = judge_.errorOf(views_[view].reference, measure.picture);
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
            sceneState.values[request_.axes[i].subject].setParameter(request_.axes[i].row, result_.exact[i]);
        addPicture({"exact_" + std::to_string(view) + "_" + std::to_string(doublings_),
                    "everything exact, " + views_[view].view.name, sceneState, referenceRequest(sceneState, view)},
                   [this, view](StudyMeasure measure) {
                       views_[view].exact = std::move(measure.picture);
                       for (StudyPoint& point : result_.points)
                           point.shots[view].modelError = judge_.errorOf(views_[view].exact, point.shots[view].picture);
                   });
    }
}

void Study::nextPhase()
{
    switch (phase_) {
    case Phase::pictures:
        if (queue_.isPart()) {
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
        if (queue_.isPart()) return;
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
    while (queue_.empty() && phase_ != Phase::done) nextPhase();
    result_.complete = phase_ == Phase::done;
    if (result_.complete) keepColors();
}

/// Drops data that only the errors needed, since a result is kept and displayed long after the study.
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
    queue_.step();
    findJob();
    return true;
}

double Study::progress() const
{
    if (finished()) return 1;
    std::size_t ahead = queue_.waiting();
    if (phase_ == Phase::pictures)
        ahead += result_.views.size() + result_.points.size() * static_cast<std::size_t>(request_.runs);
    return static_cast<double>(queue_.done()) / static_cast<double>(std::max<std::size_t>(queue_.done() + ahead, 1));
}

namespace {

void noteClock(const render::FrameReport& report, StudyMeasure& measure)
{
    measure.clock = report.clock;
    measure.clockTrusted = report.clockTrusted;
    measure.overheadMilliseconds = report.overheadMilliseconds;
}

}  // namespace

void Study::findDependentPasses()
{
    using Keys = std::map<std::string, std::uint64_t>;
    const auto keysAt = [&](const std::vector<double>& values) {
        const SceneState sceneState = lookAt(values, 0);
        Keys keys;
        const FrameRequest frame = pictureRequest(sceneState, 0).frame;
        const render::FramePlan plan = museum_.plan(museum_.prepare(sceneState, frame), frame);
        for (const render::Pass& pass : plan.passes())
            if (pass.contentHash) keys[pass.name] = *pass.contentHash;
        return keys;
    };
    const Keys exact = keysAt(result_.exact);
    for (std::size_t i = 0; i < request_.axes.size(); ++i) {
        for (const double value : {request_.axes[i].values.front(), request_.axes[i].values.back()}) {
            std::vector<double> values = result_.exact;
            values[i] = value;
            const Keys other = keysAt(values);
            for (const auto& [name, key] : exact)
                if (!other.contains(name) || other.at(name) != key) dependentPasses_.insert(name);
            for (const auto& [name, key] : other)
                if (!exact.contains(name)) dependentPasses_.insert(name);
        }
    }
}

void Study::addMeasure(std::string key, std::string name, StudyQueue::Measuring measure,
                       std::function<void(StudyMeasure)> take)
{
    queue_.add(std::move(key), std::move(name), std::move(measure), [this, take = std::move(take)](StudyMeasure found) {
        if (!found.clock.empty()) {
            result_.clock = found.clock;
            result_.clockTrusted = found.clockTrusted;
            result_.overheadMilliseconds = found.overheadMilliseconds;
        }
        take(std::move(found));
    });
}

void Study::addPicture(PictureJob job, std::function<void(StudyMeasure)> take)
{
    std::string key = job.key;
    std::string name = job.name;
    // The maker is created when the job begins, since it holds the whole picture.
    std::shared_ptr<PictureMaker> none;
    addMeasure(
        std::move(key), std::move(name),
        [this, job = std::move(job), maker = std::move(none)]() mutable -> std::optional<StudyMeasure> {
            StudyMeasure measure;
            // A part of a study may have no reference.
            if (job.isReference) measure.picture = views_[*job.timedView].reference;
            if (measure.picture.empty()) {
                if (!maker) maker = std::make_shared<PictureMaker>(museum_, backend_, job.sceneState, job.wanted);
                maker->step();
                if (!maker->finished()) return std::nullopt;
                const render::Image& picture = maker->picture();
                const bool scaled = picture.width != request_.size.x || picture.height != request_.size.y;
                measure.picture = scaled ? resampled(picture, request_.size) : picture;
                noteClock(maker->report(), measure);  // Before anything is timed: a chart's axis depends on the clock.
            }
            if (!job.timedView) return measure;
            const render::FrameReport report = drawTimed(job.sceneState, *job.timedView);
            measure.counters = report.counters;
            measure.milliseconds = {report.milliseconds};
            noteClock(report, measure);
            return measure;
        },
        std::move(take));
}

std::optional<Setting> Study::settingShownBy(const std::vector<double>& axisValues, std::size_t view,
                                             const SceneState& sceneState) const
{
    if (request_.axes.size() > 2 || studiesMotion()) return std::nullopt;
    Setting setting;
    for (std::size_t i = 0; i < axisValues.size(); ++i) {
        const std::vector<double>& values = request_.axes[i].values;
        const auto found = std::find(values.begin(), values.end(), axisValues[i]);
        if (found == values.end()) return std::nullopt;
        setting.push_back(static_cast<std::size_t>(found - values.begin()));
    }
    return sceneState == lookAt(axisValues, view) ? std::optional(setting) : std::nullopt;
}

void Study::addReference(std::size_t view, bool withNeighbors)
{
    if (views_[view].heldOut && phase_ != Phase::choice) return;
    const SceneState exact = referenceLook(result_.exact, view);
    const std::string place = std::to_string(view) + "_" + std::to_string(doublings_);
    addPicture({"reference_" + place, "reference of " + views_[view].view.name, exact, referenceRequest(exact, view)},
               [this, view](StudyMeasure measure) {
                   if (!views_[view].heldOut) result_.references[view] = measure.picture;
                   views_[view].reference = std::move(measure.picture);
               });
    if (!withNeighbors || studiesMotion()) return;  // A converged picture does not depend on what is studied in motion.
    // The timed frame of a setting follows its picture, so that it finds the same passes done.
    views_[view].setting = settingShownBy(result_.exact, view, exact);
    if (views_[view].setting) addShot(*views_[view].setting, view);
    addNeighbors(view);
}

void Study::addNeighbors(std::size_t view)
{
    int number = 0;
    for (const std::vector<double>& neighbor : neighborsOf(request_.sceneState, request_.axes, doublings_)) {
        const SceneState near = referenceLook(neighbor, view);
        if (const std::optional<Setting> shown = settingShownBy(neighbor, view, near)) {
            views_[view].neighborSettings.push_back(*shown);
            continue;
        }
        addPicture(
            {"check_" + std::to_string(view) + "_" + std::to_string(doublings_) + "_" + std::to_string(number++),
             "check of the reference, " + views_[view].view.name, near, pictureRequest(near, view)},
            [this, view](StudyMeasure measure) { views_[view].neighbors.push_back(std::move(measure.picture)); });
    }
}

void Study::addSetting(const Setting& setting)
{
    if (!addPoint(setting)) return;
    for (std::size_t view = 0; view < result_.views.size(); ++view) addShot(setting, view);
}

bool Study::addPoint(const Setting& setting)
{
    if (!known_.try_emplace(setting, result_.points.size()).second) return false;
    result_.points.push_back({});
    result_.points.back().setting = setting;
    result_.points.back().shots.resize(result_.views.size());
    return true;
}

void Study::addShot(const Setting& setting, std::size_t view)
{
    const std::size_t point = known_.at(setting);
    const SceneState sceneState = lookAt(valuesOf(setting), view);
    addPicture({"setting_" + std::to_string(point) + "_" + std::to_string(view),
                "setting " + std::to_string(point + 1) + ", " + views_[view].view.name, sceneState,
                pictureRequest(sceneState, view), view, views_[view].setting == setting},
               [this, point, view, sceneState](StudyMeasure measure) {
                   takeShot(point, view, sceneState, std::move(measure));
               });
}

void Study::takeShot(std::size_t point, std::size_t view, const SceneState& sceneState, StudyMeasure measure)
{
    StudyShot& shot = result_.points[point].shots[view];
    const int samples = pictureRequest(sceneState, view).samples;
    shot.counters = std::move(measure.counters);
    eraseStateCounters(shot.counters);
    if (const std::int64_t evaluations = channelTotal(measure.picture, "evaluations"); evaluations > 0)
        shot.counters["evaluations"] = evaluations;
    const glm::ivec2 drawn = pictureRequest(sceneState, view).frame.raster.size;
    shot.counters["pixels"] = static_cast<std::int64_t>(drawn.x) * drawn.y;
    for (auto& [name, count] : shot.counters) count *= samples;
    shot.firstMilliseconds = measure.milliseconds.front() * samples;
    shot.errors = judge_.errorsOf(views_[view].reference, measure.picture);
    const std::vector<Setting>& near = views_[view].neighborSettings;
    if (std::find(near.begin(), near.end(), result_.points[point].setting) != near.end())
        views_[view].neighbors.push_back(measure.picture);
    // A search keeps many pictures. Their colors are enough, unless the metric uses other channels.
    shot.picture =
        request_.axes.size() > 2 && goesByColor(request_) ? colorsOf(measure.picture) : std::move(measure.picture);
    if (view + 1 == result_.views.size()) judge();
}

render::FrameReport Study::drawTimed(const SceneState& sceneState, std::size_t view)
{
    // Passes that depend on the studied parameters are always drawn again, since their time is the cost.
    render::PersistentState kept = backend_.persistentState();
    for (const std::string& pass : dependentPasses_) kept.passes.erase(pass);
    FrameRequest frame = pictureRequest(sceneState, view).frame;
    frame.channels = {};
    frame.resetHistory = frame.finished = true;  // The same as for the pictures whose time this is.
    const Prepared prepared = museum_.prepare(sceneState, frame);
    if (studiesMotion()) {
        // The timed frame uses the history of a previous frame.
        frame.movingFrame = 1;
        (void)backend_.draw(museum_.plan(prepared, frame, kept));
        kept = backend_.persistentState();
        frame.movingFrame = 2;
        frame.resetHistory = false;
    }
    render::FrameReport report = backend_.draw(museum_.plan(prepared, frame, kept));
    noteDrawn(museum_, report);
    return report;
}

void Study::addTimes()
{
    std::vector<std::size_t> timed(result_.points.size());
    std::iota(timed.begin(), timed.end(), std::size_t{0});
    // In a search, a setting is not timed if another is as exact and cheaper by more than the noise of one frame. A
    // setting that can neither be chosen nor is on the front is not timed, either.
    if (request_.axes.size() > 2) {
        std::erase_if(timed, [&](std::size_t i) {
            if (result_.present == i) return false;
            const bool onFront = std::find(result_.front.begin(), result_.front.end(), i) != result_.front.end();
            if (request_.maxError && result_.points[i].worstError > *request_.maxError && !onFront) return true;
            return std::any_of(result_.points.begin(), result_.points.end(), [&](const StudyPoint& other) {
                return other.error <= result_.points[i].error && other.cost * 1.3 < result_.points[i].cost;
            });
        });
    }
    for (std::size_t run = 0; run < static_cast<std::size_t>(request_.runs); ++run) {
        for (const std::size_t i : render::interleaved(timed.size(), run)) {
            const std::size_t point = timed[i];
            addMeasure(
                "run_" + std::to_string(run) + "_" + std::to_string(point),
                "run " + std::to_string(run + 1) + " of " + std::to_string(request_.runs),
                [this, point, times = StudyMeasure{}]() mutable -> std::optional<StudyMeasure> {
                    const std::size_t view = times.milliseconds.size();
                    if (view == 0 && isRanked(result_.points, point)) return times;
                    const SceneState sceneState = lookAt(valuesOf(result_.points[point].setting), view);
                    const render::FrameReport report = drawTimed(sceneState, view);
                    times.milliseconds.push_back(report.milliseconds * pictureRequest(sceneState, view).samples);
                    noteClock(report, times);
                    if (times.milliseconds.size() < result_.views.size()) return std::nullopt;
                    return std::move(times);
                },
                [this, point](const StudyMeasure& times) {
                    for (std::size_t view = 0; view < times.milliseconds.size(); ++view)
                        result_.points[point].shots[view].milliseconds.push_back(times.milliseconds[view]);
                    result_.points[point].time = timeOf(result_.points[point]);  // Charts show the time immediately.
                });
        }
    }
}

namespace {

// Rotation of the camera between two frames of a picture in motion, in pixels. It is not a whole number, so texels of
// consecutive frames do not coincide. The picture is compared after more frames than any history averages.
constexpr double turnPerFrame = 2.3;
constexpr int framesOfMotion = 24;

/// Returns the camera rotated by `pixels` of the image center to the left, about its vertical axis.
render::Camera turnedBy(const render::Camera& camera, double pixels, int height)
{
    const double angle = std::atan(2 * std::tan(camera.fovY / 2) / height) * pixels;
    const glm::dvec3 arm = camera.target - camera.eye;
    render::Camera turned = camera;
    turned.target = camera.eye + glm::dvec3(std::cos(angle) * arm.x + std::sin(angle) * arm.z, arm.y,
                                            std::cos(angle) * arm.z - std::sin(angle) * arm.x);
    return turned;
}

}  // namespace

PictureRequest Study::pictureRequest(const SceneState& sceneState, std::size_t view) const
{
    PictureRequest request;
    const PictureQuality quality = pictureQuality(sceneState.hall());
    const bool supersampled = std::any_of(request_.axes.begin(), request_.axes.end(), [&](const StudyAxis& a) {
        return a.subject == hallIndex && parameterOf(request_.sceneState, a).name == supersamplesParameter;
    });
    request.samples = supersampled ? quality.supersamples : 1;
    request.frame.raster.size =
        glm::max(glm::ivec2(glm::round(glm::dvec2(request_.size) * quality.resolutionScale)), glm::ivec2(1));
    request.frame.camera = sceneState.camera;
    request.frame.time = views_[view].view.time;
    request.frame.needsFiles = request_.needsFiles;
    if (request_.alone)
        request.frame.alone = request_.subject;
    else if (request_.subject != hallIndex)
        request.frame.subject = request_.subject;
    request.frame.channels = {.normal = true, .evaluations = true};
    request.depth = true;
    request.largestTile = request_.largestTile;
    if (!studiesMotion()) return request;
    request.samples = 1;
    for (int left = framesOfMotion; left > 0; --left)
        request.motion.push_back(
            {turnedBy(sceneState.camera, turnPerFrame * left, request.frame.raster.size.y), request.frame.time});
    return request;
}

PictureRequest Study::referenceRequest(const SceneState& sceneState, std::size_t view) const
{
    PictureRequest request = pictureRequest(sceneState, view);
    if (!studiesMotion()) return request;
    request.motion.clear();
    const ParameterValues& hall = sceneState.hall();
    if (const auto row = hall.table().find(supersamplesParameter))
        request.samples = static_cast<int>(hall.rows()[*row].qualityReference.value_or(64));
    return request;
}

}  // namespace vitrine::study
