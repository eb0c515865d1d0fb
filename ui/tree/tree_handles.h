#pragma once

#include "exhibits/framework/tree.h"
#include "render/scene/camera.h"

#include <QPointF>
#include <QSizeF>

#include <optional>
#include <vector>

namespace vitrine::ui {

enum class HandleMode { none, move, turn, scale };

/// Something to drag in the picture: one number of a place.
struct Handle {
    int axis = 0;               ///< 0 to 2: x, y, z.
    std::vector<QPointF> line;  ///< Pixels of the widget; the last point of a straight one bears the knob.
    /// By how many pixels its point moves for 1 of its number, by point of the line: meters, radians or a factor.
    std::vector<QPointF> perUnit;
};

/// The handles of a place: arrows along the axes in which it is moved or scaled, rings about the axes about which it is
/// turned. Those that point at the eye are left out.
[[nodiscard]] std::vector<Handle> handlesOf(HandleMode, const TreePlace&, const glm::dmat4& worldFromExhibit,
                                            const render::View&, const QSizeF& widget);

/// A handle that the pointer takes hold of, and at which point of its line.
struct Grip {
    std::size_t handle = 0, point = 0;
};
[[nodiscard]] std::optional<Grip> gripAt(const std::vector<Handle>&, const QPointF& pointer);

/// The place after the pointer moved by so many pixels from where it took hold: rounded to 0.1 mm, 0.01 degrees and
/// 0.0001.
[[nodiscard]] TreePlace dragged(HandleMode, const TreePlace& from, const Handle&, std::size_t point,
                                const QPointF& moved);

}  // namespace vitrine::ui
