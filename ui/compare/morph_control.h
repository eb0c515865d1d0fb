#pragma once

#include "ui/model/history.h"

#include <QObject>

#include <optional>

namespace vitrine::ui {

class OtherSettings;
class ValueSlider;

/// Leads A towards B by a slider: at its left end A is as it was when the slider was first moved, at its right end as
/// B. One drag is one undo step. Any other change of A or B begins a new way.
class MorphControl final : public QObject {
    Q_OBJECT

public:
    /// All must outlive it; the slider is over `CompareRows::towardsB`.
    MorphControl(History&, const OtherSettings&, ValueSlider&, QObject* parent);

private:
    void morph(double t, Gesture);
    void beginAnew();

    History& history_;
    const OtherSettings& other_;
    ValueSlider& slider_;
    std::optional<SceneState> start_;  // A at the left end; nothing: what is on show.
    bool moving_ = false;
};

}  // namespace vitrine::ui
