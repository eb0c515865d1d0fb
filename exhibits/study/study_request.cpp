// The pictures that a study asks for: at rest, or in motion where that is what is studied.
#include "exhibits/study/study.h"

#include <algorithm>
#include <cmath>

namespace vitrine {
namespace {

// Of pictures in motion: the camera turns by so many pixels from frame to frame, not a whole number, so that what was
// drawn is never found again texel for texel; and what is seen after more frames than any history is long.
constexpr double turnPerFrame = 2.3;
constexpr int framesOfMotion = 24;

/// `pixels` to the left of where the camera looks, about its own upright axis; those in the middle of the picture.
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
        return a.subject == hallIndex && rowOf(request_.sceneState, a).name == supersamplesRow;
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
    if (const auto row = hall.table().find(supersamplesRow))
        request.samples = static_cast<int>(hall.rows()[*row].qualityReference.value_or(64));
    return request;
}

}  // namespace vitrine
