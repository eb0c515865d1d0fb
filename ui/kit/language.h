#pragma once

#include "render/text/message.h"

#include <QString>
#include <QStringList>

#include <string>

class QWidget;

namespace vitrine::ui {

/// Returns the codes of the program's languages: "en", "de".
[[nodiscard]] const QStringList& languages();
/// Returns the name of a language in that language: "Deutsch". Empty for an unknown code.
[[nodiscard]] QString nameOfLanguage(const QString& code);

/// Returns the language that LC_ALL, LC_MESSAGES or LANG selects, in this order; "en" if the program does not have it.
[[nodiscard]] QString languageOfLocale();
/// Returns the saved choice of language; empty: that of the system.
[[nodiscard]] QString savedLanguage();
/// Saves the choice of language for the next start; empty: that of the system.
void keepLanguage(const QString& code);
/// Returns the saved choice of language, or else that of the locale.
[[nodiscard]] QString languageOfWindow();

/// Sets the language of all texts made from now on, including Qt's own if there is an application. Existing widgets
/// keep their texts. An unknown code selects English.
void setLanguage(const QString& code);
/// Returns the code of the present language; "en" before `setLanguage`.
[[nodiscard]] QString languageCode();
/// Returns whether `setLanguage` was called, for example for the command line's --language.
[[nodiscard]] bool languageAsked();

/// Translates a text of the lower layers (a label, a help text, a reason, a failure) to the present language.
[[nodiscard]] QString translatedText(const Message&);
/// Returns the name in the form used within a sentence: in lower case in English, unchanged in German.
[[nodiscard]] QString midSentence(const QString& name);
/// Translates a failure's sentence to the locale's language, for standard error.
[[nodiscard]] std::string translatedInLocale(const Message&);

}  // namespace vitrine::ui
