#pragma once

#include "ui/parameters/value_editor.h"

namespace vitrine::ui {

class NumberField;
class ValueSlider;

/// Slider and number field for kinds real and count.
class NumberEditor final : public ValueEditor {
    Q_OBJECT

public:
    NumberEditor(const ValueRef&, QWidget* parent);

    void showValue(const Value&) override;
    void labelPressed(double x) override;
    void labelMoved(double x, Qt::KeyboardModifiers) override;
    void labelReleased() override;
    [[nodiscard]] bool dragsByLabel() const override { return true; }

private:
    ValueSlider* slider_;
    NumberField* field_;
};

}  // namespace vitrine::ui
