#pragma once

#include "ui/model/history.h"

#include <QObject>

#include <optional>

namespace vitrine::ui {

class MorphPad;
class PadCorners;
class Workbench;

/// Control that blends the values of the shown exhibit between the pad's corners while the handle moves. One gesture is
/// one undo step. A corner with the present values keeps those from before the first move. Any other change of values
/// starts again: the handle moves to such a corner, or is hollow if there is none.
class PadControl final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    PadControl(Workbench&, const PadCorners&, MorphPad&, QObject* parent);

    void beginAnew();

private:
    void move(const QPointF& place, Gesture);
    void takeBack(Gesture);

    Workbench& workbench_;
    const PadCorners& corners_;
    MorphPad& pad_;
    std::optional<ParameterValues> start_;  // Values of corners with the present values; unset: not moved yet.
    // State before the gesture. `startedBefore_`: `start_` was set before it.
    std::optional<SceneState> beforeGesture_;
    bool startedBefore_ = false;
    Gesture gesture_ = 0;
    bool moving_ = false;
};

}  // namespace vitrine::ui
