#pragma once

#include "exhibits/ice_cream/ice_cream_shape.h"
#include "tests/exhibits/ice_cream/reference_shape.h"
#include "tests/support/gallery.h"

namespace vitrine::test {

/// Shot of the ice cream alone. By default with the light, shape, size and first view of the reference, static;
/// linear, with depth and normals. Its own space is then the world's, moved by `foot`.
struct IceCreamShot : ExhibitShot<ice_cream::IceCreamTable> {
    IceCreamShot() : ExhibitShot("ice_cream")
    {
        useSmallMaps(hall(), 256);
        set(table().lighting, ice_cream::IceCreamLighting::reference).set(table().size, 1.0);
        set(table().creamRoughness, 0.25);
        setReferenceShape(table(), values());
        request.frame.camera = museum.get().exhibit(exhibit).bestView(values());
        size(196, 110);
    }
    /// Returns the position of the wafer's foot: the camera's target is half a meter above it.
    [[nodiscard]] glm::dvec3 foot() const { return glm::dvec3(0, -0.62, -0.2); }
    /// Sets the camera in the reference's space.
    IceCreamShot& from(const glm::dvec3& eye, const glm::dvec3& target, double fovY = 0.9272952180016122)
    {
        request.frame.camera = {foot() + eye, foot() + target, fovY};
        return *this;
    }
    /// Returns the surface point of a pixel in the reference's space.
    [[nodiscard]] glm::dvec3 pointAt(const Picture& p, int x, int y) const
    {
        return p.view.eye + p.ray(x, y) * p.depth(x, y) - foot();
    }
};

}  // namespace vitrine::test
