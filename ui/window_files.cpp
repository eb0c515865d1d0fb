// Files that come to the window and pictures that leave it.
#include "ui/main_window.h"

#include "exhibits/exhibits.h"
#include "ui/picture_export.h"
#include "ui/preset_shelf.h"
#include "ui/print_dialog.h"
#include "ui/screenshot_dialog.h"
#include "ui/session_keeper.h"
#include "ui/shown_views.h"
#include "ui/viewport.h"

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include <algorithm>
#include <cmath>

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
        say(MessageStrip::Mood::problem,
            tr("%1 was dropped, but this hall has no parameter \"%2\" to put it in.").arg(path, QLatin1String(parameter)));
        return;
    }
    next.values[0].setRow(*row, QFileInfo(path).absoluteFilePath().toStdString());
    history_.change(tr("Put %1 into the hall").arg(QFileInfo(path).fileName()), std::move(next));
}

namespace {

const QStringList models{QStringLiteral("glb"), QStringLiteral("gltf")};
const QStringList pictures{QStringLiteral("hdr"), QStringLiteral("exr"), QStringLiteral("jpg"), QStringLiteral("jpeg"),
                           QStringLiteral("png"), QStringLiteral("tif"), QStringLiteral("tiff")};

}  // namespace

QStringList MainWindow::openable()
{
    QStringList patterns{QStringLiteral("*.json")};
    for (const QString& ending : models + pictures) patterns << QStringLiteral("*.") + ending;
    return patterns;
}

void MainWindow::openFile(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == QLatin1String("json")) shelf_->loadFile(path);
    else if (models.contains(ending)) setHallFile("model", path);
    else if (pictures.contains(ending)) {
        if (!shelf_->loadFromPicture(path)) setHallFile("environment", path);
    } else {
        say(MessageStrip::Mood::problem,
            tr("%1 cannot be opened: it is none of .json, .glb, .gltf, .hdr, .exr, .png, .jpg, .tif.").arg(path));
    }
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    keeper_->close();
    event->accept();
}

void MainWindow::saveScreenshotNow()
{
    const std::string_view name = gallery_.exhibits()[chosen_]->name();
    ExportWish wish;
    wish.path = freeScreenshotPath(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    if (const std::optional<render::Image> shown = viewport_->finishedPicture()) {
        try {
            render::PictureMetadata inside;
            inside.preset = shelf_->lookText();
            render::writePicture(wish.path, *shown, wish.format, inside);
            say(MessageStrip::Mood::notice, tr("Screenshot saved to %1.").arg(QString::fromStdString(wish.path.string())));
        } catch (const std::exception& failure) {
            say(MessageStrip::Mood::problem, QString::fromUtf8(failure.what()));
        }
        return;
    }
    const double ratio = viewport_->devicePixelRatioF();
    wish.size = {std::max(1, static_cast<int>(std::lround(viewport_->width() * ratio))),
                 std::max(1, static_cast<int>(std::lround(viewport_->height() * ratio)))};
    wish.samples = viewport_->schedule().samples();
    auto* work = new PictureExport(*this, wish);
    connect(work, &PictureExport::finished, this,
            [this](const QString& path) { say(MessageStrip::Mood::notice, tr("Screenshot saved to %1.").arg(path)); });
    connect(work, &PictureExport::failed, this, [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    viewport_->showHint(tr("Drawing the screenshot …"));
    connect(work, &QObject::destroyed, viewport_, [this] { viewport_->showHint({}); });
    work->start();
}

void MainWindow::openScreenshotDialog()
{
    (new ScreenshotDialog(*this))->show();
}

void MainWindow::openPrintDialog()
{
    auto* dialog = findChild<PrintDialog*>();
    if (!dialog) dialog = new PrintDialog(makePrintDesk(), new ShownViews(*this), this);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

}  // namespace vitrine::ui
