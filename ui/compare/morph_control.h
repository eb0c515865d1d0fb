#pragma once

#include "ui/model/history.h"

#include <QObject>

#include <optional>

namespace vitrine::ui {

class SettingsB;
class ValueSlider;

/// Slider from A to B. At its left end A is as it was when the slider was first moved, at its right end it equals B.
/// One drag is one undo step. Any other change of A or B starts again from the present A.
class MorphControl final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object. The slider must have the parameter `CompareParameters::towardsB`.
    MorphControl(History&, const SettingsB&, ValueSlider&, QObject* parent);

private:
    void morph(double t, Gesture);
    void beginAnew();

    History& history_;
    const SettingsB& other_;
    ValueSlider& slider_;
    std::optional<SceneState> start_;  // A at the left end; unset: the present A.
    bool moving_ = false;
};

}  // namespace vitrine::ui
