#include "ui/tree/tree_outline.h"

#include <QRectF>

#include <glm/gtc/matrix_inverse.hpp>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr int halvings = 3;

/// Returns the part of the widget that can contain the shape.
QRectF partOf(const TreeShape& shape, const render::View& view, const glm::dmat4& worldFromExhibit,
              const QSizeF& widget)
{
    const QRectF whole(QPointF(0, 0), widget);
    QRectF part;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 own((corner & 1) != 0 ? shape.box.high.x : shape.box.low.x,
                             (corner & 2) != 0 ? shape.box.high.y : shape.box.low.y,
                             (corner & 4) != 0 ? shape.box.high.z : shape.box.low.z);
        if (!std::isfinite(own.x) || !std::isfinite(own.y) || !std::isfinite(own.z)) return whole;
        const auto at = onScreen(view, widget, glm::dvec3(worldFromExhibit * glm::dvec4(own, 1)));
        if (!at) return whole;
        const QRectF point(*at, QSizeF(1e-9, 1e-9));
        part = corner == 0 ? point : part.united(point);
    }
    return part.adjusted(-2 * outlineCell, -2 * outlineCell, 2 * outlineCell, 2 * outlineCell).intersected(whole);
}

/// Marching squares (Lorensen and Cline 1987, in the plane) over the hits of rays.
class Contour {
public:
    Contour(const TreeShape& shape, const render::View& view, const glm::dmat4& worldFromExhibit, const QSizeF& widget)
        : shape_(shape), view_(view), exhibitFromWorld_(glm::affineInverse(worldFromExhibit)), widget_(widget),
          part_(partOf(shape, view, worldFromExhibit, widget)),
          columns_(static_cast<int>(std::ceil(part_.width() / outlineCell))),
          rows_(static_cast<int>(std::ceil(part_.height() / outlineCell)))
    {
    }

    std::vector<QLineF> lines(const std::function<bool()>& goesOn)
    {
        std::vector<QLineF> found;
        std::vector<char> above, here;
        for (int row = 0; row <= rows_ && !part_.isEmpty(); ++row) {
            if (!goesOn()) return {};
            here.assign(static_cast<std::size_t>(columns_) + 1, 0);
            for (int column = 0; column <= columns_; ++column)
                here[static_cast<std::size_t>(column)] = isHit(at(column, row));
            for (int column = 0; row > 0 && column < columns_; ++column)
                addCell(above.data() + column, here.data() + column, column, row - 1, found);
            above = here;
        }
        return found;
    }

private:
    [[nodiscard]] QPointF at(double column, double row) const
    {
        return {std::min(part_.left() + column * outlineCell, part_.right()),
                std::min(part_.top() + row * outlineCell, part_.bottom())};
    }
    [[nodiscard]] char isHit(const QPointF& p) const
    {
        const glm::dvec2 ndc(2 * p.x() / widget_.width() - 1, 1 - 2 * p.y() / widget_.height());
        return shape_.isHit(render::Ray{view_.eye, view_.direction(ndc)}.transformed(exhibitFromWorld_)) ? 1 : 0;
    }
    /// Returns a contour point between one that hits the shape and one that misses it, by bisection.
    [[nodiscard]] QPointF edge(QPointF hit, QPointF missed) const
    {
        for (int i = 0; i < halvings; ++i) {
            const QPointF middle = (hit + missed) / 2;
            (isHit(middle) ? hit : missed) = middle;
        }
        return (hit + missed) / 2;
    }
    void addCell(const char* above, const char* below, int column, int row, std::vector<QLineF>& found) const
    {
        const QPointF corners[4] = {at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)};
        const char hit[4] = {above[0], above[1], below[1], below[0]};
        std::vector<QPointF> crossings;
        for (int i = 0; i < 4; ++i) {
            const int j = (i + 1) % 4;
            if (hit[i] != hit[j])
                crossings.push_back(hit[i] ? edge(corners[i], corners[j]) : edge(corners[j], corners[i]));
        }
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) found.emplace_back(crossings[i], crossings[i + 1]);
    }

    const TreeShape& shape_;
    const render::View& view_;
    glm::dmat4 exhibitFromWorld_;
    QSizeF widget_;
    QRectF part_;
    int columns_, rows_;
};

}  // namespace

std::optional<QPointF> onScreen(const render::View& view, const QSizeF& widget, const glm::dvec3& world)
{
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
    if (!(clip.w > 1e-9)) return std::nullopt;
    return QPointF((0.5 + 0.5 * clip.x / clip.w) * widget.width(), (0.5 - 0.5 * clip.y / clip.w) * widget.height());
}

std::vector<QLineF> outlineOf(const TreeShape& shape, const render::View& view, const glm::dmat4& worldFromExhibit,
                              const QSizeF& widget, const std::function<bool()>& goesOn)
{
    return Contour(shape, view, worldFromExhibit, widget).lines(goesOn);
}

}  // namespace vitrine::ui
