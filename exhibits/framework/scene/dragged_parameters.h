#pragma once

#include "exhibits/framework/scene/prepare.h"
#include "render/scene/ray.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace vitrine {

/// Line in the picture that the user drags to change a parameter.
struct DraggedLine {
    std::size_t row = 0;
    glm::dvec3 from{0}, to{0};  ///< Own space, meters.
};

/// Capability: parameters that are dragged in the picture, for example the divider of two halves.
class HasDraggedParameters {
public:
    virtual ~HasDraggedParameters() = default;
    /// Returns the lines for these values, as seen from the eye (own space). Needs no prepared state.
    [[nodiscard]] virtual std::vector<DraggedLine> draggedLines(const ExhibitState&, const glm::dvec3& eye) const = 0;
    /// Returns the value that puts the line of `row` under a ray from the eye (own space). It may exceed the range.
    [[nodiscard]] virtual double valueUnder(const ExhibitState&, std::size_t row, const render::Ray&) const = 0;
};

}  // namespace vitrine
