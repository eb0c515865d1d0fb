#include "ui/viewport/parameter_drag.h"

#include "exhibits/framework/scene/dragged_parameters.h"
#include "ui/viewport/viewport.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr double grabLineWithin = 7;  ///< Pixels between pointer and line.

std::optional<QPointF> inWidget(const render::View& view, const QSizeF& widget, const glm::dvec3& world)
{
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
    if (clip.w <= 1e-9) return std::nullopt;
    return QPointF((0.5 + 0.5 * clip.x / clip.w) * widget.width(), (0.5 - 0.5 * clip.y / clip.w) * widget.height());
}

/// Returns the vector from p to the nearest point of the segment from a to b.
QPointF toStretch(const QPointF& p, const QPointF& a, const QPointF& b)
{
    const QPointF ab = b - a;
    const double t = QPointF::dotProduct(p - a, ab) / std::max(QPointF::dotProduct(ab, ab), 1e-12);
    return a + std::clamp(t, 0.0, 1.0) * ab - p;
}

}  // namespace

ParameterDrag::ParameterDrag(const Museum& museum, History& history, Viewport& viewport,
                             std::function<std::size_t()> chosen, QObject* parent)
    : QObject(parent), museum_(museum), history_(history), viewport_(viewport), chosen_(std::move(chosen))
{
    viewport.installEventFilter(this);
}

const HasDraggedParameters* ParameterDrag::source() const
{
    return capability<HasDraggedParameters>(museum_.subject(chosen_()));
}

std::optional<ParameterDrag::Drag> ParameterDrag::gripAt(const QPointF& at) const
{
    const HasDraggedParameters* source = this->source();
    if (!source) return std::nullopt;
    const std::size_t exhibit = chosen_();
    const ExhibitState state{history_.sceneState().values[exhibit], viewport_.clock().time()};
    const glm::dmat4 world = museum_.worldFromExhibit(exhibit);
    const render::View view = viewport_.scene().view();
    const glm::dvec3 eye(glm::inverse(world) * glm::dvec4(view.eye, 1));
    std::optional<Drag> found;
    double nearest = grabLineWithin;
    for (const DraggedLine& line : source->draggedLines(state, eye)) {
        const auto from = inWidget(view, QSizeF(viewport_.size()), glm::dvec3(world * glm::dvec4(line.from, 1)));
        const auto to = inWidget(view, QSizeF(viewport_.size()), glm::dvec3(world * glm::dvec4(line.to, 1)));
        if (!from || !to) continue;
        const QPointF off = toStretch(at, *from, *to);
        if (const double distance = std::hypot(off.x(), off.y()); distance < nearest) {
            nearest = distance;
            found = Drag{exhibit, line.row, off, 0};
        }
    }
    return found;
}

void ParameterDrag::drag(const QPointF& at)
{
    const HasDraggedParameters* source = this->source();
    if (!source || drag_->exhibit != chosen_()) return;
    const QPointF point = at + drag_->grip;
    const render::View view = viewport_.scene().view();
    const glm::dvec2 ndc(2 * point.x() / viewport_.width() - 1, 1 - 2 * point.y() / viewport_.height());
    const render::Ray ray{view.eye, glm::normalize(view.direction(ndc))};
    const ExhibitState state{history_.sceneState().values[drag_->exhibit], viewport_.clock().time()};
    const glm::dmat4 exhibitFromWorld = glm::inverse(museum_.worldFromExhibit(drag_->exhibit));
    history_.set(drag_->exhibit, drag_->row, source->valueUnder(state, drag_->row, ray.transformed(exhibitFromWorld)),
                 drag_->gesture);
}

bool ParameterDrag::hover(const QPointF& at)
{
    const bool near = gripAt(at).has_value();
    if (near)
        viewport_.setCursor(Qt::SizeAllCursor);
    else if (near_)
        viewport_.unsetCursor();
    near_ = near;
    return near;
}

bool ParameterDrag::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (mouse.button() != Qt::LeftButton) break;
        drag_ = gripAt(mouse.position());
        if (!drag_) break;
        drag_->gesture = newGesture();
        return true;
    }
    case QEvent::MouseMove: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (drag_)
            drag(mouse.position());
        else if (mouse.buttons() != Qt::NoButton || !hover(mouse.position()))
            break;
        return true;
    }
    case QEvent::MouseButtonRelease:
        if (!drag_) break;
        drag_.reset();
        return true;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace vitrine::ui

#include "moc_parameter_drag.cpp"
