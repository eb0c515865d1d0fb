#pragma once

#include "exhibits/framework/scene/tree.h"
#include "render/scene/camera.h"

#include <QPointF>
#include <QSizeF>

#include <optional>
#include <vector>

namespace vitrine::ui {

enum class HandleMode { none, move, turn, scale };

/// Handle in the picture: drags one number of a place.
struct Handle {
    int axis = 0;               ///< Axis, 0 to 2: x, y, z.
    std::vector<QPointF> line;  ///< Line in pixels of the widget. The last point of a straight one has the knob.
    /// For each point of the line, its movement in pixels if the number grows by 1. The number is in meters, radians or
    /// a factor.
    std::vector<QPointF> perUnit;
};

/// Returns the handles of a place: arrows along the axes of moving or scaling, or rings about the axes of turning.
/// Handles that point at the eye are left out.
[[nodiscard]] std::vector<Handle> handlesOf(HandleMode, const TreePlace&, const glm::dmat4& worldFromExhibit,
                                            const render::View&, const QSizeF& widget);

/// Handle under the pointer, and the point of its line.
struct Grip {
    std::size_t handle = 0, point = 0;
};
[[nodiscard]] std::optional<Grip> gripAt(const std::vector<Handle>&, const QPointF& pointer);

/// Returns the place after the pointer moved by this many pixels. Rounded to 0.1 mm, 0.01 degrees, or a factor of
/// 0.0001.
[[nodiscard]] TreePlace dragged(HandleMode, const TreePlace& from, const Handle&, std::size_t point,
                                const QPointF& moved);

}  // namespace vitrine::ui
