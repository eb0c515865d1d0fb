// What a study draws and times, one job after the other.

#include "exhibits/study/study.h"

#include "exhibits/study/point_time.h"
#include "exhibits/study/study_picture.h"

#include <algorithm>
#include <numeric>

namespace vitrine {
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
            if (pass.key) keys[pass.name] = *pass.key;
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

void Study::addMeasure(std::string key, std::string name, std::function<std::optional<StudyMeasure>()> measure,
                       std::function<void(StudyMeasure)> take)
{
    const bool makes = !parts_ || parts_->makes(measures_);
    ++measures_;
    jobs_.push_back(
        {std::move(name), [this, key = std::move(key), measure = std::move(measure), take = std::move(take), makes] {
             if (!makes) return true;
             std::optional<StudyMeasure> found;
             if (parts_ && !parts_->isPart()) found = parts_->find(key);
             if (!found) found = measure();
             if (!found) return false;
             if (parts_ && parts_->isPart()) {
                 parts_->keep(key, *found);
                 return true;
             }
             if (!found->clock.empty()) {
                 result_.clock = found->clock;
                 result_.clockTrusted = found->clockTrusted;
                 result_.overheadMilliseconds = found->overheadMilliseconds;
             }
             take(std::move(*found));
             return true;
         }});
}

void Study::addPicture(PictureJob job, std::function<void(StudyMeasure)> take)
{
    std::string key = job.key;
    std::string name = job.name;
    // Made when its turn comes: it holds the whole picture.
    std::shared_ptr<PictureMaker> none;
    addMeasure(
        std::move(key), std::move(name),
        [this, job = std::move(job), maker = std::move(none)]() mutable -> std::optional<StudyMeasure> {
            if (!maker) maker = std::make_shared<PictureMaker>(museum_, backend_, job.sceneState, job.wanted);
            maker->step();
            if (!maker->finished()) return std::nullopt;
            const render::Image& picture = maker->picture();
            const bool scaled = picture.width != request_.size.x || picture.height != request_.size.y;
            StudyMeasure measure{.picture = scaled ? resampled(picture, request_.size) : picture};
            noteClock(maker->report(), measure);  // Before anything is timed: a chart's axis depends on the clock.
            if (!job.timedView) return measure;
            const render::FrameReport report = drawTimed(job.sceneState, *job.timedView);
            measure.counters = report.counters;
            measure.milliseconds = {report.milliseconds};
            noteClock(report, measure);
            return measure;
        },
        std::move(take));
}

void Study::addReference(std::size_t view, bool withNeighbors)
{
    if (views_[view].heldOut && phase_ != Phase::choice) return;
    const SceneState exact = referenceLook(view);
    const std::string place = std::to_string(view) + "_" + std::to_string(doublings_);
    addPicture({"reference_" + place, "reference of " + views_[view].view.name, exact, referenceRequest(exact, view)},
               [this, view](StudyMeasure measure) {
                   if (!views_[view].heldOut) result_.references[view] = measure.picture;
                   views_[view].reference = std::move(measure.picture);
               });
    if (!withNeighbors || studiesMotion()) return;  // At rest, nothing of what is studied acts.
    int number = 0;
    for (const std::vector<double>& neighbor : neighborsOf(request_.sceneState, request_.axes, doublings_)) {
        const SceneState near = lookAt(neighbor, view);
        addPicture(
            {"check_" + place + "_" + std::to_string(number++), "check of the reference, " + views_[view].view.name,
             near, pictureRequest(near, view)},
            [this, view](StudyMeasure measure) { views_[view].neighbors.push_back(std::move(measure.picture)); });
    }
}

void Study::addSetting(const Setting& setting)
{
    if (!known_.try_emplace(setting, result_.points.size()).second) return;
    const std::size_t point = result_.points.size();
    result_.points.push_back({});
    result_.points.back().setting = setting;
    result_.points.back().shots.resize(result_.views.size());
    for (std::size_t view = 0; view < result_.views.size(); ++view) {
        const SceneState sceneState = lookAt(valuesOf(setting), view);
        addPicture({"setting_" + std::to_string(point) + "_" + std::to_string(view),
                    "setting " + std::to_string(point + 1) + ", " + views_[view].view.name, sceneState,
                    pictureRequest(sceneState, view), view},
                   [this, point, view, sceneState](StudyMeasure measure) {
                       takeShot(point, view, sceneState, std::move(measure));
                   });
    }
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
    // A search keeps many pictures: of those, the colors are enough, unless it goes by something else.
    shot.picture =
        request_.axes.size() > 2 && goesByColor(request_) ? colorsOf(measure.picture) : std::move(measure.picture);
    if (view + 1 == result_.views.size()) judge();
}

render::FrameReport Study::drawTimed(const SceneState& sceneState, std::size_t view)
{
    // What the studied parameters change is drawn anew, however often it was drawn: it is what they cost.
    render::PersistentState kept = backend_.persistentState();
    for (const std::string& pass : dependentPasses_) kept.passes.erase(pass);
    FrameRequest frame = pictureRequest(sceneState, view).frame;
    frame.channels = {};
    frame.cut = frame.finished = true;  // As the pictures that it is the time of.
    const Prepared prepared = museum_.prepare(sceneState, frame);
    if (studiesMotion()) {
        // What is timed finds what a frame before it left.
        frame.movingFrame = 1;
        (void)backend_.draw(museum_.plan(prepared, frame, kept));
        kept = backend_.persistentState();
        frame.movingFrame = 2;
        frame.cut = false;
    }
    return backend_.draw(museum_.plan(prepared, frame, kept));
}

void Study::addTimes()
{
    std::vector<std::size_t> timed(result_.points.size());
    std::iota(timed.begin(), timed.end(), std::size_t{0});
    // In a search, what is dearer and no better by a margin beyond the noise of one frame stays untimed, and so does
    // what can neither be chosen nor is on the front.
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
                    result_.points[point].time = timeOf(result_.points[point]);  // So that charts show it at once.
                });
        }
    }
}

}  // namespace vitrine
