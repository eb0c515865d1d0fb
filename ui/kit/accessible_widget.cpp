#include "ui/kit/accessible_widget.h"

#include <QLabel>
#include <QTextDocumentFragment>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

QString plainText(const QLabel& label)
{
    return label.textFormat() == Qt::RichText ? QTextDocumentFragment::fromHtml(label.text()).toPlainText()
                                              : label.text();
}

QAccessible::Role AccessibleWidget::role() const
{
    const AccessibleContent* one = content();
    return one ? one->accessibleRole() : QAccessible::Client;
}

QString AccessibleWidget::text(QAccessible::Text which) const
{
    const AccessibleContent* one = content();
    if (one && which == QAccessible::Value) return number().text;
    if (!one || which != QAccessible::Description) return QAccessibleWidget::text(which);
    QStringList all;
    for (const QString& part : {widget()->accessibleDescription(), one->accessibleText()})
        if (!part.isEmpty()) all << part;
    // The tooltip has the range and explains how to change the value.
    return all.isEmpty() ? widget()->toolTip() : all.join(QLatin1Char(' '));
}

void* AccessibleWidget::interface_cast(QAccessible::InterfaceType type)
{
    const AccessibleContent* one = content();
    if (type == QAccessible::ValueInterface && one && one->accessibleNumber())
        return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
}

AccessibleNumber AccessibleWidget::number() const
{
    const AccessibleContent* one = content();
    return one ? one->accessibleNumber().value_or(AccessibleNumber()) : AccessibleNumber();
}

void AccessibleWidget::setCurrentValue(const QVariant& value)
{
    AccessibleContent* one = content();
    bool isNumber = false;
    const double wanted = value.toDouble(&isNumber);
    if (!one || !one->accessibleNumber() || !isNumber || !std::isfinite(wanted) || !widget()->isEnabled()) return;
    one->setAccessibleNumber(std::clamp(wanted, number().least, number().most));
}

}  // namespace vitrine::ui
