#include "ui/kit/spoken_widget.h"

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

QAccessible::Role SpokenWidget::role() const
{
    const Spoken* one = spoken();
    return one ? one->spokenRole() : QAccessible::Client;
}

QString SpokenWidget::text(QAccessible::Text which) const
{
    const Spoken* one = spoken();
    if (one && which == QAccessible::Value) return number().text;
    if (!one || which != QAccessible::Description) return QAccessibleWidget::text(which);
    QStringList all;
    for (const QString& part : {widget()->accessibleDescription(), one->spokenText()})
        if (!part.isEmpty()) all << part;
    // The tooltip has the range and explains how to change the value.
    return all.isEmpty() ? widget()->toolTip() : all.join(QLatin1Char(' '));
}

void* SpokenWidget::interface_cast(QAccessible::InterfaceType type)
{
    const Spoken* one = spoken();
    if (type == QAccessible::ValueInterface && one && one->spokenNumber())
        return static_cast<QAccessibleValueInterface*>(this);
    return QAccessibleWidget::interface_cast(type);
}

SpokenNumber SpokenWidget::number() const
{
    const Spoken* one = spoken();
    return one ? one->spokenNumber().value_or(SpokenNumber()) : SpokenNumber();
}

void SpokenWidget::setCurrentValue(const QVariant& value)
{
    Spoken* one = spoken();
    bool isNumber = false;
    const double wanted = value.toDouble(&isNumber);
    if (!one || !one->spokenNumber() || !isNumber || !std::isfinite(wanted) || !widget()->isEnabled()) return;
    one->setSpokenNumber(std::clamp(wanted, number().least, number().most));
}

}  // namespace vitrine::ui
