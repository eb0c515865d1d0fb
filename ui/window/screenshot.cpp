#include "ui/window/screenshot.h"

#include "ui/kit/text.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"
#include "ui/window/picture_export.h"

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

void saveScreenshot(Workbench& window, QObject& parent)
{
    const std::string_view name = window.museum().subject(window.chosen()).name();
    ExportWish wish;
    wish.path = freeScreenshotPath(parent, text(name));
    Viewport& viewport = window.viewport();
    const double ratio = viewport.devicePixelRatioF();
    wish.size = {std::max(1, static_cast<int>(std::lround(viewport.width() * ratio))),
                 std::max(1, static_cast<int>(std::lround(viewport.height() * ratio)))};
    wish.samples = viewport.schedule().samples();
    wish.asShown = viewport.pictureFinished();
    auto* work = new PictureExport(window, wish, &parent);
    QObject::connect(work, &PictureExport::finished, &parent, [&window](const QString& path) {
        window.say(MessageStrip::Mood::notice, QObject::tr("Screenshot saved to %1.").arg(path),
                   QObject::tr("%1 screenshots saved, the last one to %2."), path, path);
    });
    QObject::connect(work, &PictureExport::failed, &parent,
                     [&window](const QString& why) { window.say(MessageStrip::Mood::problem, why); });
    const auto waitsFor = [&viewport](double part) {
        viewport.showHint(QObject::tr("The picture is not finished yet: drawing it for the screenshot, %1 %")
                              .arg(std::floor(part * 100)));
    };
    if (!wish.asShown) {
        QObject::connect(work, &PictureExport::progressed, &viewport, waitsFor);
        QObject::connect(work, &QObject::destroyed, &viewport, [&viewport] { viewport.showHint({}); });
        waitsFor(0);
    }
    work->start();
}

}  // namespace vitrine::ui
