// Files that come to the window and pictures that leave it.
#include "ui/window/main_window.h"

#include "exhibits/printing/print_json.h"
#include "render/failure.h"
#include "render/image/image_io.h"
#include "ui/presets/preset_shelf.h"
#include "ui/print/print_dialog.h"
#include "ui/print/shown_views.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/picture_export.h"
#include "ui/window/screenshot_dialog.h"

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

namespace {

/// Whether the file is a lenticular print or describes one.
bool isPrint(const QString& path)
{
    try {
        static_cast<void>(printing::savedSettings(printing::settingsIn(path.toStdString()), path.toStdString()));
        return true;
    } catch (const Failure&) {
        return false;
    }
}

}  // namespace

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
    // Reading a large file takes seconds.
    viewport_->renderThread().post([this, &gallery = gallery_, next, row = *row, path]() -> std::function<void()> {
        for (const std::string& why : gallery.unreadableFiles(next))
            if (why.starts_with(label(next.values[0].rows()[row]) + " of "))
                return [this, why] { say(MessageStrip::Mood::problem, tr("%1 Nothing was changed.").arg(QString::fromStdString(why))); };
        return [this, row, path, file = next.values[0].row(row)] {
            Look changed = history_.look();
            changed.values[0].setRow(row, file);
            history_.change(tr("Put %1 into the hall").arg(QFileInfo(path).fileName()), std::move(changed));
        };
    });
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
    if (ending == QLatin1String("json")) {
        if (isPrint(path)) openPrintDialog(path);
        else shelf_->loadFile(path);
    } else if (models.contains(ending)) {
        setHallFile("model", path);
    } else if (pictures.contains(ending)) {
        openPicture(path);
    } else {
        say(MessageStrip::Mood::problem,
            tr("%1 cannot be opened: it is none of .json, .glb, .gltf, .hdr, .exr, .png, .jpg, .tif.").arg(path));
    }
}

void MainWindow::openPicture(const QString& path)
{
    if (isPrint(path)) {
        openPrintDialog(path);
        return;
    }
    if (shelf_->loadFromPicture(path)) return;
    viewport_->renderThread().post([this, path]() -> std::function<void()> {
        const std::shared_ptr<const render::Texture> picture = render::loadTexture(path.toStdString(), true, true);
        if (std::abs(picture->width - 2 * picture->height) <= std::max(1, picture->height / 50)) return [this, path] { setHallFile("environment", path); };
        return [this, name = QFileInfo(path).fileName(), width = picture->width, height = picture->height] {
            say(MessageStrip::Mood::problem,
                tr("%1 was not put into the sky: it has %2 × %3 pixels, and a panorama of the whole sky is twice as wide as high. "
                   "To stretch it over the sky all the same, choose it for Environment of The hall.").arg(name).arg(width).arg(height));
        };
    });
}

void MainWindow::saveScreenshotNow()
{
    const std::string_view name = gallery_.exhibits()[chosen_]->name();
    ExportWish wish;
    wish.path = freeScreenshotPath(*this, QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
    wish.asShown = viewport_->pictureFinished();
    const double ratio = viewport_->devicePixelRatioF();
    wish.size = {std::max(1, static_cast<int>(std::lround(viewport_->width() * ratio))),
                 std::max(1, static_cast<int>(std::lround(viewport_->height() * ratio)))};
    wish.samples = viewport_->schedule().samples();
    auto* work = new PictureExport(*this, wish);
    connect(work, &PictureExport::finished, this,
            [this](const QString& path) {
                say(MessageStrip::Mood::notice, tr("Screenshot saved to %1.").arg(path), tr("%1 screenshots saved, the last one to %2."), path);
            });
    connect(work, &PictureExport::failed, this, [this](const QString& why) { say(MessageStrip::Mood::problem, why); });
    if (!wish.asShown) viewport_->showHint(tr("Drawing the screenshot …"));
    connect(work, &QObject::destroyed, viewport_, [this] { viewport_->showHint({}); });
    work->start();
}

void MainWindow::openScreenshotDialog()
{
    (new ScreenshotDialog(*this))->show();
}

void MainWindow::openPrintDialog(const QString& print)
{
    auto* dialog = findChild<PrintDialog*>();
    if (!dialog) dialog = new PrintDialog(new ShownViews(*this), this);
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
    if (!print.isEmpty()) dialog->open({print});
}

}  // namespace vitrine::ui
