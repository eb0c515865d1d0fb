#pragma once

#include "ui/model/history.h"
#include "ui/window/main_window.h"

#include <QUndoStack>

#include <map>

namespace vitrine::test {

/// Settings of the hall that a software renderer draws soon. With the initial ones, the first picture of a renderer
/// takes it seconds: the reflection probe alone has seven times the pixels of a picture of 320 x 180.
struct CheapPictures {
    double samples = 1;  ///< Number of supersamples of a static picture, in place of sixteen.
    double scale = 0.5;  ///< Resolution of the picture, as a part of the viewport's.
};

/// Sets these settings. Makes no undo step.
inline void drawCheaply(ui::MainWindow& window, const CheapPictures& pictures)
{
    const Parameters& hall = window.museum().subject(0).parameters();
    for (const auto& [name, value] : std::map<const char*, double>{{"supersamples", pictures.samples},
                                                                   {"resolutionScale", pictures.scale},
                                                                   {"probeSize", 16},
                                                                   {"probeSamples", 1},
                                                                   {"shadowMapSize", 256}})
        window.history().set(0, *hall.find(name), value, ui::newGesture());
    window.history().stack().clear();
}

/// Sets the number of supersamples of static pictures. Makes no undo step.
inline void takeFewSamples(ui::MainWindow& window, double samples)
{
    window.history().set(0, *window.museum().subject(0).parameters().find("supersamples"), samples, ui::newGesture());
    window.history().stack().clear();
}

}  // namespace vitrine::test
