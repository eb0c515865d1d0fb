#include "exhibits/museum/shown_pictures.h"

#include "exhibits/museum/museum.h"

#include <utility>

namespace vitrine {

void offerPictures(const std::vector<std::unique_ptr<Exhibit>>& exhibits)
{
    for (const auto& shower : exhibits) {
        auto* shows = dynamic_cast<ShowsPictures*>(shower.get());
        if (!shows) continue;
        std::vector<PictureSource> sources{
            {hallAtFirst, "hall"}, {hallFromHere, "hall from here"}, {hallFromScreen, "hall from the screen"}};
        for (const auto& each : exhibits)
            if (each != shower) sources.push_back({std::string(each->name()), std::string(each->title())});
        shows->offerPictures(std::move(sources));
    }
}

std::optional<FrameRequest> requestOfPicture(const Museum& museum, const SceneState& sceneState,
                                             const FrameRequest& request, std::size_t by, const std::string& source)
{
    const auto* shows = capability<ShowsPictures>(museum.subject(by));
    if (!shows) return std::nullopt;
    FrameRequest wanted;
    wanted.raster.size = shows->pictureSize(sceneState.values[by], request.alone ? std::optional(request.raster.size)
                                                                                 : std::optional<glm::ivec2>());
    wanted.time = request.time;
    wanted.seed = request.seed;
    wanted.sincePressed = request.sincePressed;
    wanted.runEverything = request.runEverything;
    wanted.idle = request.idle;
    wanted.finished = request.finished;
    wanted.resetHistory = true;
    if (source == hallFromHere) {
        wanted.camera =
            request.alone ? request.camera.transformed(museum.worldFromExhibit(*request.alone)) : request.camera;
        return wanted;
    }
    if (source == hallFromScreen) {
        // 1 cm in front of the exhibit's bounds, so that none of it is in the way.
        const render::Box box = museum.subject(by).bounds(sceneState.values[by]);
        const glm::dvec3 eye(box.center().x, box.center().y, box.high.z + 0.01);
        const render::Camera out{.eye = eye, .target = eye + glm::dvec3(0, 0, 1)};
        wanted.camera = out.transformed(museum.worldFromExhibit(by));
        return wanted;
    }
    const std::optional<std::size_t> of = museum.find(source);
    if (!of || *of == by) return std::nullopt;
    if (*of != hallIndex) wanted.alone = *of;
    wanted.camera = museum.subject(*of).bestView(sceneState.values[*of]);
    return wanted;
}

}  // namespace vitrine
