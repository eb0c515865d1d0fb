#include "ui/kit/message_of.h"

#include "render/failure.h"
#include "ui/kit/language.h"

#include <QCoreApplication>

#include <new>

namespace vitrine::ui {

QString messageOf(const std::exception& thrown)
{
    const auto tr = [](const char* text) { return QCoreApplication::translate("MessageOf", text); };
    const QString words = said(thrown.what());
    if (dynamic_cast<const Failure*>(&thrown)) return words;
    if (dynamic_cast<const std::bad_alloc*>(&thrown))
        return tr("There was not enough memory for this, and nothing was changed. Choose a smaller size, or close "
                  "another program.");
    return tr("Vitrine has a fault: %1. What you asked for was not done; everything else goes on.").arg(words);
}

}  // namespace vitrine::ui
