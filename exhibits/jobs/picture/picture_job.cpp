#include "exhibits/jobs/picture/picture_job.h"

#include "exhibits/jobs/kit/expected_size.h"
#include "exhibits/jobs/kit/picture_channels.h"
#include "exhibits/jobs/picture/picture_table.h"
#include "exhibits/museum/exr_metadata.h"
#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/files/atomic_write.h"
#include "render/files/number_text.h"
#include "render/plan/diagnostics.h"
#include "render/video/video_file.h"

#include <algorithm>
#include <cmath>

namespace vitrine::jobs {

const PictureTable& pictureTable()
{
    static const PictureTable table;
    return table;
}

namespace {

constexpr glm::ivec2 usualSize{640, 360};
constexpr int draftSide = 480;  // Pixels.

glm::ivec2 sizeOf(const ParameterValues& values, const JobScene& scene)
{
    const glm::ivec2 usual = scene.usual.size.x > 0 && scene.usual.size.y > 0 ? scene.usual.size : usualSize;
    const int width = values[pictureTable().width], height = values[pictureTable().height];
    const double aspect = static_cast<double>(usual.x) / usual.y;
    if (width > 0 && height > 0) return {width, height};
    if (width > 0) return {width, std::max(1, static_cast<int>(std::lround(width / aspect)))};
    if (height > 0) return {std::max(1, static_cast<int>(std::lround(height * aspect))), height};
    return usual;
}

int samplesOf(const ParameterValues& values, const JobScene& scene)
{
    if (const int given = values[pictureTable().samples]; given > 0) return given;
    if (scene.usual.samples > 0) return scene.usual.samples;
    return scene.museum ? usualSamples(scene.state.hall()) : 1;
}

bool isBeyondColor(const PictureRecord& named)
{
    PictureRecord record = named;
    const std::vector<std::string_view> names = channelNames();
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return *channelOf(record, name); });
}

/// A still picture in WebP, which the encoder of videos writes: lossless, with its settings.
std::unique_ptr<render::PartFile> stagedWebp(const std::filesystem::path& out, const render::Image& picture,
                                             bool transparent, std::string settings)
{
    render::VideoFile file(
        out, {render::VideoFormat::webp, picture.width, picture.height, 1, transparent, std::move(settings)});
    file.add(picture);
    return file.staged();
}

bool isWebp(const std::filesystem::path& out)
{
    return render::videoFormatOf(out) == render::VideoFormat::webp;
}

bool isLinear(const std::filesystem::path& out)
{
    const auto format = render::writtenFormat(out);
    return format && render::fileFormat(*format).isLinear;
}

std::vector<std::string_view> pictureEndings()
{
    std::vector<std::string_view> endings = render::writtenEndings();
    endings.push_back("webp");
    return endings;
}

/// Returns why no WebP can be written, as a full sentence; empty if it can.
std::string whyNoWebp(const ParameterValues& values, const PictureRequest& request)
{
    if (values[pictureTable().sixteenBit])
        return "--sixteen-bit: WebP does not support 16 bits; give --out a name that ends in " +
               render::writtenExtensions(16) + ", or leave the option out.";
    const glm::ivec2 size = request.frame.raster.size;
    constexpr int longest = 16383;
    if (std::max(size.x, size.y) <= longest) return {};
    return "WebP has sides of at most 16383 pixels; give another --size, or --out a name that ends in .png.";
}

std::vector<Fact> factsOf(const PictureRequest& request)
{
    const glm::dvec2 size = request.frame.raster.size;
    return {{"Size", render::shortestNumber(size.x) + " × " + render::shortestNumber(size.y), "px"},
            {"Samples per pixel", static_cast<double>(request.samples)}};
}

}  // namespace

PictureRequest pictureRequest(const ParameterValues& values, const JobScene& scene, const std::filesystem::path& out)
{
    const PictureTable& t = pictureTable();
    PictureRequest request;
    request.frame = scene.frame;
    request.frame.raster.size = sizeOf(values, scene);
    request.frame.runEverything = values[t.runEverything];
    request.frame.needsFiles = true;  // A missing file must fail: a picture without a named object would be wrong.
    if (values[t.transparent]) request.frame.transparent = true;
    if (request.frame.transparent && !request.frame.alone && scene.subject != hallIndex)
        request.frame.cutOut = scene.subject;
    request.samples = samplesOf(values, scene);
    const bool linear = isLinear(out);
    request.frame.averageIn = linear ? AverageIn::radiance : AverageIn::display;
    const PictureRecord named = channelsNamed(values[t.channels]);
    if (!values[t.channels].empty()) {
        addChannels(named, scene.usual.before, request);
    } else if (linear) {
        request.frame.channels = scene.usual.channels;
        request.depth = scene.usual.depth;
        request.position = scene.usual.position;
        request.objects = scene.usual.objects;
        request.before = scene.usual.before;
    }
    if (isBeyondColor(named) && !linear && !out.empty())
        throw Failure(ErrorKind::usage,
                      "--channels: only OpenEXR carries more than color; give --out a name that ends in .exr.");
    return request;
}

render::PictureFormat pictureFormat(const ParameterValues& values, const std::filesystem::path& out)
{
    const std::optional<int> bits = values[pictureTable().sixteenBit] ? std::optional(16) : std::nullopt;
    if (const auto format = render::writtenFormat(out, bits)) return *format;
    if (render::writtenFormat(out))
        throw Failure(ErrorKind::usage, out.string() +
                                            ": this format does not support 16 bits; give a name that ends in " +
                                            render::writtenExtensions(bits) + ", or leave --sixteen-bit out.");
    throw Failure(ErrorKind::usage, out.string() + ": give a name that ends in " + render::writtenExtensions() + '.');
}

render::PictureMetadata pictureMetadata(const JobScene& scene, const PictureRequest& request)
{
    render::PictureMetadata metadata = exrMetadata(*scene.museum, request);
    const render::Camera* view = scene.frame.alone ? nullptr : &scene.state.camera;
    metadata.preset = pictureSettings(*scene.museum, scene.subject, scene.state, request, "Picture", view);
    return metadata;
}

std::unique_ptr<render::PartFile> stagedPicture(const JobScene& scene, const PictureRequest& request,
                                                const ParameterValues& values, const std::filesystem::path& out,
                                                const render::Image& picture)
{
    const render::PictureMetadata metadata = pictureMetadata(scene, request);
    if (isWebp(out)) return stagedWebp(out, picture, request.frame.transparent, metadata.preset);
    return render::stagedPicture(out, picture, pictureFormat(values, out), metadata);
}

PictureRun::PictureRun(JobOrder order)
    : order_(std::move(order)), request_(pictureRequest(order_.values, order_.scene, order_.out))
{
    request_.largestTile = order_.largestTile;
}

JobRun::Next PictureRun::next() const
{
    return isDone_ ? Next::done : Next::draw;
}

double PictureRun::progress() const
{
    return maker_ ? maker_->progress() : isDone_ ? 1 : 0;
}

void PictureRun::step(const Watch&)
{
    if (!maker_) begin();
    if (!maker_->step() || maker_->finished()) end();
}

void PictureRun::begin()
{
    backend_ = order_.backend ? order_.backend() : nullptr;
    if (!backend_) throw Failure(ErrorKind::openGl, "No picture can be made: there is no graphics context.");
    maker_ = std::make_unique<PictureMaker>(*order_.scene.museum, *backend_, order_.scene.state, request_);
}

void PictureRun::end()
{
    for (const render::CulledPass& complaint : render::Diagnostics().begun(maker_->report().skipped))
        report_.warnings.push_back(render::lineOf(complaint));
    report_.facts = factsOf(request_);
    const JobScene& scene = order_.scene;
    if (!order_.out.empty()) {
        staged_.push_back(stagedPicture(scene, request_, order_.values, order_.out, maker_->picture()));
        report_.files.push_back(order_.out);
    } else {
        picture_ = maker_->picture();
    }
    if (order_.frameReport) {
        staged_.push_back(render::stagedFile(order_.reportFile,
                                             render::writeJson(order_.frameReport(scene, request_, maker_->report()))));
        report_.files.push_back(order_.reportFile);
    }
    maker_.reset();
    backend_.reset();
    isDone_ = true;
}

void PictureRun::publish()
{
    render::publishAll(staged_);
}

const Parameters& PictureJob::parameters() const
{
    return pictureTable();
}

JobNeeds PictureJob::needs() const
{
    return {.anyScene = true,
            .extensions = pictureEndings(),
            .inWindow = true,
            .report = "File for the frame report as JSON: passes that ran, passes that were skipped and why, counters, "
                      "times, memory by owner",
            .carriesSettings = true,
            .preview = PreviewForm::picture};
}

std::shared_ptr<const JobInputs> PictureJob::read(const ParameterValues&) const
{
    return std::make_shared<JobInputs>();
}

JobPlan PictureJob::plan(const ParameterValues& values, const JobScene& scene, const JobInputs&,
                         const std::filesystem::path& out) const
{
    JobPlan plan;
    plan.offers["channels"] = {"color",
                               "color,depth",
                               "color,normal",
                               "color,albedo,normal",
                               "color,depth,normal,position,object",
                               "color,depth,normal,evaluations"};
    try {
        const PictureRequest request = pictureRequest(values, scene, out);
        plan.facts = factsOf(request);
        if (isWebp(out))
            plan.refusal = whyNoWebp(values, request);
        else if (!out.empty())
            static_cast<void>(pictureFormat(values, out));
        if (!values[pictureTable().transparent] || request.frame.alone || !scene.museum) {
        } else if (scene.subject == hallIndex) {
            plan.refusal = "The hall has nothing around it that could be left out; visit an exhibit first.";
        } else if (capability<OverFrame>(scene.museum->subject(scene.subject))) {
            plan.refusal = "This exhibit is made of light alone: there is nothing to cut out.";
        }
    } catch (const Failure& failure) {
        plan.refusal = failure.what();
    }
    if (!out.empty()) plan.files = {{out, "picture"}};
    return plan;
}

std::unique_ptr<JobRun> PictureJob::start(JobOrder order) const
{
    return std::make_unique<PictureRun>(std::move(order));
}

JobScene PictureJob::sceneFor(const ParameterValues& values, JobScene scene) const
{
    if (!scene.usual.widens) return scene;
    const glm::dvec2 size = sizeOf(values, scene);
    scene.frame.camera = widened(scene.frame.camera, size.x / size.y);
    scene.usual.widens = false;
    return scene;
}

double PictureJob::effort(const ParameterValues& values, const JobScene& scene) const
{
    const glm::dvec2 size = sizeOf(values, scene);
    return size.x * size.y * samplesOf(values, scene);
}

JobForecast PictureJob::forecast(const ParameterValues& values, const FinishedDraft& draft,
                                 const std::filesystem::path& out) const
{
    const auto& run = static_cast<const PictureRun&>(draft.run);
    // A draft has the color alone.
    if (!values[pictureTable().channels].empty()) return {};
    const glm::dvec2 size = sizeOf(values, run.scene()), drawn = run.request().frame.raster.size;
    try {
        const auto part = stagedPicture(run.scene(), run.request(), values, draftFile(out), run.picture());
        const auto bytes = static_cast<double>(std::filesystem::file_size(part->path()));
        return {{fileAbout(grownBytes(bytes, size.x * size.y / (drawn.x * drawn.y), out))}};
    } catch (const Failure&) {
        return {};  // The plan or the export says why nothing can be written.
    }
}

ParameterValues PictureJob::draft(const ParameterValues& values, const JobInputs&) const
{
    const PictureTable& t = pictureTable();
    ParameterValues small = values;
    const int width = values[t.width], height = values[t.height];
    shrinkTo(draftSide, {width, height}, small, t.width, t.height);
    if (width <= 0 && height <= 0) small.set(t.width, draftSide);
    small.set(t.samples, 1);
    small.set(t.channels, std::string());
    return small;
}

}  // namespace vitrine::jobs
