#include "ui/explore/pad_control.h"

#include "exhibits/framework/table/morph.h"
#include "ui/explore/morph_pad.h"
#include "ui/explore/pad_corners.h"
#include "ui/model/workbench.h"

namespace vitrine::ui {

PadControl::PadControl(Workbench& workbench, const PadCorners& corners, MorphPad& pad, QObject* parent)
    : QObject(parent), workbench_(workbench), corners_(corners), pad_(pad)
{
    connect(&pad, &MorphPad::moved, this, &PadControl::move);
    connect(&pad, &MorphPad::takenBack, this, &PadControl::takeBack);
    connect(&workbench.history(), &History::changed, this, &PadControl::beginAnew);
    connect(&workbench.history(), &History::replaced, this, &PadControl::beginAnew);
    connect(&corners, &PadCorners::changed, this, &PadControl::beginAnew);
}

void PadControl::beginAnew()
{
    if (moving_) return;
    start_.reset();
    const std::optional<std::size_t> present = corners_.onShow();
    pad_.show(present ? PadCorners::placeOf(*present) : pad_.place(), !present);
}

void PadControl::move(const QPointF& place, Gesture gesture)
{
    if (!corners_.ready()) return;
    History& history = workbench_.history();
    const std::size_t exhibit = workbench_.shown();
    if (gesture != gesture_) {
        gesture_ = gesture;
        beforeGesture_ = history.sceneState();
        startedBefore_ = start_.has_value();
    }
    if (!start_) start_ = history.sceneState().values[exhibit];
    const auto weights = PadCorners::weightsAt(place);
    std::array<WeightedValues, PadCorners::count> settings{};
    for (std::size_t i = 0; i < PadCorners::count; ++i) {
        const PadCorners::Corner& corner = corners_.at(i);
        settings.at(i) = {corner.source == PadCorners::Source::onShow ? &*start_ : &*corner.values, weights.at(i)};
    }
    SceneState next = history.sceneState();
    next.values[exhibit] = morphed(settings);
    moving_ = true;
    history.change(tr("Move between four settings"), next, gesture);
    moving_ = false;
}

void PadControl::takeBack(Gesture gesture)
{
    if (gesture != gesture_ || !beforeGesture_) return;  // The gesture has moved nothing.
    moving_ = true;
    workbench_.history().change(tr("Move between four settings"), *beforeGesture_, gesture);
    moving_ = false;
    if (!startedBefore_) start_.reset();
}

}  // namespace vitrine::ui

#include "moc_pad_control.cpp"
