#include "exhibits/jobs/record/record_preview.h"

#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/recording/record.h"
#include "render/failure.h"
#include "render/video/video_file.h"

#include <algorithm>
#include <cmath>

namespace vitrine::jobs {
namespace record_previews {
namespace {

constexpr int mostShown = 6;
constexpr int columns = 2;
constexpr int gap = 2;               // Pixels between two frames.
constexpr double keyDistance = 250;  // Frames from one that is stored whole to the next, usual for encoders.

/// Returns the number of frame i of `shown` that are evenly spaced over the recording. The last one of a loop is the
/// one before the first.
int evenlySpaced(const recording::RecordingRequest& request, int i, int shown)
{
    const int frames = request.frames();
    if (request.closed || shown < 2) return static_cast<int>(static_cast<long long>(i) * frames / shown);
    return static_cast<int>(std::lround(static_cast<double>(i) * (frames - 1) / (shown - 1)));
}

void place(render::Image& sheet, const render::Image& picture, int left, int top)
{
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < sheet.channels; ++c)
                sheet.at(left + x, top + y, c) = c < picture.channels ? picture.at(x, y, c) : 1.0F;
}

}  // namespace
}  // namespace record_previews

RecordPreview::RecordPreview(JobOrder order, RequestMaker makeRequest)
    : order_(std::move(order)), makeRequest_(makeRequest)
{
}

JobRun::Next RecordPreview::next() const
{
    if (!request_) return Next::work;
    return drawn_ < frames_.size() ? Next::draw : Next::done;
}

double RecordPreview::progress() const
{
    if (frames_.empty()) return 0;
    return (static_cast<double>(drawn_) + (maker_ ? maker_->progress() : 0)) / static_cast<double>(frames_.size());
}

void RecordPreview::chooseFrames()
{
    const int frames = request_->frames(), shown = std::min(frames, record_previews::mostShown);
    for (int i = 0; i < shown; ++i) {
        const int number = record_previews::evenlySpaced(*request_, i, shown);
        frames_.push_back({number});
        const bool isJudged = i == shown / 4 || i == shown * 3 / 4;
        if (isJudged && number + 1 < frames) frames_.push_back({number + 1, false});
    }
}

void RecordPreview::step(const Watch&)
{
    if (!request_) {
        request_ = makeRequest_(order_);
        chooseFrames();
        return;
    }
    if (!backend_) backend_ = order_.backend ? order_.backend() : nullptr;
    if (!backend_) throw Failure(ErrorKind::openGl, "Nothing can be recorded: there is no graphics context.");
    Frame& frame = frames_[drawn_];
    const JobScene& scene = order_.scene;
    if (!maker_)
        maker_ =
            std::make_unique<recording::FrameMaker>(*scene.museum, *backend_, scene.state, *request_, frame.number);
    maker_->step();
    if (!maker_->finished()) return;
    frame.picture = maker_->picture();
    maker_.reset();
    if (++drawn_ == frames_.size()) backend_.reset();
}

render::Image RecordPreview::previewPicture() const
{
    std::vector<const render::Image*> shown;
    for (const Frame& frame : frames_)
        if (frame.isShown) shown.push_back(&frame.picture);
    if (shown.empty()) return {};
    using namespace record_previews;
    const int wide = shown.size() > 1 ? columns : 1, high = (static_cast<int>(shown.size()) + wide - 1) / wide;
    const int width = shown[0]->width + gap, height = shown[0]->height + gap;
    render::Image sheet(wide * width - gap, high * height - gap, 4);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const int k = static_cast<int>(i);
        place(sheet, *shown[i], k % wide * width, k / wide * height);
    }
    return sheet;
}

double RecordPreview::bytes(const std::filesystem::path& out) const
{
    const double all = request_->frames();
    std::vector<render::Image> single, pairs;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        const bool isPair = i + 1 < frames_.size() && !frames_[i + 1].isShown;
        if (!isPair) continue;
        single.push_back(frames_[i].picture);
        pairs.push_back(frames_[i].picture);
        pairs.push_back(frames_[i + 1].picture);
    }
    if (recording::isFramePattern(out) || pairs.empty()) {
        double sum = 0;
        for (const Frame& frame : frames_) sum += frame.isShown ? pictureBytes(frame.picture, out) : 0;
        const auto shown = std::count_if(frames_.begin(), frames_.end(), [](const Frame& f) { return f.isShown; });
        return all * sum / static_cast<double>(shown);
    }
    const render::Image& first = single.front();
    const render::VideoSpec spec{
        *render::videoFormatOf(out),         first.width, first.height, request_->framesPerSecond,
        request_->picture.frame.transparent, {}};
    const double whole = videoBytes(single, spec, out) / static_cast<double>(single.size());
    const double change = std::max(videoBytes(pairs, spec, out) / static_cast<double>(single.size()) - whole, 0.0);
    const double keys = std::ceil(all / record_previews::keyDistance);
    return keys * whole + (all - keys) * change;
}

}  // namespace vitrine::jobs
