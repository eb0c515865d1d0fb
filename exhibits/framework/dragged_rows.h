#pragma once

#include "exhibits/framework/prepare.h"
#include "render/scene/ray.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace vitrine {

/// A line in the picture that is dragged for the value of a row.
struct DraggedLine {
    std::size_t row = 0;
    glm::dvec3 from{0}, to{0};  ///< Own space, meters.
};

/// Has rows that are dragged in the picture, as the divider of two halves is.
class HasDraggedRows {
public:
    virtual ~HasDraggedRows() = default;
    /// The lines that there are with these values, as an eye (own space) sees them. Needs nothing prepared.
    [[nodiscard]] virtual std::vector<DraggedLine> draggedLines(const ExhibitState&, const glm::dvec3& eye) const = 0;
    /// The value with which the line of `row` lies under a ray from the eye (own space); it may be beyond the range.
    [[nodiscard]] virtual double valueUnder(const ExhibitState&, std::size_t row, const render::Ray&) const = 0;
};

}  // namespace vitrine
