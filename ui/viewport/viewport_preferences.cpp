// What the visitor prefers of pictures and pointer, whatever is on show, and what the hall says of their quality.
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_input.h"

namespace vitrine::ui {

void Viewport::takeQuality()
{
    const PictureQuality quality = pictureQuality(history_.sceneState().hall());
    schedule_.setSamples(quality.supersamples);
    schedule_.setHistory(quality.historyFrames);
}

void Viewport::setHandling(const Handling& handling)
{
    input_->setHandling(handling);
}

void Viewport::setLimits(int mostSamples, double leastScale)
{
    const int samples = schedule_.samples();
    schedule_.setLimits(mostSamples, leastScale);
    if (schedule_.samples() != samples) sceneStateChanged();
}

}  // namespace vitrine::ui
