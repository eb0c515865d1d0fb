#pragma once

#include "exhibits/framework/parameters.h"
#include "ui/window/undo.h"

#include <QWidget>

namespace vitrine::ui {

/// Edits the value of one row. One subclass per kind.
class ValueEditor : public QWidget {
    Q_OBJECT

public:
    ValueEditor(const ParameterInfo& row, QWidget* parent) : QWidget(parent), row_(row) {}

    [[nodiscard]] const ParameterInfo& row() const { return row_; }
    /// Shows a value; emits nothing.
    virtual void showValue(const Value&) = 0;
    /// Dragging the row's label edits numbers; others ignore it.
    virtual void labelPressed(double) {}
    virtual void labelMoved(double, Qt::KeyboardModifiers) {}
    virtual void labelReleased() {}
    [[nodiscard]] virtual bool dragsByLabel() const { return false; }

signals:
    /// The visitor changed the value. Edits of one gesture are one undo step.
    void edited(const vitrine::Value& value, int gesture);

private:
    const ParameterInfo& row_;
};

/// The editor for the row's kind.
[[nodiscard]] ValueEditor* makeEditor(const ParameterInfo&, QWidget* parent);

}  // namespace vitrine::ui
