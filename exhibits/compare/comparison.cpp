#include "exhibits/compare/comparison.h"

#include "exhibits/study/study_picture.h"
#include "render/measure/distance.h"

#include <algorithm>

namespace vitrine::compare {
namespace {

/// Adds a tile to the report of its frame: milliseconds are summed, and steps that ran for the first tile only are
/// kept.
void addTile(render::FrameReport& whole, const render::FrameReport& tile)
{
    std::map<std::string, int> seen;
    for (const render::StepReport& step : tile.ran) {
        int before = seen[step.name]++;
        const auto same = std::find_if(whole.ran.begin(), whole.ran.end(), [&](const render::StepReport& known) {
            return known.name == step.name && before-- == 0;
        });
        if (same == whole.ran.end())
            whole.ran.push_back(step);
        else if (step.milliseconds >= 0)
            same->milliseconds = std::max(same->milliseconds, 0.0) + step.milliseconds;
    }
    for (const auto& [name, count] : tile.counters) whole.counters[name] += count;
    whole.milliseconds += tile.milliseconds;
    whole.wallMilliseconds += tile.wallMilliseconds;
    whole.overheadMilliseconds += tile.overheadMilliseconds;
}

}  // namespace

Comparison::Comparison(const Museum& museum, render::RenderBackend& backend, ComparisonRequest request)
    : museum_(museum), backend_(backend), request_(std::move(request))
{
    request_.runs = std::max(request_.runs, 0);
    for (std::size_t side = 0; side < 2; ++side)
        makers_[side].emplace(museum_, backend_, request_.settings[side], pictureRequest(side));
}

PictureRequest Comparison::pictureRequest(std::size_t side) const
{
    PictureRequest picture;
    picture.frame = request_.frame;
    picture.frame.channels.evaluations = true;
    picture.samples = request_.samples[side];
    picture.largestTile = request_.largestTile;
    return picture;
}

bool Comparison::step()
{
    if (finished_) return false;
    for (std::size_t side = 0; side < 2; ++side) {
        if (makers_[side]->finished()) continue;
        makers_[side]->step();
        if (makers_[side]->finished()) takePicture(side);
        return true;
    }
    const std::size_t frames = request_.runs > 0 ? 2 * (static_cast<std::size_t>(request_.runs) + 1) : 0;
    if (framesTimed_ < frames) {
        drawTimed(framesTimed_ % 2);
        ++framesTimed_;
        return true;
    }
    finish();
    return false;
}

double Comparison::progress() const
{
    if (finished_) return 1;
    // A timed frame takes about as long as one sample.
    const double timed = request_.runs > 0 ? 2.0 * (request_.runs + 1) : 0;
    double all = timed, done = static_cast<double>(framesTimed_);
    for (std::size_t side = 0; side < 2; ++side) {
        all += request_.samples[side];
        done += request_.samples[side] * makers_[side]->progress();
    }
    return all > 0 ? std::min(done / all, 1.0) : 0;
}

void Comparison::takePicture(std::size_t side)
{
    ComparedSide& compared = result_.sides[side];
    const render::Image& picture = makers_[side]->picture();
    compared.report = makers_[side]->report();
    if (const std::int64_t evaluations = study::channelTotal(picture, "evaluations"); evaluations > 0)
        compared.report.counters["evaluations"] = evaluations;
    compared.picture = study::colorsOf(picture);
}

void Comparison::drawTimed(std::size_t side)
{
    FrameRequest frame = request_.frame;
    frame.resetHistory = frame.finished = true;  // The same as for the picture.
    const glm::ivec2 size = frame.raster.size;
    const int largest = std::max(std::min(request_.largestTile, backend_.largestSide()), 1);
    std::optional<render::FrameReport> whole;
    for (int y = 0; y < size.y; y += largest)
        for (int x = 0; x < size.x; x += largest) {
            frame.raster.offset = {x, y};
            if (std::max(size.x, size.y) > largest)
                frame.raster.tile = glm::min(glm::ivec2(largest), size - frame.raster.offset);
            const render::FrameReport tile = backend_.draw(
                museum_.plan(museum_.prepare(request_.settings[side], frame), frame, backend_.persistentState()));
            if (whole)
                addTile(*whole, tile);
            else
                whole = tile;
        }
    render::FrameReport& report = *whole;
    ComparedSide& compared = result_.sides[side];
    if (framesTimed_ >= 2) {  // The first frame of each compiles programs.
        compared.milliseconds.push_back(report.milliseconds);
        std::map<std::string, int> seen;
        for (const render::StepReport& step : report.ran) {
            const int number = seen[step.name]++;
            if (step.milliseconds >= 0) stepTimes_[side][{step.name, number}].push_back(step.milliseconds);
        }
    }
    if (const auto counted = compared.report.counters.find("evaluations"); counted != compared.report.counters.end())
        report.counters.insert(*counted);
    compared.report = std::move(*whole);
}

void Comparison::finish()
{
    for (std::size_t side = 0; side < 2; ++side) {
        ComparedSide& compared = result_.sides[side];
        if (!compared.milliseconds.empty()) {
            compared.time = render::summarize(compared.milliseconds);
            compared.report.milliseconds = compared.time->median;
        }
        std::map<std::string, int> seen;
        for (render::StepReport& step : compared.report.ran) {
            const auto times = stepTimes_[side].find({step.name, seen[step.name]++});
            step.milliseconds = times == stepTimes_[side].end() ? -1 : render::summarize(times->second).median;
        }
        makers_[side].reset();
    }
    const render::Image &a = result_.sides[0].picture, &b = result_.sides[1].picture;
    result_.errors = render::distances({a, b, request_.pixelsPerDegree});
    result_.rows = differingParameters(request_.settings[0], request_.settings[1]);
    result_.passes = passCosts(result_.sides[0].report, result_.sides[1].report);
    result_.counters = counterCosts(result_.sides[0].report, result_.sides[1].report);
    finished_ = true;
}

}  // namespace vitrine::compare
