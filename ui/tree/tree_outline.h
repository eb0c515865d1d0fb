#pragma once

#include "exhibits/framework/scene/tree.h"
#include "render/scene/camera.h"

#include <QLineF>
#include <QSizeF>

#include <functional>
#include <optional>
#include <vector>

namespace vitrine::ui {

/// Projects a point of the world to a widget of this size; nullopt behind the eye.
[[nodiscard]] std::optional<QPointF> onScreen(const render::View&, const QSizeF& widget, const glm::dvec3& world);

/// Returns the contour of a shape as short lines in a widget that shows this view. Details smaller than `outlineCell`
/// pixels may be lost; lines are exact to an eighth of it. `goesOn` is polled; if it returns false, the result is
/// empty.
inline constexpr double outlineCell = 5;
[[nodiscard]] std::vector<QLineF> outlineOf(const TreeShape&, const render::View&, const glm::dmat4& worldFromExhibit,
                                            const QSizeF& widget, const std::function<bool()>& goesOn);

}  // namespace vitrine::ui
