#pragma once

#include "exhibits/fur/coat.h"
#include "tests/support/gallery.h"
#include "tests/support/tables.h"

namespace vitrine::test {

/// Shot of the furry bodies alone, on a bare floor: transparent, with depth and normals.
struct FurShot : ExhibitShot<fur::FurTable> {
    FurShot() : ExhibitShot("fur")
    {
        values().set(table().rugRadius, 0.0);
        size(128, 80);
    }
    FurShot& shells(int count, fur::FurSilhouette silhouette, fur::FurOrder order = fur::FurOrder::outerFirst)
    {
        values().set(table().shellCount, count);
        values().set(table().silhouette, silhouette);
        values().set(table().drawOrder, order);
        values().set(table().levelOfDetail, false);
        return *this;
    }
    FurShot& reference()
    {
        shells(256, fur::FurSilhouette::march);
        values().set(table().samplesBetween, 32);
        return *this;
    }
    /// Shows light as a display does without a film curve, whose contrast is not the coat's.
    FurShot& withoutFilm()
    {
        request.frame.averageIn = AverageIn::display;
        hall().set(hallTable().toneCurve, hall::ToneCurve::none);
        return *this;
    }
    FurShot& hand(const glm::dvec3& tipOffset, double turn)
    {
        values().set(table().byHand, true);
        values().set(table().handX, tipOffset.x);
        values().set(table().handY, tipOffset.y);
        values().set(table().handZ, tipOffset.z);
        values().set(table().handRotation, turn);
        return *this;
    }
    [[nodiscard]] std::int64_t samplesPassed() const { return take().report.counters.at("samples"); }
};

inline const fur::FurTable& furTable()
{
    return FurShot::table();
}

}  // namespace vitrine::test
