#include "ui/export/screenshot.h"

#include "render/image/image_io.h"
#include "render/image/srgb.h"
#include "ui/export/picture_export.h"
#include "ui/kit/progress_job.h"
#include "ui/kit/text.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::ui {
namespace {

/// Returns the cause of problems of writing screenshots.
QString screenshotCause()
{
    return QStringLiteral("screenshot");
}

/// Converts a picture of the screen to linear light. `writePicture` restores each pixel's code exactly.
render::Image linearPicture(const QImage& shown)
{
    std::array<float, 256> light{};
    for (std::size_t code = 0; code < light.size(); ++code)
        light[code] = static_cast<float>(render::linearFromSrgb(static_cast<double>(code) / 255));
    const QImage codes = shown.convertToFormat(QImage::Format_RGB888);
    render::Image picture(codes.width(), codes.height(), 3);
    float* to = picture.pixels.data();
    for (int y = 0; y < codes.height(); ++y) {
        const uchar* from = codes.constScanLine(y);
        for (int i = 0; i < 3 * codes.width(); ++i) *to++ = light[from[i]];
    }
    return picture;
}

void saySaved(Workbench& window, const QString& path)
{
    window.setProblems(screenshotCause(), {});
    window.say(MessageStrip::Mood::notice, QObject::tr("Screenshot saved to %1.").arg(path),
               QObject::tr("%1 screenshots saved, the last one to %2."), path, path);
}

/// Writes the picture on the screen on another thread. `refined` then replaces it.
void writeAtOnce(Workbench& window, QObject& parent, PictureExport& refined)
{
    auto* job = new ProgressJob(&parent);
    QObject::connect(job, &ProgressJob::failed, &parent, [&window, job, &refined](const QString& why) {
        window.setProblems(screenshotCause(), {});
        window.setProblems(screenshotCause(), {why});
        refined.cancel();
        job->deleteLater();
    });
    job->start([&window, job, &refined, path = refined.path(), preset = refined.preset(),
                shown = window.viewport().pictures().shown().image()](const ProgressJob::Progress&) {
        render::writePicture(path, linearPicture(shown), render::PictureFormat::png8, {preset, {}, 0});
        return [&window, job, &refined, path] {
            saySaved(window, QString::fromStdString(path.string()));
            refined.start();
            job->deleteLater();
        };
    });
}

}  // namespace

void saveScreenshot(Workbench& window, QObject& parent)
{
    const std::string_view name = window.museum().subject(window.chosen()).name();
    ExportRequest exportRequest;
    exportRequest.path = freeScreenshotPath(parent, text(name));
    Viewport& viewport = window.viewport();
    const double ratio = viewport.devicePixelRatioF();
    exportRequest.size = {std::max(1, static_cast<int>(std::lround(viewport.width() * ratio))),
                          std::max(1, static_cast<int>(std::lround(viewport.height() * ratio)))};
    exportRequest.samples = viewport.pictures().schedule().samples();
    exportRequest.asShown = viewport.pictures().finished();
    exportRequest.replaces = !exportRequest.asShown && !viewport.pictures().shown().image().isNull();
    auto* work = new PictureExport(window, exportRequest, &parent);
    QObject::connect(work, &PictureExport::failed, &parent, [&window](const QString& why) {
        window.setProblems(screenshotCause(), {});
        window.setProblems(screenshotCause(), {why});
    });
    if (exportRequest.replaces) {
        writeAtOnce(window, parent, *work);
        return;
    }
    QObject::connect(work, &PictureExport::finished, &parent,
                     [&window](const QString& path) { saySaved(window, path); });
    work->start();
}

}  // namespace vitrine::ui
