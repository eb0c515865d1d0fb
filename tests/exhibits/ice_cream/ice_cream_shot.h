#pragma once

#include "exhibits/ice_cream/ice_cream_shape.h"
#include "tests/support/gallery.h"

namespace vitrine::test {

inline const IceCreamTable& iceCreamTable()
{
    static const IceCreamTable made;
    return made;
}

/// Shot of the ice cream alone. By default with the light, size and first view of the reference, static; linear, with
/// depth and normals. Its own space is then the world's, moved by `foot`.
struct IceCreamShot {
    SceneState sceneState = gallery().museum.initialSceneState();
    PictureRequest request;
    std::size_t subject = *gallery().museum.find("ice_cream");

    IceCreamShot()
    {
        useSmallMaps(sceneState.hall(), 256);
        values().set(iceCreamTable().lighting, IceCreamLighting::reference);
        values().set(iceCreamTable().size, 1.0);
        seeAlone(request, subject);
        FrameRequest& frame = request.frame;
        frame.raster.size = {196, 110};
        frame.camera = gallery().museum.exhibit(subject).bestView(values());
    }
    [[nodiscard]] ParameterValues& values() { return sceneState.values[subject]; }
    /// Returns the position of the wafer's foot: the camera's target is half a meter above it.
    [[nodiscard]] glm::dvec3 foot() const { return glm::dvec3(0, -0.62, -0.2); }
    /// Sets the camera in the reference's space.
    IceCreamShot& see(const glm::dvec3& eye, const glm::dvec3& target, double fovY = 0.9272952180016122)
    {
        request.frame.camera = {foot() + eye, foot() + target, fovY};
        return *this;
    }
    IceCreamShot& size(int width, int height)
    {
        request.frame.raster.size = {width, height};
        return *this;
    }
    [[nodiscard]] Picture take() const
    {
        PictureMaker maker(gallery().museum, gallery().renderer, sceneState, request);
        while (maker.step()) {
        }
        return {maker.picture(), render::makeView(request.frame.camera, request.frame.raster)};
    }
    /// Returns the surface point of a pixel in the reference's space.
    [[nodiscard]] glm::dvec3 pointAt(const Picture& p, int x, int y) const
    {
        const glm::dvec2 raster(p.view.raster.size);
        const glm::dvec3 ray = p.view.direction(glm::dvec2(x + 0.5, raster.y - y - 0.5) / raster * 2.0 - 1.0);
        return p.view.eye + ray * p.depth(x, y) - foot();
    }
};

}  // namespace vitrine::test
