#pragma once

#include "ui/model/value_ref.h"

#include <QWidget>

namespace vitrine::ui {

/// Edits one value of the look on show. One subclass per kind.
class ValueEditor : public QWidget {
    Q_OBJECT

public:
    ValueEditor(const ValueRef& value, QWidget* parent) : QWidget(parent), value_(value), row_(value.info()) {}

    [[nodiscard]] const ParameterInfo& row() const { return row_; }
    /// Shows a value and sets nothing. A control that shows it already is not painted again.
    virtual void showValue(const Value&) = 0;
    /// Dragging the row's label edits numbers; others ignore it.
    virtual void labelPressed(double) {}
    virtual void labelMoved(double, Qt::KeyboardModifiers) {}
    virtual void labelReleased() {}
    [[nodiscard]] virtual bool dragsByLabel() const { return false; }

protected:
    /// The visitor changed the value. Edits of one gesture are one undo step.
    void edit(const Value&, Gesture);

private:
    ValueRef value_;
    const ParameterInfo& row_;
};

/// The editor for the row's kind.
[[nodiscard]] ValueEditor* makeEditor(const ValueRef&, QWidget* parent);

}  // namespace vitrine::ui
