#include "ui/kit/spoken.h"

#include "ui/kit/spoken_line.h"
#include "ui/kit/spoken_widget.h"

#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTabWidget>

namespace vitrine::ui {
namespace {

/// A label that has an accessible name says both: what it is, and what it shows.
class SpokenLabel final : public QAccessibleWidget {
public:
    explicit SpokenLabel(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) {}

    [[nodiscard]] QString text(QAccessible::Text which) const override
    {
        const auto& label = *static_cast<const QLabel*>(object());
        if (which != QAccessible::Name) return QAccessibleWidget::text(which);
        const QString shown = plainText(label);
        const QString name = label.accessibleName();
        if (name.isEmpty() || name == shown) return shown;
        return shown.isEmpty() ? name : QStringLiteral("%1: %2").arg(name, shown);
    }
};

QAccessibleInterface* makeSpoken(const QString&, QObject* object)
{
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget) return nullptr;
    if (dynamic_cast<Spoken*>(object)) {
        if (auto* line = qobject_cast<QLineEdit*>(widget)) return new SpokenLine(line);
        return new SpokenWidget(widget);
    }
    // Spin boxes of Qt take the step that they tell from a property that they do not have.
    if (qobject_cast<QSpinBox*>(widget) || qobject_cast<QDoubleSpinBox*>(widget))
        widget->setProperty("stepSize", widget->property("singleStep"));
    if (qobject_cast<QTabWidget*>(widget)) return new QAccessibleWidget(widget, QAccessible::Grouping);
    auto* label = qobject_cast<QLabel*>(widget);
    return label && !label->buddy() && label->pixmap(Qt::ReturnByValue).isNull() ? new SpokenLabel(label) : nullptr;
}

}  // namespace

Spoken::Spoken()
{
    // Qt knows a function that is installed twice, and asks it once.
    QAccessible::installFactory(makeSpoken);
}

void tellNumber(QWidget& widget)
{
    if (!QAccessible::isActive()) return;
    const auto* spoken = dynamic_cast<const Spoken*>(&widget);
    const auto number = spoken ? spoken->spokenNumber() : std::nullopt;
    if (!number) return;
    QAccessibleValueChangeEvent event(&widget, number->value);
    QAccessible::updateAccessibility(&event);
}

void tellText(QWidget& widget)
{
    if (!QAccessible::isActive()) return;
    QAccessibleEvent event(&widget, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
}

void announce(QWidget& from, const QString& text)
{
    if (!QAccessible::isActive()) return;
#if QT_VERSION >= QT_VERSION_CHECK(6, 8, 0)
    QAccessibleAnnouncementEvent said(&from, text);
    QAccessible::updateAccessibility(&said);
#else
    Q_UNUSED(text)
#endif
    // Readers say a notification when it comes into sight.
    for (const QAccessible::Event what : {QAccessible::ObjectShow, QAccessible::Alert}) {
        QAccessibleEvent event(&from, what);
        QAccessible::updateAccessibility(&event);
    }
}

}  // namespace vitrine::ui
