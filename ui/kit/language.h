#pragma once

#include <QString>
#include <QStringList>

#include <functional>
#include <string>
#include <string_view>

class QMenu;
class QWidget;

namespace vitrine::ui {

/// The codes of the languages that the program speaks: "en", "de".
[[nodiscard]] const QStringList& languages();
/// A language by its own name: "Deutsch". Empty for an unknown code.
[[nodiscard]] QString nameOfLanguage(const QString& code);

/// What LC_ALL, LC_MESSAGES or LANG, in this order, ask for; "en" where that is no language of the program.
[[nodiscard]] QString languageOfLocale();
/// The language that was chosen last, on this machine; empty: as the system.
[[nodiscard]] QString savedLanguage();
/// Keeps the choice for the next start; empty: as the system.
void keepLanguage(const QString& code);
/// The saved choice, or else the locale's.
[[nodiscard]] QString languageOfWindow();

/// All that is shown from now on is in this language: texts of widgets that are made from now on, and, where there is
/// an application, Qt's own. What was made before keeps its own. An unknown code is English.
void speak(const QString& code);
/// The language of what is shown; "en" before `speak`.
[[nodiscard]] QString spokenLanguage();
/// Whether `speak` was called, as for the command line's --language.
[[nodiscard]] bool languageAsked();

/// A text of the layers below (a label, a help sentence, a reason, a failure) in the language of the program.
[[nodiscard]] QString said(std::string_view english);
/// The name of a row, or another one, within a sentence: small in English, as it is in languages with capital nouns.
[[nodiscard]] QString within(const QString& name);
/// A failure's sentence in the language of the locale, for standard error.
[[nodiscard]] std::string saidInLocale(std::string_view english);

/// "Language": as the system, English, Deutsch. The choice counts from the next start; `chosen` is called then.
[[nodiscard]] QMenu* languageMenu(QWidget* parent, const std::function<void(const QString& message)>& chosen);

}  // namespace vitrine::ui
