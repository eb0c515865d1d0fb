#include "ui/window/recent_files.h"

#include "exhibits/framework/files/state_folder.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/preferences.h"
#include "ui/window/file_opener.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace vitrine::ui {
namespace {

QSettings settings()
{
    return QSettings(iniPath(QString::fromStdString((stateFolder() / "window.ini").string())), QSettings::IniFormat);
}

const QString key = QStringLiteral("recentFiles");

}  // namespace

QStringList recentFiles()
{
    QStringList there;
    for (const QString& path : settings().value(key).toStringList())
        if (QFileInfo::exists(path)) there << path;
    return there;
}

void addRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    const QString whole = QFileInfo(path).absoluteFilePath();
    files.removeAll(whole);
    files.prepend(whole);
    settings().setValue(key, files);
    keepRecentFiles(Preferences::saved().recentFiles);
}

void keepRecentFiles(int most)
{
    const QStringList files = settings().value(key).toStringList();
    if (most == 0)
        settings().remove(key);
    else if (files.size() > most)
        settings().setValue(key, files.mid(0, most));
}

QMenu* recentMenu(QWidget* parent, FileOpener& opener)
{
    auto* menu = new QMenu(QCoreApplication::translate("MainWindow", "Open &recent"), parent);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &opener] {
        menu->clear();
        for (const QString& path : recentFiles()) {
            QAction* action = menu->addAction(menuText(QFileInfo(path).fileName()));
            action->setToolTip(path);
            QObject::connect(action, &QAction::triggered, &opener, [&opener, path] { opener.open(path); });
        }
        menu->setToolTipsVisible(true);
        if (menu->isEmpty()) {
            menu->addAction(QCoreApplication::translate("MainWindow", "None yet"))->setEnabled(false);
            return;
        }
        menu->addSeparator();
        QAction* clear = menu->addAction(QCoreApplication::translate("MainWindow", "&Clear the list"));
        clear->setToolTip(QCoreApplication::translate(
            "MainWindow", "Clears the list of recent files; the files themselves are kept."));
        QObject::connect(clear, &QAction::triggered, menu, [] { keepRecentFiles(0); });
    });
    return menu;
}

}  // namespace vitrine::ui
