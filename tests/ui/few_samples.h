#pragma once

#include "ui/model/history.h"
#include "ui/window/main_window.h"

#include <QUndoStack>

namespace vitrine::test {

/// Sets the number of supersamples of static pictures, in place of sixteen, which take a software renderer seconds.
/// Makes no undo step.
inline void takeFewSamples(ui::MainWindow& window, double samples)
{
    window.history().set(0, *window.museum().subject(0).parameters().find("supersamples"), samples, ui::newGesture());
    window.history().stack().clear();
}

}  // namespace vitrine::test
