#pragma once

#include <QAccessible>
#include <QString>

#include <optional>

class QWidget;

namespace vitrine::ui {

/// Number that a widget shows, with its range, in the displayed unit.
struct SpokenNumber {
    double value = 0, least = 0, most = 0;
    double step = 0;  ///< Step of one arrow key, above 0.
    QString text;     ///< Text with unit, as on the screen.
};

/// Accessibility of a widget that draws itself: what a screen reader says besides its name. Its accessible interface is
/// made from these functions.
class Spoken {
public:
    /// Installs the factory of accessible interfaces for all `Spoken` widgets, and for labels and combo boxes.
    Spoken();
    virtual ~Spoken() = default;

    [[nodiscard]] virtual QAccessible::Role spokenRole() const = 0;
    /// Returns sentences on what the widget shows, said after the accessible description; empty: none.
    [[nodiscard]] virtual QString spokenText() const { return {}; }
    /// Returns the number that the widget shows, if any.
    [[nodiscard]] virtual std::optional<SpokenNumber> spokenNumber() const { return std::nullopt; }
    /// Sets the number, in the unit of `spokenNumber` and within its range, as one undo step.
    virtual void setSpokenNumber(double) {}
};

/// Tells screen readers that a widget's number changed.
void tellNumber(QWidget&);
/// Tells screen readers that a widget's sentences changed.
void tellText(QWidget&);
/// Makes screen readers say the text at once. `from` is the widget that shows it, with the role `Notification` or
/// `AlertMessage`.
void announce(QWidget& from, const QString& text);

}  // namespace vitrine::ui
