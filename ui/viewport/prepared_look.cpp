#include "ui/viewport/prepared_look.h"

#include <utility>

namespace vitrine::ui {

const Prepared& PreparedLook::of(const SceneState& sceneState, long long number, FrameRequest wanted)
{
    const bool current = prepared_ && number_ == number && prepared_->time == wanted.time;
    if (!current || (!prepared_->pending.empty() && !asked_)) {
        wanted.waitless = true;  // The render thread reads what it draws,
        wanted.rests = false;    // and makes what it draws it with.
        prepared_ = museum_.prepare(sceneState, wanted);
        number_ = number;
        ++preparations_;
    }
    asked_ = true;
    return *prepared_;
}

}  // namespace vitrine::ui
