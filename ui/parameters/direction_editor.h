#pragma once

#include "ui/parameters/value_editor.h"

#include <memory>

namespace vitrine::ui {

class NumberField;

/// Editor of a direction: azimuth in degrees (0 is along -z, growing to the right) and elevation above the horizon.
class DirectionEditor final : public ValueEditor {
    Q_OBJECT

public:
    DirectionEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;
    void labelPressed(double x) override;
    void labelMoved(double x, Qt::KeyboardModifiers) override;
    void labelReleased() override;
    [[nodiscard]] bool dragsByLabel() const override { return true; }

private:
    void take(int gesture);

    NumberField* azimuth_;
    NumberField* elevation_;
};

}  // namespace vitrine::ui
