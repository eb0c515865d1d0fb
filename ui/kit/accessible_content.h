#pragma once

#include <QAccessible>
#include <QString>

#include <optional>

class QWidget;

namespace vitrine::ui {

/// Number that a widget shows, with its range, in the displayed unit.
struct AccessibleNumber {
    double value = 0, least = 0, most = 0;
    double step = 0;  ///< Step of one arrow key, above 0.
    QString text;     ///< Text with unit, as on the screen.
};

/// Accessibility of a widget that draws itself: what a screen reader says besides its name. Its accessible interface is
/// made from these functions.
class AccessibleContent {
public:
    /// Installs the factory of accessible interfaces for all widgets with `AccessibleContent`, and for labels and
    /// combo boxes.
    AccessibleContent();
    virtual ~AccessibleContent() = default;

    [[nodiscard]] virtual QAccessible::Role accessibleRole() const = 0;
    /// Returns sentences on what the widget shows, said after the accessible description; empty: none.
    [[nodiscard]] virtual QString accessibleText() const { return {}; }
    /// Returns the number that the widget shows, if any.
    [[nodiscard]] virtual std::optional<AccessibleNumber> accessibleNumber() const { return std::nullopt; }
    /// Sets the number, in the unit of `accessibleNumber` and within its range, as one undo step.
    virtual void setAccessibleNumber(double) {}
};

/// Tells screen readers that a widget's number changed.
void notifyNumber(QWidget&);
/// Tells screen readers that a widget's sentences changed.
void notifyText(QWidget&);
/// Makes screen readers say the text at once. `from` is the widget that shows it, with the role `Notification` or
/// `AlertMessage`.
void announce(QWidget& from, const QString& text);

}  // namespace vitrine::ui
