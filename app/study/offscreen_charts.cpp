#include "app/study/offscreen_charts.h"

#include "render/failure.h"
#include "ui/kit/theme.h"

#include <QApplication>

#include <clocale>

namespace vitrine::app {

void prepareOffscreenCharts()
{
    static int count = 1;
    static char name[] = "vitrine";
    static char* arguments[] = {name, nullptr};
    if (QApplication::instance()) return;
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {
    });  // Messages about the missing display are dropped.
    static QApplication application(count, arguments);
    std::setlocale(LC_NUMERIC, "C");  // Qt sets the user's locale.
    ui::applyTheme(application, ui::lightTheme());
}

void requireChart(const QByteArray& png, const std::filesystem::path& folder)
{
    if (png.isEmpty())
        throw Failure(
            ErrorKind::file,
            folder.string() +
                ": the chart could not be drawn; check that Qt's offscreen platform and a font are installed.");
}

}  // namespace vitrine::app
