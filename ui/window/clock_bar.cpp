#include "ui/window/clock_bar.h"

#include "ui/kit/menu_text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/shown_text.h"
#include "ui/viewport/viewport.h"

#include <QAction>
#include <QHBoxLayout>
#include <QToolButton>

namespace vitrine::ui {
namespace {

constexpr int renewedAfter = 200;  // Milliseconds.

/// Table with the time, so that it is typed, stepped and dragged like any number.
struct ClockParameters final : Parameters {
    Real time = real("time", 0, second, Range{0, ExhibitClock::latest}.soft(0, 60),
                     "Time of the exhibits' clock. Set it to show a certain moment.");
};

const ParameterInfo& timeParameter()
{
    static const ClockParameters rows;
    return rows.rows()[0];
}

}  // namespace

ClockBar::ClockBar(Viewport& viewport, QAction& pause, QWidget* parent)
    : QWidget(parent), viewport_(viewport), pause_(pause), button_(new QToolButton(this)),
      time_(new NumberField(timeParameter(), this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->setSpacing(4);
    layout->addWidget(button_);
    layout->addWidget(time_);
    button_->setAutoRaise(true);
    button_->setFocusPolicy(Qt::TabFocus);
    button_->setAccessibleName(tr("Stop or start the clock"));
    connect(button_, &QToolButton::clicked, &pause_, &QAction::trigger);
    connect(&pause_, &QAction::changed, this, [this] {
        showState();
        timer_.start();  // Whether anything moves is known a moment later.
    });
    connect(&viewport_.pictures(), &ViewportPictures::drawn, this, &ClockBar::showState);
    connect(&viewport_, &Viewport::looked, this, &ClockBar::showState);
    growWidth(*time_, NumberField::usualWidth);
    time_->setAccessibleName(tr("Time of the clock"));
    time_->setToolTip(tooltipText(timeParameter()));
    connect(time_, &NumberField::edited, &viewport_.clock(), &ExhibitClock::set);
    timer_.setSingleShot(true);
    timer_.setInterval(renewedAfter);
    connect(&timer_, &QTimer::timeout, this, [this] {
        showTime();
        showState();
    });
    connect(&viewport_.clock(), &ExhibitClock::passed, this, [this] {
        if (!timer_.isActive()) timer_.start();
    });
    showState();
    showTime();
}

void ClockBar::showState()
{
    const bool waits = viewport_.clock().waits();
    button_->setText(pause_.isChecked() ? tr("Play") : waits ? tr("Waits") : tr("Pause"));
    button_->setToolTip(
        waits ? tr("The clock waits because nothing shown is moving; it continues when something moves.") +
                    QLatin1Char('\n') + tipWithKey(pause_)
              : tipWithKey(pause_));
}

void ClockBar::showTime()
{
    time_->showValue(viewport_.clock().time());
}

}  // namespace vitrine::ui

#include "moc_clock_bar.cpp"
