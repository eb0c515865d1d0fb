#include "ui/kit/accessible_content.h"

#include "ui/kit/accessible_line.h"
#include "ui/kit/accessible_widget.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QTabWidget>

namespace vitrine::ui {
namespace {

/// Accessible interface of a label: says its accessible name, if it has one, and its text.
class AccessibleLabel final : public QAccessibleWidget {
public:
    explicit AccessibleLabel(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) {}

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

/// Accessible interface of a combo box: says its name and the current choice. With Qt's own, some screen readers get
/// only the choice.
class AccessibleChoices final : public QAccessibleWidget {
public:
    explicit AccessibleChoices(QComboBox* box) : QAccessibleWidget(box, QAccessible::ComboBox) {}

    [[nodiscard]] QString text(QAccessible::Text which) const override
    {
        const QString chosen = box().currentText();
        if (which == QAccessible::Value) return chosen;
        if (which != QAccessible::Name) return QAccessibleWidget::text(which);
        const QString name = QAccessibleWidget::text(which);
        return name.isEmpty() || chosen.isEmpty() ? name + chosen : QStringLiteral("%1: %2").arg(name, chosen);
    }
    [[nodiscard]] int childCount() const override { return box().isEditable() ? 2 : 1; }
    [[nodiscard]] QAccessibleInterface* child(int index) const override
    {
        if (index == 0) return QAccessible::queryAccessibleInterface(box().view());
        return index == 1 && box().isEditable() ? QAccessible::queryAccessibleInterface(box().lineEdit()) : nullptr;
    }
    [[nodiscard]] int indexOfChild(const QAccessibleInterface* part) const override
    {
        if (part->object() == box().view()) return 0;
        return box().isEditable() && part->object() == box().lineEdit() ? 1 : -1;
    }
    [[nodiscard]] QAccessible::State state() const override
    {
        QAccessible::State now = QAccessibleWidget::state();
        now.expandable = true;
        now.expanded = box().view()->isVisible();
        now.collapsed = !now.expanded;
        now.editable = box().isEditable();
        return now;
    }
    [[nodiscard]] QStringList actionNames() const override
    {
        return QStringList{showMenuAction(), pressAction()} + QAccessibleWidget::actionNames();
    }
    void doAction(const QString& name) override
    {
        if (name != showMenuAction() && name != pressAction()) return QAccessibleWidget::doAction(name);
        if (!box().isEnabled()) return;
        if (box().view()->isVisible())
            box().hidePopup();
        else
            box().showPopup();
    }

private:
    [[nodiscard]] QComboBox& box() const { return *static_cast<QComboBox*>(object()); }
};

QAccessibleInterface* makeAccessible(const QString&, QObject* object)
{
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget) return nullptr;
    if (dynamic_cast<AccessibleContent*>(object)) {
        if (auto* line = qobject_cast<QLineEdit*>(widget)) return new AccessibleLine(line);
        return new AccessibleWidget(widget);
    }
    // Qt's spin boxes report their step from a property that they do not have.
    if (qobject_cast<QSpinBox*>(widget) || qobject_cast<QDoubleSpinBox*>(widget))
        widget->setProperty("stepSize", widget->property("singleStep"));
    if (qobject_cast<QTabWidget*>(widget)) return new QAccessibleWidget(widget, QAccessible::Grouping);
    if (auto* box = qobject_cast<QComboBox*>(widget)) return new AccessibleChoices(box);
    auto* label = qobject_cast<QLabel*>(widget);
    return label && !label->buddy() && label->pixmap(Qt::ReturnByValue).isNull() ? new AccessibleLabel(label) : nullptr;
}

}  // namespace

AccessibleContent::AccessibleContent()
{
    // Qt ignores a factory that is already installed.
    QAccessible::installFactory(makeAccessible);
}

void notifyNumber(QWidget& widget)
{
    if (!QAccessible::isActive()) return;
    const auto* spoken = dynamic_cast<const AccessibleContent*>(&widget);
    const auto number = spoken ? spoken->accessibleNumber() : std::nullopt;
    if (!number) return;
    QAccessibleValueChangeEvent event(&widget, number->value);
    QAccessible::updateAccessibility(&event);
}

void notifyText(QWidget& widget)
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
    // Screen readers say a notification when it is shown.
    for (const QAccessible::Event what : {QAccessible::ObjectShow, QAccessible::Alert}) {
        QAccessibleEvent event(&from, what);
        QAccessible::updateAccessibility(&event);
    }
}

}  // namespace vitrine::ui
