#include "ui/viewport/prepared_state.h"

#include <algorithm>
#include <utility>

namespace vitrine::ui {

const Prepared& PreparedState::of(const SceneState& sceneState, long long number, FrameRequest wanted)
{
    const bool moves = std::any_of(sceneState.values.begin(), sceneState.values.end(),
                                   [](const ParameterValues& values) { return !values.motions().empty(); });
    const bool current =
        prepared_ && number_ == number && prepared_->time == wanted.time && (!moves || eye_ == wanted.camera.eye);
    if (!current || (!prepared_->pending.empty() && !asked_)) {
        wanted.nonBlocking = true;  // The render thread reads missing files,
        wanted.idle = false;        // and builds the programs.
        prepared_ = museum_.prepare(sceneState, wanted);
        number_ = number;
        eye_ = wanted.camera.eye;
        ++preparations_;
    }
    asked_ = true;
    return *prepared_;
}

}  // namespace vitrine::ui
