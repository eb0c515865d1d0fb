#pragma once

#include <QWidget>

namespace vitrine::ui {

/// Cross in the middle of the picture, where Enter and E act. It appears with a key that moves the camera or acts, and
/// leaves when the mouse is used or the picture loses the focus.
class Crosshair final : public QWidget {
    Q_OBJECT

public:
    /// Filters the events of `viewport`, over which it lies.
    explicit Crosshair(QWidget& viewport);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void placeInMiddle();
};

}  // namespace vitrine::ui
