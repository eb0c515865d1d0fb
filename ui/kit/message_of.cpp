#include "ui/kit/message_of.h"

#include "render/failure.h"
#include "ui/kit/language.h"

#include <QCoreApplication>

#include <new>

namespace vitrine::ui {

QString messageOf(const std::exception& thrown)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("MessageOf", text); };
    if (const auto* failure = dynamic_cast<const Failure*>(&thrown)) return translatedText(failure->message());
    if (dynamic_cast<const std::bad_alloc*>(&thrown))
        return tr("There was not enough memory for this, and nothing was changed. Choose a smaller size, or close "
                  "another program.");
    return tr("Internal error: %1. The command was not executed; everything else continues.")
        .arg(translatedText(thrown.what()));
}

}  // namespace vitrine::ui
