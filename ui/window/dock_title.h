#pragma once

#include <QWidget>

class QDockWidget;

namespace vitrine::ui {

/// Title bar of a dock: its name, and buttons that float and close it. Dragging it moves the dock.
class DockTitle final : public QWidget {
    Q_OBJECT

public:
    explicit DockTitle(QDockWidget* dock);

protected:
    void paintEvent(QPaintEvent*) override;
    void changeEvent(QEvent*) override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

private:
    void showTheme();

    QDockWidget* dock_;
};

}  // namespace vitrine::ui
