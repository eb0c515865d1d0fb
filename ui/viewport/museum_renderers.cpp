#include "ui/viewport/museum_renderers.h"

#include "exhibits/framework/scene/glare.h"
#include "render/gl/machine_json.h"
#include "ui/viewport/render_thread.h"

#include <cassert>

namespace vitrine::ui {
namespace {

constexpr int regionApron = 8;  ///< Pixels drawn around a region, for effects that read neighboring pixels.
constexpr double longestStrangersFrame = 4;  ///< Seconds.
constexpr double oldAsset = 10;              ///< Seconds without use, before the last picture.

QImage imageOf(const render::gl::ScreenPixels& pixels)
{
    return QImage(pixels.rgba.data(), pixels.width, pixels.height, pixels.width * 4, QImage::Format_RGBX8888).copy();
}

/// Returns the renderer's last picture, scaled to this many device pixels.
QImage screenImageOf(render::gl::Renderer& renderer, const QSize& screen)
{
    const glm::ivec2 size(screen.width(), screen.height());
    return imageOf(renderer.screenPixels("frame", size, glm::ivec2(0), size));
}

/// Returns another renderer on the same context for a task, which stops between two passes when it is canceled.
std::unique_ptr<render::gl::Renderer> taskRendererOf(const render::gl::Renderer& renderer)
{
    std::unique_ptr<render::gl::Renderer> sibling = renderer.sibling();
    sibling->abandonWhen(&RenderThread::isTaskCanceled);
    return sibling;
}

/// Returns another renderer on the same context, under the same limit.
std::unique_ptr<render::gl::Renderer> siblingOf(const render::gl::Renderer& renderer)
{
    std::unique_ptr<render::gl::Renderer> sibling = renderer.sibling();
    sibling->stopUnboundedAfter(longestStrangersFrame);
    return sibling;
}

}  // namespace

void MuseumRenderers::open()
{
    museum_.startReading();
#ifdef NDEBUG
    context_ = std::make_unique<render::gl::HeadlessContext>();
#else
    context_ = std::make_unique<render::gl::HeadlessContext>(true);
    debugLog_ = std::make_unique<render::gl::DebugLog>();
#endif
    renderer_ = std::make_unique<render::gl::Renderer>();
    renderer_->buildInBackground(context_->shared());
    renderer_->stopUnboundedAfter(longestStrangersFrame);
    renderer_->timeSteps(timeSteps_);
    computeAhead();
}

void MuseumRenderers::computeAhead() const
{
    FrameRequest request;
    request.nonBlocking = true;
    (void)museum_.plan(museum_.prepare(museum_.initialSceneState(), request), request);
}

void MuseumRenderers::close()
{
    other_.reset();
    small_.reset();
    regions_.reset();
    renderer_.reset();
    if (debugLog_ && !debugLog_->errors().empty()) qWarning("OpenGL: %s", debugLog_->errors().c_str());
    debugLog_.reset();
    context_.reset();
}

render::FrameReport MuseumRenderers::draw(const SceneState& sceneState, const FrameRequest& request,
                                          const IsCanceled& isCanceled)
{
    assert(renderer_);
    renderer_->abandonWhen(isCanceled);
    const render::FramePlan plan =
        museum_.plan(museum_.prepare(sceneState, request), request, renderer_->persistentState());
    hasHalos_ = plan.find(glareSpreadPass) != nullptr;
    halos_ = nullptr;
    halosPicture_ = request.raster.size;
    return renderer_->draw(plan);
}

QImage MuseumRenderers::screenImage(const QSize& screen)
{
    return screenImageOf(*renderer_, screen);
}

OtherDrawn MuseumRenderers::drawOther(const SceneState& sceneState, const FrameRequest& request, const QSize& screen)
{
    if (!other_) {
        other_ = siblingOf(*renderer_);
        other_->timeSteps(timeSteps_);
    }
    OtherDrawn drawn;
    drawn.report = other_->draw(museum_.plan(museum_.prepare(sceneState, request), request, other_->persistentState()));
    drawn.image = screenImageOf(*other_, screen);
    return drawn;
}

QImage MuseumRenderers::drawSmall(const SceneState& sceneState, const FrameRequest& request, const QSize& screen)
{
    if (!small_) small_ = siblingOf(*renderer_);
    (void)small_->draw(museum_.plan(museum_.prepare(sceneState, request), request, small_->persistentState()));
    return screenImageOf(*small_, screen);
}

QImage MuseumRenderers::drawRegion(const SceneState& sceneState, const FrameRequest& request,
                                   const PictureRegion& region, int samples, const IsCanceled& isCanceled)
{
    if (!regions_) regions_ = siblingOf(*renderer_);
    regions_->abandonWhen(isCanceled);
    FrameRequest frame = request;
    const glm::ivec2 low = glm::max(region.offset - regionApron, glm::ivec2(0));
    frame.raster.offset = low;
    frame.raster.tile = glm::min(region.offset + region.size + regionApron, request.raster.size) - low;
    frame.samples = samples;
    if (hasHalos_ && !halos_) halos_ = halosOf(renderer_->read(glareSpreadImage), halosPicture_);
    frame.halos = halos_;
    const Prepared prepared = museum_.prepare(sceneState, frame);
    for (frame.sample = 0; frame.sample < samples; ++frame.sample)
        (void)regions_->draw(museum_.plan(prepared, frame, regions_->persistentState()));
    const glm::ivec2 within = region.offset - low;
    const QImage drawn = imageOf(regions_->screenPixels("frame", request.raster.size, low, frame.raster.tile));
    return drawn.copy(within.x, frame.raster.tile.y - within.y - region.size.y, region.size.x, region.size.y);
}

void MuseumRenderers::releaseUnused()
{
    regions_.reset();
    halos_ = nullptr;
    museum_.assets().dropUnused(oldAsset);
    if (renderer_) renderer_->sweep();
}

render::Image MuseumRenderers::shownPicture()
{
    render::Image picture = renderer_->read("frame");
    picture.channelNames = {"R", "G", "B", "A"};
    return picture;
}

std::vector<render::gl::Stored> MuseumRenderers::stored() const
{
    return renderer_ ? renderer_->stored() : std::vector<render::gl::Stored>();
}

void MuseumRenderers::buildBetter(const SceneState& sceneState, const FrameRequest& request)
{
    renderer_->buildBetter(museum_.plan(museum_.prepare(sceneState, request), request, renderer_->persistentState()));
}

void MuseumRenderers::timeSteps(bool on)
{
    timeSteps_ = on;
    for (const auto* renderer : {&renderer_, &other_})
        if (*renderer) (*renderer)->timeSteps(on);
}

bool MuseumRenderers::reloadChangedShaders()
{
    return renderer_ && renderer_->reloadChangedShaders();
}

std::vector<render::gl::ShaderProblem> MuseumRenderers::problems() const
{
    return renderer_ ? renderer_->problems() : std::vector<render::gl::ShaderProblem>();
}

PictureJob MuseumRenderers::makePicture(const SceneState& sceneState, const PictureRequest& request)
{
    PictureJob job;
    job.renderer = taskRendererOf(*renderer_);
    nextPicture(job, sceneState, request);
    return job;
}

void MuseumRenderers::nextPicture(PictureJob& job, const SceneState& sceneState, const PictureRequest& request)
{
    job.maker = std::make_unique<PictureMaker>(museum_, *job.renderer, sceneState, request);
}

StudyJob MuseumRenderers::makeStudy(const study::StudyRequest& request)
{
    StudyJob job;
    job.backend = taskRendererOf(*renderer_);
    job.study = std::make_unique<study::Study>(museum_, *job.backend, request);
    job.machine = machine();
    return job;
}

render::Json MuseumRenderers::machine() const
{
    return render::gl::machineJson(context_->info());
}

std::unique_ptr<render::RenderBackend> MuseumRenderers::makeBackend(bool timesSteps)
{
    std::unique_ptr<render::gl::Renderer> made = taskRendererOf(*renderer_);
    made->timeSteps(timesSteps);
    return made;
}

}  // namespace vitrine::ui
