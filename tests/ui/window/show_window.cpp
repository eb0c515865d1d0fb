// Draws pictures of the window, dark and light, for inspection: show_window FOLDER [museum | tree | compare | explore |
// lessons | documents]. "museum" shows the real one, "tree" its exhibits with trees, "compare" two of its settings,
// "explore" its pad and nine variations, "lessons" a step of each lesson and the pages, "documents" only the two
// pictures of the README files, dark. Otherwise a gallery of one color is shown, with every kind of parameter.
#include "tests/ui/painted_gallery.h"
#include "tests/ui/study/small_studies.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/tree.h"
#include "ui/charts/charts_dock.h"
#include "ui/compare/compare_controller.h"
#include "ui/compare/picture_b.h"
#include "ui/explore/explore_dock.h"
#include "ui/explore/morph_pad.h"
#include "ui/explore/variations.h"
#include "ui/kit/theme.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/lessons/page_dialog.h"
#include "ui/parameters/color_picker.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/print/eyes_preview.h"
#include "ui/print/print_dialog.h"
#include "ui/study/study_dock.h"
#include "ui/tree/tree_dock.h"
#include "ui/tree/tree_overlay.h"
#include "ui/viewport/museum_renderers.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QDockWidget>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <clocale>
#include <cstdio>

using namespace vitrine;

namespace {

void waitUntilStill(const ui::MainWindow& window, int mostMilliseconds)
{
    QElapsedTimer passed;
    passed.start();
    do QApplication::processEvents(QEventLoop::AllEvents, 50);
    while (passed.elapsed() < mostMilliseconds &&
           (passed.elapsed() < 1200 || !window.viewport().pictures().schedule().still()));
}

/// Shows all exhibits with trees; the node in the middle of the picture is selected.
void showTrees(ui::MainWindow& window, const Museum& museum, const QString& folder, const QString& ending)
{
    for (const MuseumExhibit& each : museum.exhibits()) {
        if (!capability<HasTree>(each.exhibit)) continue;
        window.visit(each.index);
        waitUntilStill(window, 120000);
        const QPointF middle(window.viewport().width() / 2.0, window.viewport().height() / 2.0);
        for (const auto& [mode, name] :
             {std::pair{ui::HandleMode::move, "move"}, std::pair{ui::HandleMode::turn, "turn"}}) {
            window.docks().tree().overlay().setMode(mode);
            emit window.viewport().interaction().shapeClicked(each.index, middle);
            waitUntilStill(window, 60000);
            window.grab().save(folder + QStringLiteral("/tree_%1_%2").arg(each.index).arg(QLatin1String(name)) +
                               ending);
        }
    }
}

/// Shows the torus beside the mug in all modes of the comparison.
void showComparison(ui::MainWindow& window, const QString& folder, const QString& ending)
{
    window.visit(1);
    window.comparison().setToCurrent();
    const auto row = window.history().sceneState().values[1].table().find("morph");
    window.history().set(1, *row, 0.1, ui::newGesture());
    for (auto* dock : window.findChildren<QDockWidget*>())
        if (dock->objectName() == QLatin1String("frame-report")) dock->show();
    int number = 0;
    for (const ui::CompareMode mode : ui::compareModes) {
        window.comparison().setMode(mode);
        QElapsedTimer passed;
        passed.start();
        while (passed.elapsed() < 120000 && (!window.comparison().picture().finished() || passed.elapsed() < 3000))
            waitUntilStill(window, 1300);
        window.grab().save(folder + QStringLiteral("/compare_%1").arg(++number) + ending);
    }
}

/// Shows the torus among presets on the pad, and nine variations of it.
void showExploration(ui::MainWindow& window, const QString& folder, const QString& ending)
{
    window.resize(1280, 720);
    window.visit(1);
    waitUntilStill(window, 60000);
    auto* dock = window.findChild<QDockWidget*>(QStringLiteral("explore"));
    dock->show();
    dock->raise();
    QElapsedTimer passed;
    passed.start();
    const ui::ExploreDock& explore = window.docks().explore();
    while (passed.elapsed() < 240000 && explore.variations().finished() < ui::Variations::count)
        QApplication::processEvents(QEventLoop::AllEvents, 50);
    std::printf("nine variations: %.1f s\n", static_cast<double>(passed.elapsed()) / 1000);
    emit explore.pad().moved({0.4, 0.3}, ui::newGesture());
    explore.pad().show({0.4, 0.3}, false);
    waitUntilStill(window, 30000);
    window.grab().save(folder + QStringLiteral("/explore") + ending);
}

/// Shows the third step of every lesson, and the page about its exhibit.
void showLessons(ui::MainWindow& window, const Museum& museum, const QString& folder, const QString& ending)
{
    for (const MuseumExhibit& each : museum.exhibits()) {
        const QString name = QString::fromStdString(std::string(each.exhibit.name()));
        window.lessons().start(each.index);
        for (int i = 0; i < 3; ++i) window.lessons().next();
        waitUntilStill(window, 60000);
        window.grab().save(folder + QStringLiteral("/lesson_") + name + ending);
        window.dialogs().openPage(each.index);
        auto* page = window.findChild<ui::PageDialog*>();
        page->resize(760, 1400);
        QApplication::processEvents();
        page->grab().save(folder + QStringLiteral("/page_") + name + ending);
    }
    window.lessons().leave();
}

/// Shows the print dialog with views of the exhibit that is visited.
void showPrintDialog(ui::MainWindow& window, const QString& picture)
{
    window.dialogs().openPrint();
    auto* dialog = window.findChild<ui::PrintDialog*>();
    dialog->resize(1200, 680);
    dialog->setPath(QStringLiteral("/home/visitor/Pictures/lenticular-print.tif"));
    QElapsedTimer passed;
    passed.start();
    do QApplication::processEvents(QEventLoop::AllEvents, 50);
    while (passed.elapsed() < 120000 &&
           (passed.elapsed() < 3000 || !dialog->settled() || dialog->findChild<ui::EyesPreview*>()->seen(0).isNull()));
    dialog->grab().save(picture);
    std::printf("print dialog with rendered views: %.1f s\n", static_cast<double>(passed.elapsed()) / 1000);
}

/// Shows the window at the first exhibit with its frame report, and the print dialog, as the documents show them.
void showForDocuments(ui::MainWindow& window, const QString& folder)
{
    window.resize(1400, 860);
    window.visit(1);
    window.findChild<QDockWidget*>(QStringLiteral("frame-report"))->show();
    waitUntilStill(window, 240000);
    window.grab().save(folder + QStringLiteral("/window.png"));
    showPrintDialog(window, folder + QStringLiteral("/print_dialog.png"));
}

}  // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;
    for (const char* name : {"XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
        qputenv(name, home.path().toLocal8Bit());
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QString folder = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral(".");
    const bool real = argc > 2;
    const bool trees = real && QLatin1String(argv[2]) == QLatin1String("tree");
    std::unique_ptr<Museum> museum;
    if (real) museum = std::make_unique<Museum>(allExhibits());
    for (const bool dark : {true, false}) {
        const QString ending = dark ? QStringLiteral("_dark.png") : QStringLiteral("_light.png");
        ui::applyTheme(app, dark ? ui::darkTheme() : ui::lightTheme());
        std::unique_ptr<ui::Renderers> renderers;
        const Museum* shown = museum.get();
        if (real)
            renderers = std::make_unique<ui::MuseumRenderers>(*museum);
        else {
            auto painted = std::make_unique<test::PaintedGallery>();
            shown = &painted->museum();
            renderers = std::move(painted);
        }
        ui::MainWindow window(*shown, *renderers, ui::makeWindowActions);
        window.show();
        if (real && QLatin1String(argv[2]) == QLatin1String("documents")) {
            showForDocuments(window, folder);
            return 0;
        }
        if (trees) {
            showTrees(window, *museum, folder, ending);
            continue;
        }
        if (real && QLatin1String(argv[2]) == QLatin1String("lessons")) {
            showLessons(window, *museum, folder, ending);
            continue;
        }
        if (real && QLatin1String(argv[2]) == QLatin1String("explore")) {
            showExploration(window, folder, ending);
            continue;
        }
        if (real && QLatin1String(argv[2]) == QLatin1String("compare")) {
            showComparison(window, folder, ending);
            continue;
        }
        waitUntilStill(window, 60000);
        window.grab().save(folder + QStringLiteral("/entrance") + ending);
        std::printf("entrance: %lld pictures drawn\n", window.viewport().pictures().shown().pictures());
        window.visit(1);
        if (!real) {
            window.say(ui::MessageStrip::Mood::problem,
                       QStringLiteral("Preset shiny.json, line 4, key \"roughnes\": there is no such parameter. "
                                      "Everything stays as it was."));
            window.say(ui::MessageStrip::Mood::notice,
                       QStringLiteral("Screenshot saved to sdf_morph-2026-11-21-103512.png"));
        }
        for (auto* dock : window.findChildren<QDockWidget*>())
            if (dock->objectName() == QLatin1String("frame-report")) dock->show();
        waitUntilStill(window, 60000);
        window.grab().save(folder + QStringLiteral("/visit") + ending);
        if (!real) {
            for (auto* button : window.panel().row("baseColor")->findChildren<QAbstractButton*>())
                if (button->accessibleName().contains(QLatin1String("choose a color"))) button->click();
            auto* dialog = window.findChild<ui::ColorDialog*>();
            QApplication::processEvents();
            dialog->grab().save(folder + QStringLiteral("/color") + ending);
            dialog->reject();
        }
        if (real) {
            for (std::size_t i = 0; i < shown->subjects().size(); ++i) {
                if (capability<HasCharts>(shown->subject(i)) == nullptr) continue;
                auto* charts = window.findChild<ui::ChartsDock*>();
                window.visit(i);
                window.docks().showCharts();
                QEventLoop made;
                QObject::connect(charts, &ui::ChartsDock::renewed, &made, &QEventLoop::quit);
                if (charts->charts().empty()) made.exec();
                waitUntilStill(window, 60000);
                window.grab().save(folder + QStringLiteral("/charts_%1").arg(i) + ending);
            }
            window.visit(1);
            window.findChild<QDockWidget*>(QStringLiteral("study"))->show();
            window.findChild<QDockWidget*>(QStringLiteral("study"))->raise();
            test::setEffort(window.docks().study(), {240, 135}, 3);
            QEventLoop until;
            QObject::connect(&window.docks().study(), &ui::StudyDock::finished, &until, &QEventLoop::quit);
            window.docks().study().ask(1, *window.museum().subject(1).parameters().find("hitTolerance"));
            until.exec();
            waitUntilStill(window, 60000);
            window.grab().save(folder + QStringLiteral("/study") + ending);
            showPrintDialog(window, folder + QStringLiteral("/print") + ending);
        }
        std::printf("visit: %lld pictures drawn\n", window.viewport().pictures().shown().pictures());
    }
}
