#pragma once

#include "ui/kit/spoken.h"

#include <QAccessibleWidget>

class QLabel;

namespace vitrine::ui {

/// Text of a label, without the marks of rich text where it shows such.
[[nodiscard]] QString plainText(const QLabel&);

/// The accessible interface of a widget that is spoken.
class SpokenWidget : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    /// The widget must be a `Spoken`.
    explicit SpokenWidget(QWidget* widget) : QAccessibleWidget(widget) {}

    [[nodiscard]] QAccessible::Role role() const override;
    [[nodiscard]] QString text(QAccessible::Text) const override;
    void* interface_cast(QAccessible::InterfaceType) override;

    [[nodiscard]] QVariant currentValue() const override { return number().value; }
    void setCurrentValue(const QVariant&) override;
    [[nodiscard]] QVariant maximumValue() const override { return number().most; }
    [[nodiscard]] QVariant minimumValue() const override { return number().least; }
    [[nodiscard]] QVariant minimumStepSize() const override { return number().step; }

private:
    /// Null while the widget is being destroyed.
    [[nodiscard]] Spoken* spoken() const { return dynamic_cast<Spoken*>(object()); }
    /// Zeros where there is none.
    [[nodiscard]] SpokenNumber number() const;
};

}  // namespace vitrine::ui
