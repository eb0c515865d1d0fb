#include "ui/viewport/picture_orders.h"

#include "exhibits/museum/picture_settings.h"
#include "ui/viewport/present_scene.h"

#include <utility>

namespace vitrine::ui {

PictureOrders::PictureOrders(const PresentScene& scene, RenderThread& thread) : scene_(scene), thread_(thread) {}

void PictureOrders::orderWhole(const DrawOrder& order)
{
    FrameRequest request = scene_.request();
    if (order.sample == 0)
        pictureTime_ = request.time;
    else
        request = scene_.request(pictureTime_);
    const double scale = order.scale * pictureQuality(scene_.state().hall()).resolutionScale;
    request.raster.size = glm::max(glm::ivec2(glm::round(glm::dvec2(request.raster.size) * scale)), glm::ivec2(1));
    request.mostExhibits = order.mostExhibits;
    request.resetHistory = std::exchange(cut_, false);
    request.sample = order.sample;
    request.samples = order.samples;
    if (!order.inMotion || request.resetHistory) motionFrames_ = 0;
    if (order.inMotion) ++motionFrames_;
    request.movingFrame = motionFrames_;
    underway_ = Underway::whole;
    sceneStateNumber_ = scene_.number();
    thread_.draw({scene_.state(), std::move(request), order, scene_.devicePixels(), std::nullopt});
}

void PictureOrders::orderRegion(const PictureRegion& region, int samples)
{
    underway_ = Underway::region;
    sceneStateNumber_ = scene_.number();
    thread_.draw({scene_.state(), scene_.request(), {1, 0, samples}, scene_.devicePixels(), region});
}

bool PictureOrders::drawsOldRegion() const
{
    return underway_ == Underway::region && sceneStateNumber_ != scene_.number();
}

void PictureOrders::noteArrival(const DrawnPicture& picture)
{
    underway_ = Underway::nothing;
    if (picture.abandoned || !picture.failure.isEmpty()) cut_ = cut_ || picture.order.request.resetHistory;
}

}  // namespace vitrine::ui
