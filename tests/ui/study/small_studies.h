#pragma once

#include "ui/study/study_dock.h"

namespace vitrine::test {

/// Sets the size of the measured pictures in pixels, and how often each is timed.
inline void setEffort(ui::StudyDock& dock, glm::ivec2 size, int runs)
{
    const study::StudyTable& t = study::studyTable();
    ParameterValues values = dock.setup().values();
    values.set(t.width, size.x);
    values.set(t.height, size.y);
    values.set(t.runs, runs);
    dock.setup().change(QString(), values);
}

}  // namespace vitrine::test
