#pragma once

#include "ui/model/history.h"

#include <QObject>
#include <QPointF>

#include <functional>
#include <optional>

namespace vitrine {
class HasDraggedParameters;
}

namespace vitrine::ui {

class Viewport;

/// Dragging of parameters of the visited exhibit in the picture (`HasDraggedParameters`). One drag is one undo step.
class ParameterDrag final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. `chosen` returns the exhibit that is visited.
    ParameterDrag(const Museum&, History&, Viewport&, std::function<std::size_t()> chosen, QObject* parent);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    struct Drag {
        std::size_t exhibit = 0, row = 0;
        QPointF grip;  ///< Vector from the pointer to the line when the drag began, in pixels.
        Gesture gesture = 0;
    };
    [[nodiscard]] const HasDraggedParameters* source() const;
    /// Returns the parameter whose line is near the pointer, with its offset.
    [[nodiscard]] std::optional<Drag> gripAt(const QPointF&) const;
    void drag(const QPointF&);
    bool hover(const QPointF&);

    const Museum& museum_;
    History& history_;
    Viewport& viewport_;
    std::function<std::size_t()> chosen_;
    std::optional<Drag> drag_;
    bool near_ = false;
};

}  // namespace vitrine::ui
