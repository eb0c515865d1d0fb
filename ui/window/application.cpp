#include "ui/window/application.h"

#include "render/failure.h"

#include <cstdio>
#include <new>

namespace vitrine::ui {

QString messageOf(const std::exception& thrown)
{
    const QString words = QString::fromUtf8(thrown.what());
    if (dynamic_cast<const Failure*>(&thrown)) return words;
    if (dynamic_cast<const std::bad_alloc*>(&thrown))
        return Application::tr("There was not enough memory for what was to be done; nothing was changed. Make it smaller, or close something else.");
    return Application::tr("A fault in Vitrine itself was caught, and what was to be done was not done: %1. Everything else goes on.").arg(words);
}

bool Application::notify(QObject* receiver, QEvent* event)
{
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& thrown) {
        tell(messageOf(thrown));
    } catch (...) {
        tell(tr("A fault in Vitrine itself was caught, and what was to be done was not done. Everything else goes on."));
    }
    return true;
}

void Application::tell(const QString& message)
{
    std::fprintf(stderr, "vitrine: %s\n", qPrintable(message));
    if (telling_) return;  // Showing a message failed, too: it stands on stderr.
    telling_ = true;
    try {
        emit caught(message);
    } catch (...) {
        std::fprintf(stderr, "vitrine: the message could not be shown\n");
    }
    telling_ = false;
}

}  // namespace vitrine::ui

#include "moc_application.cpp"
