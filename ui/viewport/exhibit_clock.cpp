#include "ui/viewport/exhibit_clock.h"

namespace vitrine::ui {

ExhibitClock::ExhibitClock(std::size_t subjects) : pressedAt_(subjects, never) {}

void ExhibitClock::set(double seconds)
{
    changeAt_ = time_ = std::clamp(seconds, 0.0, latest);
    emit passed();
    emit wasSet();
    emit changed();
}

void ExhibitClock::setPaused(bool paused)
{
    paused_ = paused;
    emit changed();
}

double ExhibitClock::tick(double now)
{
    const double since = runs_ ? now - lastTick_ : firstTick;
    lastTick_ = now;
    return since;
}

void ExhibitClock::pass(double seconds)
{
    if (seconds == 0) return;
    time_ += seconds;
    emit passed();
}

void ExhibitClock::press(std::size_t subject)
{
    pressedAt_[subject] = time_;
    emit changed();
}

std::vector<double> ExhibitClock::sincePressed(double time) const
{
    std::vector<double> since;
    for (const double pressedAt : pressedAt_) since.push_back(time - (pressedAt <= time ? pressedAt : never));
    return since;
}

}  // namespace vitrine::ui

#include "moc_exhibit_clock.cpp"
