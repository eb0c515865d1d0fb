#include "ui/kit/show_in_folder.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDesktopServices>
#include <QFileInfo>
#include <QUrl>

namespace vitrine::ui {

void showInFolder(const QString& file)
{
    const QFileInfo info(file);
    const auto openFolder = [folder = QUrl::fromLocalFile(info.absolutePath())] { QDesktopServices::openUrl(folder); };
    const QString manager = QStringLiteral("org.freedesktop.FileManager1");
    QDBusMessage message = QDBusMessage::createMethodCall(manager, QStringLiteral("/org/freedesktop/FileManager1"),
                                                          manager, QStringLiteral("ShowItems"));
    message << QStringList{QUrl::fromLocalFile(info.absoluteFilePath()).toString()} << QString();
    const QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) {
        openFolder();
        return;
    }
    auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(message, 2000));
    QObject::connect(answer, &QDBusPendingCallWatcher::finished, answer, [answer, openFolder] {
        if (answer->isError()) openFolder();
        answer->deleteLater();
    });
}

}  // namespace vitrine::ui
