// Draws pictures of the print dialog, dark and light, for inspection: show_print_dialog FOLDER [VIEWS...]. Views are
// pictures or a folder; without them, painted ones are used.
#include "tests/ui/print/painted_views.h"

#include "exhibits/exhibits.h"
#include "ui/kit/theme.h"
#include "ui/print/eyes_preview.h"
#include "ui/print/print_dialog.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <clocale>
#include <cstdio>

using namespace vitrine;

namespace {

void waitUntilSettled(const ui::PrintDialog& dialog)
{
    QElapsedTimer passed;
    passed.start();
    do QApplication::processEvents(QEventLoop::AllEvents, 50);
    while (passed.elapsed() < 30000 && (passed.elapsed() < 1500 || !dialog.settled()));
}

}  // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;
    for (const char* name : {"XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
        qputenv(name, home.path().toLocal8Bit());
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QString folder = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral(".");
    QStringList views;
    for (int i = 2; i < argc; ++i) views << QString::fromLocal8Bit(argv[i]);
    if (views.isEmpty()) views = test::paintedViews(home.path(), 12);
    for (const bool dark : {true, false}) {
        const QString ending = dark ? QStringLiteral("_dark.png") : QStringLiteral("_light.png");
        ui::applyTheme(app, dark ? ui::darkTheme() : ui::lightTheme());
        ui::PrintDialog dialog(nullptr, nullptr);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.setPath(QStringLiteral("/home/visitor/Pictures/lenticular-print.tif"));
        dialog.show();
        dialog.openFiles(views);
        dialog.findChild<ui::EyesPreview*>()->look(0.1, 0);
        waitUntilSettled(dialog);
        dialog.grab().save(folder + QStringLiteral("/print") + ending);
        QElapsedTimer turning;
        turning.start();
        for (int i = 1; i <= 20; ++i) {
            auto* eyes = dialog.findChild<ui::EyesPreview*>();
            const double angle = 0.1 + i * 0.005;
            eyes->look(angle, 0);
            while (eyes->shownAngle() != angle) QApplication::processEvents(QEventLoop::AllEvents, 5);
        }
        std::printf("both eyes, while dragging: %.1f ms\n", static_cast<double>(turning.elapsed()) / 20);
        dialog.setChart(true);
        waitUntilSettled(dialog);
        dialog.grab().save(folder + QStringLiteral("/chart") + ending);
    }
}
