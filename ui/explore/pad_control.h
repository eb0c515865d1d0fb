#pragma once

#include "ui/model/history.h"

#include <QObject>

#include <optional>

namespace vitrine::ui {

class MorphPad;
class PadCorners;
class Workbench;

/// Leads the exhibit whose parameters are shown to where the pad's handle is among its corners, live; one gesture is
/// one undo step. A corner that is what is on show is that as of when the handle was first moved. Any other change of
/// the look begins anew: the handle goes to such a corner, or is shown hollow where there is none.
class PadControl final : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    PadControl(Workbench&, const PadCorners&, MorphPad&, QObject* parent);

    void beginAnew();

private:
    void move(const QPointF& place, Gesture);
    void takeBack(Gesture);

    Workbench& workbench_;
    const PadCorners& corners_;
    MorphPad& pad_;
    std::optional<ParameterValues> start_;     // Of corners that are what is on show; nothing: what is.
    std::optional<SceneState> beforeGesture_;  // And whether they had been given by then.
    bool startedBefore_ = false;
    Gesture gesture_ = 0;
    bool moving_ = false;
};

}  // namespace vitrine::ui
