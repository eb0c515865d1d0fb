#include "exhibits/museum/picture_settings.h"

#include "render/text/translation.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace vitrine {

PictureRecord pictureRecord(const PictureRequest& request, const render::Camera& ofExhibition)
{
    const FrameRequest& frame = request.frame;
    PictureRecord record;
    record.size = frame.raster.size;
    record.samples = request.samples;
    record.time = frame.time;
    record.seed = frame.seed;
    record.alone = frame.alone.has_value();
    record.transparent = frame.transparent;
    record.depth = request.depth;
    record.position = request.position;
    record.objects = request.objects;
    record.motion = request.before.has_value();
    record.before = request.before;
    record.channels = frame.channels;
    record.exhibitTransform = frame.exhibitTransform;
    if (!(frame.camera == ofExhibition)) record.camera = frame.camera;
    record.language = language();
    return record;
}

render::Camera widened(const render::Camera& camera, double aspect)
{
    constexpr double widest = 2.6;  // Radians. A wider field of view distorts too much.
    if (!(aspect > 0) || aspect >= keptAspect) return camera;
    render::Camera wide = camera;
    wide.fovY = std::max(camera.fovY, std::min(2 * std::atan(std::tan(camera.fovY / 2) * keptAspect / aspect), widest));
    return wide;
}

int usualSamples(const ParameterValues& hall)
{
    const std::optional<std::size_t> row = hall.table().find(supersamplesParameter);
    return row && !hall.isInitial(*row) ? pictureQuality(hall).supersamples : 4;
}

std::string pictureSettings(const Museum& museum, std::size_t subject, const SceneState& sceneState,
                            const PictureRequest& request, const std::string& name, const render::Camera* view)
{
    const FrameRequest& frame = request.frame;
    Exhibition exhibition{name, namedValues(museum.subjects(), sceneState.values), frame.camera};
    if (view)
        exhibition.camera = *view;
    else if (frame.alone)
        exhibition.camera = frame.camera.transformed(museum.worldFromExhibit(*frame.alone));
    exhibition.chosen = std::string(museum.subject(subject).name());
    exhibition.picture = pictureRecord(request, exhibition.camera);
    return exhibitionText(exhibition);
}

}  // namespace vitrine
