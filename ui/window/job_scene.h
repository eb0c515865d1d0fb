#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::ui {

class Workbench;

/// Returns the scene that the window shows, for a job.
[[nodiscard]] jobs::JobScene jobSceneOf(Workbench&, const jobs::Job&);

}  // namespace vitrine::ui
