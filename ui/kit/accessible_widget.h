#pragma once

#include "ui/kit/accessible_content.h"

#include <QAccessibleWidget>

class QLabel;

namespace vitrine::ui {

/// Returns the text of a label without rich-text marks.
[[nodiscard]] QString plainText(const QLabel&);

/// Accessible interface of a widget that derives from `AccessibleContent`.
class AccessibleWidget : public QAccessibleWidget, public QAccessibleValueInterface {
public:
    /// `widget` must derive from `AccessibleContent`.
    explicit AccessibleWidget(QWidget* widget) : QAccessibleWidget(widget) {}

    [[nodiscard]] QAccessible::Role role() const override;
    [[nodiscard]] QString text(QAccessible::Text) const override;
    void* interface_cast(QAccessible::InterfaceType) override;

    [[nodiscard]] QVariant currentValue() const override { return number().value; }
    void setCurrentValue(const QVariant&) override;
    [[nodiscard]] QVariant maximumValue() const override { return number().most; }
    [[nodiscard]] QVariant minimumValue() const override { return number().least; }
    [[nodiscard]] QVariant minimumStepSize() const override { return number().step; }

private:
    /// Returns null while the widget is being destroyed.
    [[nodiscard]] AccessibleContent* content() const { return dynamic_cast<AccessibleContent*>(object()); }
    /// Returns the widget's number; zeros if it has none.
    [[nodiscard]] AccessibleNumber number() const;
};

}  // namespace vitrine::ui
