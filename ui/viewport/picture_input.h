#pragma once

#include "ui/model/history.h"

#include <QObject>
#include <QPointF>

#include <cstddef>
#include <functional>
#include <optional>
#include <set>

class QKeyEvent;

namespace vitrine {
class TakesInput;
struct ExhibitState;
enum class PointerEvent : std::uint8_t;
namespace render {
struct Ray;
}
}  // namespace vitrine

namespace vitrine::ui {

class Viewport;

/// Pointer and keys for a picture in the visited exhibit that reads them (`TakesInput`). One drag is one undo step, and
/// so are all keys until the picture loses the focus. Escape, and keys with Ctrl, Alt or Meta, stay with the window.
class PictureInput final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. `chosen` returns the exhibit that is visited.
    PictureInput(const Museum&, History&, Viewport&, std::function<std::size_t()> chosen, QObject* parent);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    struct Drag {
        std::size_t exhibit = 0, grip = 0;
        QPointF last;
        Gesture gesture = 0;
    };
    [[nodiscard]] const TakesInput* source() const;
    [[nodiscard]] ExhibitState state(std::size_t exhibit) const;
    [[nodiscard]] render::Ray rayAt(std::size_t exhibit, const QPointF&) const;
    [[nodiscard]] bool takesKey(const QKeyEvent&) const;
    bool press(const QPointF&);
    bool point(const QPointF&, PointerEvent);
    bool key(const QKeyEvent&, bool isDown);
    void letGo();

    const Museum& museum_;
    History& history_;
    Viewport& viewport_;
    std::function<std::size_t()> chosen_;
    std::optional<Drag> drag_;
    std::set<int> held_;  ///< Codes of the keys that are held.
    std::size_t keyed_ = 0;
    Gesture typing_ = 0;
};

}  // namespace vitrine::ui
