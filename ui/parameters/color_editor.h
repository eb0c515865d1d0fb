#pragma once

#include "ui/parameters/value_editor.h"

#include <glm/glm.hpp>

#include <QAbstractButton>

class QLineEdit;

namespace vitrine::ui {

/// Editor of a color: a swatch that opens a dialog over the panel, and the color as `#rrggbb`. Accepts all notations of
/// `typedValue`.
class ColorEditor final : public ValueEditor {
    Q_OBJECT

public:
    ColorEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    void choose();
    void typed();
    void showWrong(bool);

    QAbstractButton* swatch_;
    QLineEdit* code_;
    glm::dvec3 value_{0};
    bool wrong_ = false;
};

}  // namespace vitrine::ui
