#pragma once

#include "ui/model/history.h"
#include "ui/window/main_window.h"

#include <QUndoStack>

namespace vitrine::test {

/// Pictures at rest are the mean of that many samples in place of sixteen, which a software renderer takes seconds for.
/// Nothing of it can be undone.
inline void takeFewSamples(ui::MainWindow& window, double samples)
{
    window.history().set(0, *window.museum().subject(0).parameters().find("supersamples"), samples, ui::newGesture());
    window.history().stack().clear();
}

}  // namespace vitrine::test
