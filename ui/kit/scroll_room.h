#pragma once

#include <QScrollArea>

class QDialog;

namespace vitrine::ui {

/// Scroll area without a frame. Its size hint is that of its content, limited by the screen. It can be made small.
class ScrollRoom final : public QScrollArea {
    Q_OBJECT

public:
    explicit ScrollRoom(QWidget* content, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool eventFilter(QObject*, QEvent*) override;
};

/// Puts the dialog's layout into a scroll area, for screens that are too small for it.
void scrollWhenTight(QDialog&);

/// Returns a new child of the parent: the content, which scrolls when the room is tight, above a bar that stays on the
/// screen, however small it is.
[[nodiscard]] QWidget* scrolledAboveBar(QWidget* content, QWidget* bar, QWidget* parent);

}  // namespace vitrine::ui
