#include "ui/export/picture_export.h"

#include "exhibits/museum/picture_settings.h"
#include "render/failure.h"
#include "render/measure/memory.h"
#include "ui/kit/message_of.h"
#include "ui/kit/time_left.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QDateTime>
#include <QDir>
#include <QPointer>
#include <QStandardPaths>

#include <algorithm>

namespace vitrine::ui {

std::filesystem::path freeScreenshotPath(const QObject& window, const QString& exhibit)
{
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
    QDir().mkpath(folder.path());
    const QString stem = exhibit + QDateTime::currentDateTime().toString(QStringLiteral("-yyyy-MM-dd-HHmmss"));
    QString name = stem + QStringLiteral(".png");
    QStringList promised;
    for (const PictureExport* other : window.findChildren<PictureExport*>())
        promised << QString::fromStdString(other->path().filename().string());
    for (int i = 2; folder.exists(name) || promised.contains(name); ++i)
        name = QStringLiteral("%1-%2.png").arg(stem).arg(i);
    return folder.filePath(name).toStdString();
}

PictureExport::PictureExport(Workbench& window, ExportRequest exportRequest, QObject* parent)
    : QObject(parent), window_(window), exportRequest_(std::move(exportRequest)),
      preset_(pictureSettings(window.museum(), window.chosen(), window.history().sceneState(), request(), "Picture",
                              &window.history().sceneState().camera)),
      sceneState_(window.history().sceneState()), request_(request())
{
}

PictureExport::~PictureExport()
{
    cancel();
}

PictureRequest PictureExport::request() const
{
    PictureRequest request;
    request.frame.camera = widened(window_.history().sceneState().camera,
                                   static_cast<double>(exportRequest_.size.x) / std::max(exportRequest_.size.y, 1));
    request.frame.raster.size = exportRequest_.size;
    request.frame.time = window_.viewport().clock().time();
    request.frame.transparent = exportRequest_.transparent;
    if (exportRequest_.transparent) request.frame.cutOut = window_.chosen();
    request.frame.averageIn =
        render::fileFormat(exportRequest_.format).isLinear ? AverageIn::radiance : AverageIn::display;
    request.samples = exportRequest_.samples;
    request.largestTile = RenderThread::taskTile;
    return request;
}

void PictureExport::writeShown()
{
    window_.viewport().renderThread().post([self = QPointer(this), &renderers = window_.renderers(),
                                            exportRequest = exportRequest_,
                                            preset = preset_]() -> std::function<void()> {
        QString failure;
        try {
            render::PictureMetadata inside;
            inside.preset = preset;
            render::writePicture(exportRequest.path, renderers.shownPicture(), exportRequest.format, inside);
        } catch (const std::exception& thrown) {
            failure = messageOf(thrown);
        }
        return [self, failure] {
            if (self) self->end(failure);
        };
    });
}

void PictureExport::start()
{
    elapsed_.start();
    running_ = true;
    if (exportRequest_.asShown) {
        *stage_ = Stage::writing;
        writeShown();
        return;
    }
    struct Work {
        PictureJob job;
        QElapsedTimer told;
    };
    auto work = std::make_shared<Work>();
    auto step = [this, work, &renderers = window_.renderers(), stage = stage_, sceneState = sceneState_,
                 request = request_, exportRequest = exportRequest_,
                 preset = preset_](const RenderThread::Notify& notify) {
        if (!work->job.maker) work->job = renderers.makePicture(sceneState, request);
        if (!work->job.maker) throw Failure(ErrorKind::openGl, "No picture can be made: there is no graphics context.");
        PictureMaker& maker = *work->job.maker;
        maker.step();
        if (!work->told.isValid() || work->told.elapsed() >= RenderThread::tellEvery) {
            work->told.start();
            notify([this, part = maker.progress()] { note(part); });
        }
        if (!maker.finished()) return true;
        Stage drawing = Stage::drawing;
        if (!stage->compare_exchange_strong(drawing, Stage::writing)) return false;
        render::PictureMetadata inside;
        inside.preset = preset;
        render::writePicture(exportRequest.path, maker.picture(), exportRequest.format, inside);
        work->job = {};
        render::trimHeap();
        return false;
    };
    task_ = window_.viewport().renderThread().start(std::move(step), [this](const QString& failure) { end(failure); });
}

bool PictureExport::cancel()
{
    Stage drawing = Stage::drawing;
    if (!stage_->compare_exchange_strong(drawing, Stage::canceled)) return drawing == Stage::canceled;
    task_.cancel();
    running_ = false;
    deleteLater();
    return true;
}

void PictureExport::note(double part)
{
    emit progressed(part, secondsLeft(part, elapsed_));
}

void PictureExport::end(const QString& failure)
{
    running_ = false;
    if (failure.isEmpty()) {
        emit progressed(1, 0);
        emit finished(QString::fromStdString(exportRequest_.path.string()));
    } else {
        emit failed(failure);
    }
    deleteLater();
}

}  // namespace vitrine::ui

#include "moc_picture_export.cpp"
