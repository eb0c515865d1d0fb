#include "ui/window/job_scene.h"

#include "ui/model/history.h"
#include "ui/model/settings_b.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <cmath>

namespace vitrine::ui {

jobs::JobScene jobSceneOf(Workbench& workbench, const SettingsB& other, const jobs::Job& job)
{
    const Museum& museum = workbench.museum();
    jobs::JobScene scene{&museum, workbench.history().sceneState(), workbench.chosen(), {}};
    if (const auto needed = museum.find(job.needs().subject)) scene.subject = *needed;
    scene.frame.camera = scene.state.camera;
    scene.frame.time = workbench.viewport().clock().time();
    if (scene.subject != hallIndex) scene.frame.subject = scene.subject;
    const Viewport& viewport = workbench.viewport();
    const double ratio = viewport.devicePixelRatioF();
    scene.usual.size = {std::lround(viewport.width() * ratio), std::lround(viewport.height() * ratio)};
    scene.usual.widens = true;
    if (!job.needs().twoSettings) return scene;
    scene.name = "A";
    if (other.isSet()) scene.other = jobs::OtherSettings{other.sceneState(), other.name().toStdString()};
    return scene;
}

}  // namespace vitrine::ui
