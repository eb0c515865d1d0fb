#pragma once

#include <QTimer>
#include <QWidget>

class QAction;
class QToolButton;

namespace vitrine::ui {

class NumberField;
class Viewport;

/// The exhibits' clock: a button that stops and starts it, and its time in seconds, which is typed, dragged and stepped
/// like any number of a panel. The time is renewed a few times a second while it passes, and not at all while it rests.
class ClockBar final : public QWidget {
    Q_OBJECT

public:
    /// `pause` is checked while the clock rests. Both must outlive it.
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
