// Draws the panel and the window into pictures, dark and light, to look at: show_window FOLDER.
#include "painted_gallery.h"

#include "ui/main_window.h"
#include "ui/parameter_panel.h"
#include "ui/theme.h"
#include "ui/viewport.h"

#include <QApplication>
#include <QDockWidget>
#include <QTimer>

#include <clocale>

using namespace vitrine;

int main(int argc, char** argv)
{
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QString folder = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral(".");
    for (const bool dark : {true, false}) {
        ui::applyTheme(app, dark ? ui::darkTheme() : ui::lightTheme());
        test::PaintedGallery gallery;
        gallery.shaderProblems = {{"sdf_morph/march.frag", 42, "'hitDistance' : undeclared identifier"}};
        ui::MainWindow window(gallery);
        window.show();
        window.visit(1);
        Look look = window.history().look();
        look.values[1].set(gallery.table(1).roughness, 0.61);
        look.values[1].set(gallery.table(1).stepLimit, 200);
        window.history().change(QStringLiteral("Change roughness"), look);
        window.say(ui::MessageStrip::Mood::problem, QStringLiteral("Preset shiny.json, line 4, key \"roughnes\": there is no such parameter; did you mean \"roughness\"? Everything stays as it was."));
        window.say(ui::MessageStrip::Mood::notice, QStringLiteral("Screenshot saved to ~/Pictures/sdf_morph-2026-11-21-103512.png"));
        for (auto* dock : window.findChildren<QDockWidget*>()) if (dock->objectName() == QLatin1String("ledger")) dock->show();
        QTimer::singleShot(2500, &app, &QApplication::quit);
        QApplication::exec();
        window.grab().save(folder + (dark ? QStringLiteral("/window_dark.png") : QStringLiteral("/window_light.png")));
        std::printf("pictures drawn: %lld\n", window.viewport().picturesDrawn());
    }
}
