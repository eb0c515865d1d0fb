#include "ui/compare/morph_control.h"

#include "exhibits/framework/table/morph.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/value_slider.h"

namespace vitrine::ui {

MorphControl::MorphControl(History& history, const SettingsB& other, ValueSlider& slider, QObject* parent)
    : QObject(parent), history_(history), other_(other), slider_(slider)
{
    slider.showValue(0);
    connect(&slider, &ValueSlider::edited, this, &MorphControl::morph);
    connect(&history, &History::changed, this, &MorphControl::beginAnew);
    connect(&history, &History::replaced, this, &MorphControl::beginAnew);
    connect(&other, &SettingsB::changed, this, &MorphControl::beginAnew);
}

void MorphControl::beginAnew()
{
    if (moving_) return;
    start_.reset();
    slider_.showValue(0);
}

void MorphControl::morph(double t, Gesture gesture)
{
    if (!other_.isSet()) return;
    if (!start_) start_ = history_.sceneState();
    SceneState next = history_.sceneState();
    for (std::size_t s = 0; s < next.values.size(); ++s)
        next.values[s] = morphed(start_->values[s], other_.sceneState().values[s], t);
    moving_ = true;
    history_.change(tr("Morph towards B"), next, gesture);
    moving_ = false;
}

}  // namespace vitrine::ui

#include "moc_morph_control.cpp"
