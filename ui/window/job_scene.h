#pragma once

#include "exhibits/jobs/kit/job.h"

namespace vitrine::ui {

class SettingsB;
class Workbench;

/// Returns the scene that the window shows, for a job. A job that compares two settings gets those of `other`, too.
[[nodiscard]] jobs::JobScene jobSceneOf(Workbench&, const SettingsB& other, const jobs::Job&);

}  // namespace vitrine::ui
