#include "ui/window/application.h"

#include "ui/kit/message_of.h"

#include <cstdio>

namespace vitrine::ui {

bool Application::notify(QObject* receiver, QEvent* event)
{
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& thrown) {
        showError(messageOf(thrown));
    } catch (...) {
        showError(tr("An internal error was caught. The command was not executed; everything else continues."));
    }
    return true;
}

void Application::showError(const QString& message)
{
    std::fprintf(stderr, "vitrine: %s\n", qPrintable(message));
    if (telling_) return;  // Showing a message failed, too; it was printed to stderr.
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
