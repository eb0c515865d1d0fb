#pragma once

#include "ui/model/value_ref.h"

#include <QStringList>
#include <QWidget>

namespace vitrine::ui {

/// Editor of one parameter value. One subclass for each kind.
class ValueEditor : public QWidget {
    Q_OBJECT

public:
    ValueEditor(const ValueRef& value, QWidget* parent) : QWidget(parent), value_(value), row_(value.info()) {}

    [[nodiscard]] const ParameterInfo& row() const { return row_; }
    /// Shows a value and sets nothing. A control that already shows it is not painted again.
    virtual void showValue(const Value&) = 0;
    /// Called when the parameter's label is dragged. Editors of numbers change the value; others ignore it.
    virtual void labelPressed(double) {}
    virtual void labelMoved(double, Qt::KeyboardModifiers) {}
    virtual void labelReleased() {}
    [[nodiscard]] virtual bool dragsByLabel() const { return false; }
    /// Sets the values that a text can be chosen from; the first one is used if the text is empty. Other editors ignore
    /// it.
    virtual void setOffers(const QStringList&) {}

protected:
    /// Sets the value after a change by the visitor. Edits of one gesture are one undo step.
    void edit(const Value&, Gesture);

private:
    ValueRef value_;
    const ParameterInfo& row_;
};

}  // namespace vitrine::ui
