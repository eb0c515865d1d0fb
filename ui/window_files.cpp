// Files that come to the window and pictures that leave it.
#include "ui/main_window.h"

#include "ui/preset_shelf.h"
#include "ui/viewport.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

namespace vitrine::ui {

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) openFile(url.toLocalFile());
    event->acceptProposedAction();
}

void MainWindow::setHallFile(const char* parameter, const QString& path)
{
    Look next = history_.look();
    const auto row = next.values[0].table().find(parameter);
    if (!row) {
        say(MessageStrip::Mood::problem, tr("%1 was dropped, but this hall has no parameter \"%2\" to put it in.").arg(path, QLatin1String(parameter)));
        return;
    }
    next.values[0].setRow(*row, QFileInfo(path).absoluteFilePath().toStdString());
    history_.change(tr("Put %1 into the hall").arg(QFileInfo(path).fileName()), std::move(next));
}

void MainWindow::openFile(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const QStringList models{QStringLiteral("glb"), QStringLiteral("gltf")};
    const QStringList pictures{QStringLiteral("hdr"), QStringLiteral("exr"), QStringLiteral("jpg"), QStringLiteral("jpeg"), QStringLiteral("png"), QStringLiteral("tif"), QStringLiteral("tiff")};
    if (ending == QLatin1String("json")) shelf_->loadFile(path);
    else if (models.contains(ending)) setHallFile("model", path);
    else if (pictures.contains(ending)) {
        if (!shelf_->loadFromPicture(path)) setHallFile("environment", path);
    } else {
        say(MessageStrip::Mood::problem, tr("%1 cannot be opened: it is none of .json, .glb, .gltf, .hdr, .exr, .png, .jpg, .tif.").arg(path));
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    event->accept();
}

void MainWindow::saveScreenshotNow() {}

void MainWindow::openScreenshotDialog() {}

}  // namespace vitrine::ui
