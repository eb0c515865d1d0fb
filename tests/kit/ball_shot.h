#pragma once

#include "tests/kit/ball/ball.h"
#include "tests/support/gallery.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace vitrine::test {

/// Shaders of an exhibit that is made in a test: its texts take the place of files.
inline std::shared_ptr<const render::ShaderSources> ballShaders()
{
    std::ifstream file(std::filesystem::path(VITRINE_SOURCE_DIR) / "tests/kit/ball/ball.glsl");
    return std::make_shared<render::ShaderSources>(
        std::map<std::string, std::string>{{"ball/ball.glsl", {std::istreambuf_iterator<char>(file), {}}}});
}

inline std::unique_ptr<Museum> museumOf(std::unique_ptr<Exhibit> exhibit)
{
    std::vector<std::unique_ptr<Exhibit>> list;
    list.push_back(std::move(exhibit));
    return std::make_unique<Museum>(std::move(list));
}

/// A museum in which the ball is alone, at the first place, where the sun reaches it.
inline const Museum& ballMuseum()
{
    static const auto opened = museumOf(std::make_unique<Ball>(1, ballShaders()));
    return *opened;
}
inline const BallTable& ballTable()
{
    static const BallTable table;
    return table;
}

/// A picture of that museum's exhibit: by default alone, linear, with depth and normals, from 2 m before it.
struct BallShot {
    const Museum& museum;
    SceneState sceneState;
    PictureRequest request;
    std::size_t subject = 0;

    explicit BallShot(const Museum& of = ballMuseum(), const char* exhibit = "ball")
        : museum(of), sceneState(of.initialSceneState()), subject(*of.find(exhibit))
    {
        useSmallMaps(hall(), 512);
        seeAlone(request, subject);
        FrameRequest& frame = request.frame;
        frame.raster.size = {96, 72};
        frame.camera = {{0, 0, 2}, {0, 0, 0}, 0.6};
    }
    [[nodiscard]] ParameterValues& hall() { return sceneState.hall(); }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[subject]; }
    BallShot& inHall()
    {
        request.frame.alone.reset();
        request.frame.subject = subject;
        request.frame.transparent = false;
        request.frame.camera = museum.bestView(subject, values());
        return *this;
    }
    [[nodiscard]] glm::dmat4 worldFromExhibit() const
    {
        return (request.frame.alone ? glm::dmat4(1) : museum.worldFromExhibit(subject)) *
               request.frame.exhibitTransform;
    }
    [[nodiscard]] Picture take() const
    {
        PictureMaker maker(museum, gallery().renderer, sceneState, request);
        while (maker.step()) {
        }
        return {maker.picture(), render::makeView(request.frame.camera, request.frame.raster)};
    }
};

/// Meters from a line to a point.
inline double distanceOf(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& point)
{
    return glm::length(glm::cross(point - origin, glm::normalize(direction)));
}

/// Through the middle of a pixel (from the top left), length 1 along the view axis.
inline glm::dvec3 rayThrough(const render::View& view, int x, int y)
{
    const glm::dvec2 size(view.raster.size);
    return view.direction(glm::dvec2(x + 0.5, size.y - y - 0.5) / size * 2.0 - 1.0);
}

}  // namespace vitrine::test
