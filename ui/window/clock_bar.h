#pragma once

#include <QTimer>
#include <QWidget>

class QAction;
class QToolButton;

namespace vitrine::ui {

class NumberField;
class Viewport;

/// Bar of the exhibits' clock: a button that stops and starts it, and the time in seconds, which is typed, dragged and
/// stepped like any number. The time is updated a few times a second while it passes.
class ClockBar final : public QWidget {
    Q_OBJECT

public:
    /// `pause` is checked while the clock is stopped. Both must outlive the bar.
    ClockBar(Viewport&, QAction& pause, QWidget* parent = nullptr);

private:
    void showState();
    void showTime();

    Viewport& viewport_;
    QAction& pause_;
    QToolButton* button_;
    NumberField* time_;
    QTimer timer_;
};

}  // namespace vitrine::ui
