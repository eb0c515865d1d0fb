#pragma once

#include "exhibits/fur/coat.h"
#include "tests/support/gallery.h"

namespace vitrine::test {

inline const FurTable& table()
{
    static const FurTable made;
    return made;
}

/// Shot of the furry bodies alone: transparent, with depth and normals.
struct FurShot : Shot {
    FurShot()
    {
        sdf = *gallery().museum.find("fur");
        request.frame.alone = sdf;
        request.frame.camera = gallery().museum.subject(sdf).bestView(object());
        size(128, 80);
    }
    FurShot& shells(int count, FurSilhouette silhouette, FurOrder order = FurOrder::outerFirst)
    {
        object().set(table().shellCount, count);
        object().set(table().silhouette, silhouette);
        object().set(table().drawOrder, order);
        object().set(table().levelOfDetail, false);
        return *this;
    }
    FurShot& reference()
    {
        shells(256, FurSilhouette::march);
        object().set(table().samplesBetween, 32);
        return *this;
    }
    FurShot& hand(const glm::dvec3& tipOffset, double turn)
    {
        object().set(table().byHand, true);
        object().set(table().handX, tipOffset.x);
        object().set(table().handY, tipOffset.y);
        object().set(table().handZ, tipOffset.z);
        object().set(table().handRotation, turn);
        return *this;
    }
    [[nodiscard]] std::int64_t samplesPassed() const
    {
        PictureMaker maker(gallery().museum, gallery().renderer, sceneState, request);
        while (maker.step()) {
        }
        return maker.report().counters.at("samples");
    }
};

}  // namespace vitrine::test
