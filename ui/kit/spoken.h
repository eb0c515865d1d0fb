#pragma once

#include <QAccessible>
#include <QString>

#include <optional>

class QWidget;

namespace vitrine::ui {

/// A number that a widget shows, in the unit that it shows, and how far it goes.
struct SpokenNumber {
    double value = 0, least = 0, most = 0;
    double step = 0;  ///< Of one arrow key, above 0.
    QString text;     ///< With its unit, as on the screen.
};

/// What a widget that draws itself tells a screen reader besides its name. A widget that is one is asked by itself:
/// its accessible interface is made of these.
class Spoken {
public:
    /// Makes the interfaces of all that are spoken, and of labels, which say what they are and what they show.
    Spoken();
    virtual ~Spoken() = default;

    [[nodiscard]] virtual QAccessible::Role spokenRole() const = 0;
    /// Sentences on what is to be seen, after the accessible description; empty: none.
    [[nodiscard]] virtual QString spokenText() const { return {}; }
    /// Nothing where it shows no number.
    [[nodiscard]] virtual std::optional<SpokenNumber> spokenNumber() const { return std::nullopt; }
    /// In the unit of `spokenNumber`, within its ends: what one key press would do, as one step.
    virtual void setSpokenNumber(double) {}
};

/// Tells a screen reader, where one listens, that a widget's number is another one.
void tellNumber(QWidget&);
/// The same of its sentences.
void tellText(QWidget&);
/// Has a screen reader say this at once; `from` is the widget that shows it, of role `Notification` or `AlertMessage`.
void announce(QWidget& from, const QString& text);

}  // namespace vitrine::ui
