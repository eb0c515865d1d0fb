#include "exhibits/jobs/record/record_job.h"

#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/jobs/kit/job_document.h"
#include "exhibits/jobs/kit/picture_channels.h"
#include "exhibits/jobs/record/record_preview.h"
#include "exhibits/jobs/record/record_table.h"
#include "exhibits/museum/picture_settings.h"
#include "exhibits/recording/record.h"
#include "exhibits/recording/tour.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/extension.h"
#include "render/files/number_text.h"
#include "render/video/video_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace vitrine::jobs {

const RecordTable& recordTable()
{
    static const RecordTable table;
    return table;
}

namespace {

using recording::bookmarksFile;
using recording::firstCollision;
using recording::framePath;
using recording::isFramePattern;
using recording::isWholeTurns;
using recording::museumTour;
using recording::Pace;
using recording::paced;
using recording::readTour;
using recording::RecordedScene;
using recording::Recording;
using recording::RecordingRequest;
using recording::RecordingShare;
using recording::Tour;
using recording::tourPath;
using recording::turntable;
using recording::whyNotRecordable;

constexpr int frameSideOfDraft = 240;  // Pixels of each frame in the preview.

struct RecordInputs final : JobInputs {
    std::optional<Tour> tour, bookmarks;
    std::string bookmarksProblem;  ///< Sentence on why the bookmarks cannot be read; empty: they can.
};

/// Returns the path of the camera, with `automatic` resolved by the scene.
RecordPath pathOf(const ParameterValues& values, const JobScene& scene)
{
    const RecordPath path = values[recordTable().path];
    if (path != RecordPath::automatic) return path;
    const bool isHall = scene.museum && scene.subject == hallIndex;
    return isHall ? RecordPath::tour : RecordPath::turntable;
}

Pace paceOf(const ParameterValues& values, Pace automatic)
{
    const RecordPace pace = values[recordTable().pace];
    if (pace == RecordPace::automatic) return automatic;
    return pace == RecordPace::eased ? Pace::eased : Pace::constant;
}

/// Returns the request without the motion of the camera.
RecordingRequest requestOf(const ParameterValues& values, const JobScene& scene)
{
    const RecordTable& t = recordTable();
    RecordingRequest request;
    request.picture.frame = scene.frame;
    request.picture.frame.raster.size = {values[t.width], values[t.height]};
    request.picture.frame.needsFiles = true;
    request.picture.samples = values[t.samples];
    if (request.picture.samples == 0) request.picture.samples = scene.usual.samples;
    if (request.picture.samples == 0) request.picture.samples = scene.museum ? usualSamples(scene.state.hall()) : 1;
    request.seconds = values[t.seconds];
    request.framesPerSecond = values[t.framesPerSecond];
    request.shutter = values[t.shutter];
    request.shutterSamples = values[t.shutterSamples];
    return request;
}

std::vector<Fact> factsOf(const RecordingRequest& request)
{
    const glm::dvec2 size = request.picture.frame.raster.size;
    return {{"Frames", static_cast<double>(request.frames())},
            {"Frame size", render::shortestNumber(size.x) + " × " + render::shortestNumber(size.y), "px"}};
}

/// Moves the camera around its target: in a loop, or to and fro about the view. Throws Failure (ErrorKind::usage) if it
/// runs into an obstacle.
void turnAround(const ParameterValues& values, const JobScene& scene, RecordingRequest& request)
{
    const FrameRequest& frame = request.picture.frame;
    const double given = values[recordTable().turn];
    const double angle = given != 0 ? given : (frame.alone ? 2 : 1.0 / 3) * std::numbers::pi;
    request.closed = isWholeTurns(angle);
    request.camera = turntable(frame.camera, angle, paceOf(values, request.closed ? Pace::constant : Pace::eased));
    if (frame.alone || firstCollision(scene.museum->surroundings().obstacles(scene.state), request.camera) < 0) return;
    throw Failure(ErrorKind::usage, "A camera that turns by " + render::shortNumber(angle * 180 / std::numbers::pi) +
                                        " degrees runs into a wall or an object; turn by a smaller angle, or "
                                        "show the exhibit alone.");
}

/// Returns why the frames cannot carry the channels, as a full sentence; empty if they can.
std::string whyNotChannels(const ParameterValues& values, const std::filesystem::path& out)
{
    const RecordTable& t = recordTable();
    if (values[t.channels].empty()) return {};
    try {
        static_cast<void>(channelsNamed(values[t.channels]));
    } catch (const Failure& failure) {
        return failure.what();
    }
    if (render::lowerExtension(out) != ".exr")
        return "--channels: only frames of OpenEXR carry more than color; give --out a name like frames/%04d.exr.";
    if (values[t.shutter] > 0) return "--channels: motion blur has only a color; leave --shutter out.";
    return {};
}

std::string refusalOf(const ParameterValues& values, const JobScene& scene, const RecordInputs& inputs)
{
    const RecordPath path = pathOf(values, scene);
    if (scene.frame.alone && path != RecordPath::turntable && path != RecordPath::still)
        return "A tour needs the hall, but the exhibit is shown alone; choose turntable or still, or show it in the "
               "hall.";
    if (path != RecordPath::bookmarks) return {};
    if (!inputs.bookmarksProblem.empty()) return inputs.bookmarksProblem;
    if (inputs.bookmarks && inputs.bookmarks->bookmarks.size() > 1) return {};
    return "Set two bookmarks at least: one where you stand, then another elsewhere (View > Add bookmark).";
}

/// Returns the request with the motion of the camera. Finding a way around walls takes a while.
RecordingRequest wholeRequest(const JobOrder& order)
{
    const auto& inputs = static_cast<const RecordInputs&>(*order.inputs);
    RecordingRequest request = requestOf(order.values, order.scene);
    if (const std::string why = whyNotChannels(order.values, order.out); !order.out.empty() && !why.empty())
        throw Failure(ErrorKind::usage, why);
    // The camera of the frame before is known for each frame: `pictureAt`.
    addChannels(channelsNamed(order.values[recordTable().channels]), FrameBefore{1 / request.framesPerSecond, {}},
                request.picture);
    request.picture.largestTile = order.largestTile;
    const RecordPath path = pathOf(order.values, order.scene);
    if (path == RecordPath::turntable) {
        turnAround(order.values, order.scene, request);
    } else if (path == RecordPath::still) {
        request.camera = [camera = request.picture.frame.camera](double) { return camera; };
        request.closed = true;
    } else {
        const Museum& museum = *order.scene.museum;
        if (const std::string why = refusalOf(order.values, order.scene, inputs); !why.empty())
            throw Failure(ErrorKind::usage, why);
        const Tour tour = path == RecordPath::bookmarks ? *inputs.bookmarks
                          : inputs.tour                 ? *inputs.tour
                                                        : museumTour(museum, order.scene.state);
        request.closed = tour.closed;
        request.camera = [way = tourPath(museum.surroundings().obstacles(order.scene.state), tour),
                          pace = paceOf(order.values, tour.pace)](double part) { return way.at(paced(pace, part)); };
    }
    return request;
}

class RecordRun final : public JobRun {
public:
    explicit RecordRun(JobOrder order) : order_(std::move(order)) {}

    [[nodiscard]] Next next() const override
    {
        if (!request_) return Next::work;
        return recording_ && recording_->finished() ? Next::done : Next::draw;
    }
    void step(const Watch&) override
    {
        if (!request_) {
            request_ = wholeRequest(order_);
            return;
        }
        if (!recording_) begin();
        recording_->step();
        if (recording_->finished()) end();
    }
    [[nodiscard]] double progress() const override { return recording_ ? recording_->progress() : 0; }
    [[nodiscard]] std::string_view doing() const override { return request_ ? "recording" : "finding the way"; }
    [[nodiscard]] const JobReport& report() const override { return report_; }
    void publish() override
    {
        std::vector<std::unique_ptr<render::PartFile>> document;
        if (!order_.share.makes)
            document.push_back(
                render::stagedFile(documentFile(order_.out), documentText(RecordJob(), order_, factsOf(*request_))));
        recording_->publish();
        render::publishAll(document);
    }

private:
    void begin()
    {
        backend_ = order_.backend ? order_.backend() : nullptr;
        if (!backend_) throw Failure(ErrorKind::openGl, "Nothing can be recorded: there is no graphics context.");
        const JobScene& scene = order_.scene;
        recording_ =
            std::make_unique<Recording>(*scene.museum, *backend_, RecordedScene{scene.state, scene.subject}, *request_,
                                        order_.out, RecordingShare{order_.share.makes, order_.share.from});
    }
    void end()
    {
        backend_.reset();
        report_.facts = factsOf(*request_);
        if (recording_->kept() > 0 && order_.share.from.empty())
            report_.facts.push_back({"Kept", static_cast<double>(recording_->kept())});
        report_.files = {order_.out, documentFile(order_.out)};
        if (!order_.share.makes) return;
        report_.files.clear();
        for (int k = 0; k < request_->frames(); ++k)
            if (order_.share.makes(k)) report_.files.push_back(framePath(order_.out, k));
    }

    JobOrder order_;
    std::optional<RecordingRequest> request_;
    std::unique_ptr<render::RenderBackend> backend_;
    std::unique_ptr<Recording> recording_;  ///< Declared last: destroyed before the renderer that it uses.
    JobReport report_;
};

}  // namespace

const Parameters& RecordJob::parameters() const
{
    return recordTable();
}

JobNeeds RecordJob::needs() const
{
    // Videos, then frames.
    std::vector<std::string_view> endings{"mp4", "webm", "gif", "webp", "apng", "png"};
    endings.emplace_back("exr");
    return {.anyScene = true,
            .extensions = std::move(endings),
            .inWindow = true,
            .inParts = true,
            .preview = PreviewForm::picture};
}

std::shared_ptr<const JobInputs> RecordJob::read(const ParameterValues& values) const
{
    auto inputs = std::make_shared<RecordInputs>();
    const std::string& file = values[recordTable().tour];
    if (values[recordTable().path] == RecordPath::tour && !file.empty()) inputs->tour = readTour(file);
    std::error_code ignored;
    try {
        if (std::filesystem::exists(bookmarksFile(), ignored)) inputs->bookmarks = readTour(bookmarksFile());
    } catch (const Failure& failure) {
        inputs->bookmarksProblem = failure.what();
    }
    return inputs;
}

JobPlan RecordJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs& inputs,
                        const std::filesystem::path& out) const
{
    const auto& read = static_cast<const RecordInputs&>(inputs);
    const RecordingRequest request = requestOf(values, scene);
    JobPlan plan;
    plan.refusal = refusalOf(values, scene, read);
    plan.offers["channels"] = {"color", "color,depth,motion", "color,albedo,normal",
                               "color,depth,normal,position,object"};
    if (read.tour && pathOf(values, scene) == RecordPath::tour) plan.warnings = read.tour->notes;
    plan.facts = factsOf(request);
    if (out.empty()) return plan;
    if (plan.refusal.empty()) plan.refusal = refusedExtension(*this, out);
    if (plan.refusal.empty()) plan.refusal = whyNotRecordable(request, out);
    if (plan.refusal.empty()) plan.refusal = whyNotChannels(values, out);
    const bool isFrames = isFramePattern(out);
    plan.makesFolders = isFrames;
    plan.ifStopped = isFrames ? "Stopped; the frames so far are whole, and the same settings go on with the next one."
                              : "Stopped; nothing was written.";
    plan.files = {{out, isFrames ? "frames" : "recording"}, {documentFile(out), "settings"}};
    return plan;
}

double RecordJob::effort(const ParameterValues& values, const JobScene& scene) const
{
    const RecordingRequest request = requestOf(values, scene);
    const glm::dvec2 size = request.picture.frame.raster.size;
    const double picturesPerFrame = request.shutter > 0 ? std::max(request.shutterSamples, 1) : 1;
    return size.x * size.y * request.picture.samples * picturesPerFrame * request.frames();
}

ParameterValues RecordJob::draft(const ParameterValues& values, const JobInputs&) const
{
    const RecordTable& t = recordTable();
    const double shrink =
        frameSideOfDraft / static_cast<double>(std::max({values[t.width], values[t.height], frameSideOfDraft}));
    // Videos in 4:2:0 need even sizes.
    const auto smaller = [&](int pixels) {
        return shrink < 1 ? std::max(2 * static_cast<int>(std::lround(pixels * shrink / 2)), 2) : pixels;
    };
    ParameterValues small = values;
    small.set(t.width, smaller(values[t.width]));
    small.set(t.height, smaller(values[t.height]));
    small.set(t.samples, 1);
    small.set(t.shutter, 0.0);
    small.set(t.channels, std::string());
    return small;
}

JobForecast RecordJob::forecast(const ParameterValues& values, const FinishedDraft& draft,
                                const std::filesystem::path& out) const
{
    const RecordTable& t = recordTable();
    const auto& preview = static_cast<const RecordPreview&>(draft.run);
    if (!isFramePattern(out) && !render::videoFormatOf(out)) return {};
    const auto pixels = [&](const ParameterValues& of) { return static_cast<double>(of[t.width]) * of[t.height]; };
    try {
        return {{fileAbout(grownBytes(preview.bytes(out), pixels(values) / pixels(draft.values), out))}};
    } catch (const Failure&) {
        return {};  // The export itself says why nothing can be written.
    }
}

std::unique_ptr<JobRun> RecordJob::start(JobOrder order) const
{
    if (order.out.empty()) return std::make_unique<RecordPreview>(std::move(order), wholeRequest);
    return std::make_unique<RecordRun>(std::move(order));
}

bool RecordJob::usesCamera(const ParameterValues& values, const JobScene& scene) const
{
    const RecordPath path = pathOf(values, scene);
    return path == RecordPath::turntable || path == RecordPath::still;
}

std::string RecordJob::partItems(const std::filesystem::path& out) const
{
    return isFramePattern(out) ? std::string() : "%06d.png";
}

}  // namespace vitrine::jobs
