#include "ui/window/picture_export.h"

#include "render/measure/memory.h"
#include "ui/kit/message_of.h"
#include "ui/presets/preset_shelf.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QDateTime>
#include <QDir>
#include <QStandardPaths>

#include <algorithm>

namespace vitrine::ui {
namespace {

bool isLinear(render::PictureFormat format)
{
    return format == render::PictureFormat::exr || format == render::PictureFormat::exrHalf;
}

}  // namespace

std::filesystem::path freeScreenshotPath(const MainWindow& window, const QString& exhibit)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    QDir().mkpath(folder.path());
    const QString stem = exhibit + QDateTime::currentDateTime().toString(QStringLiteral("-yyyy-MM-dd-HHmmss"));
    QString name = stem + QStringLiteral(".png");
    QStringList promised;
    for (const PictureExport* other : window.findChildren<PictureExport*>()) promised << QString::fromStdString(other->path().filename().string());
    for (int i = 2; folder.exists(name) || promised.contains(name); ++i) name = QStringLiteral("%1-%2.png").arg(stem).arg(i);
    return folder.filePath(name).toStdString();
}

PictureExport::PictureExport(MainWindow& window, ExportWish wish)
    : QObject(&window), window_(window), wish_(std::move(wish)), preset_(window.shelf().lookText())
{
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &PictureExport::step);
    connect(&window.viewport(), &Viewport::contextClosing, this, [this] {
        job_ = {};
        fail(tr("%1 was not written: the graphics context was lost. Export again.").arg(QString::fromStdString(wish_.path.string())));
    });
}

PictureExport::~PictureExport()
{
    drop();
}

void PictureExport::drop()
{
    if (!job_.renderer) return;
    window_.viewport().withContext([this] { job_ = {}; });
    render::trimHeap();
}

void PictureExport::fail(const QString& why)
{
    timer_.stop();
    running_ = false;
    emit failed(why);
    deleteLater();
}

void PictureExport::start()
{
    PictureRequest request;
    request.frame.camera = widened(window_.history().look().camera, static_cast<double>(wish_.size.x) / std::max(wish_.size.y, 1));
    request.frame.raster.size = wish_.size;
    request.frame.time = window_.viewport().time();
    request.frame.transparent = wish_.transparent;
    if (wish_.transparent) request.frame.cutOut = window_.chosen();
    request.frame.averageIn = isLinear(wish_.format) ? AverageIn::radiance : AverageIn::display;
    request.samples = wish_.samples;
    const Look& look = window_.history().look();
    try {
        window_.viewport().withContext([&] { job_ = window_.gallery().makePicture(look, request); });
    } catch (const std::exception& failure) {
        fail(messageOf(failure));
        return;
    }
    elapsed_.start();
    running_ = true;
    timer_.start(0);
}

void PictureExport::cancel()
{
    running_ = false;
    timer_.stop();
    drop();
    deleteLater();
}

void PictureExport::step()
{
    if (!job_.maker) {
        fail(tr("No picture can be made before the first one is on the screen; try again then."));
        return;
    }
    try {
        window_.viewport().withContext([this] { job_.maker->step(); });
        if (job_.maker->finished()) {
            write();
            return;
        }
    } catch (const std::exception& failure) {
        fail(messageOf(failure));
        return;
    }
    const double part = job_.maker->progress();
    const double seconds = static_cast<double>(elapsed_.elapsed()) / 1000;
    emit progressed(part, part > 0.02 ? seconds / part * (1 - part) : -1);
    timer_.start(0);
}

void PictureExport::write()
{
    render::PictureMetadata inside;
    inside.preset = preset_;
    render::writePicture(wish_.path, job_.maker->picture(), wish_.format, inside);
    running_ = false;
    emit progressed(1, 0);
    emit finished(QString::fromStdString(wish_.path.string()));
    deleteLater();
}

}  // namespace vitrine::ui

#include "moc_picture_export.cpp"
