#pragma once

#include <QWidget>

class QDockWidget;
class QMenu;

namespace vitrine::ui {

/// Title bar of a dock: its name, a menu that moves and resizes it, and a button that closes it. Dragging it moves the
/// dock; a right click opens the menu.
class DockTitle final : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget* dock);

    [[nodiscard]] QMenu& menu() const { return *menu_; }

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent*) override;
    void contextMenuEvent(QContextMenuEvent*) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

private:
    void addMoves();
    void showTheme();

    QDockWidget* dock_;
    QMenu* menu_;
};

}  // namespace vitrine::ui
