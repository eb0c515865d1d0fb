#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/jobs/picture/picture_table.h"
#include "render/measure/clock.h"
#include "ui/jobs/export_again.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/preferences.h"
#include "ui/kit/tile_delegate.h"
#include "ui/parameters/color_picker.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/panel_choices.h"
#include "ui/presets/preset_controller.h"
#include "ui/report/frame_report_view.h"
#include "ui/window/file_opener.h"

#include <QDir>
#include <QDockWidget>

#include <algorithm>
#include <limits>
#include <set>

using namespace vitrine;
using namespace vitrine::ui;

/// The whole window with a real OpenGL context, over a gallery whose picture has one color.
class WindowTest : public test::OpenWindow {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longAColorIsChosenBesideThePicture()
    {
        window_->choose(1);
        for (auto* button : window_->panel().row("baseColor")->findChildren<QAbstractButton*>())
            if (button->accessibleName().contains("choose a color")) button->click();
        auto* dialog = window_->findChild<ColorDialog*>();
        QVERIFY(dialog);
        const QRect picture(window_->viewport().mapToGlobal(QPoint(0, 0)), window_->viewport().size());
        QVERIFY(!dialog->geometry().intersects(picture.adjusted(picture.width() / 8, 0, -picture.width() / 8, 0)));
        dialog->reject();
    }

    void aRealSliderChangesThePictureAndUndoTakesItBack()
    {
        window_->choose(1);
        const int before = red();
        dragRoughness(60);
        QVERIFY(roughness() > 0.5);
        QTRY_VERIFY(red() > before + 60);
        QCOMPARE(window_->history().stack().count(), 1);
        action("Undo Change roughness")->trigger();
        QCOMPARE(roughness(), 0.25);
        QTRY_COMPARE(red(), before);
    }

    /// A viewport that cannot be seen yet is looked at again after 250 ms. When it is painted, it can be seen.
    void theFirstPictureIsOrderedWhenTheWindowIsPainted()
    {
        struct Painted final : QObject {
            double at = 0;
            bool eventFilter(QObject*, QEvent* event) override
            {
                if (event->type() == QEvent::Paint && at == 0) at = render::wallSeconds();
                return false;
            }
        };
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            closeWindow();
            gallery_ = std::make_unique<test::PaintedGallery>(kept_);
            window_ = std::make_unique<MainWindow>(gallery_->museum(), *gallery_, makeWindowActions);
            Painted painted;
            double ordered = 0;
            window_->viewport().installEventFilter(&painted);
            connect(&window_->viewport().pictures(), &ViewportPictures::arrived, this, [&](const DrawnPicture& p) {
                if (ordered == 0) ordered = render::wallSeconds() - p.seconds;
            });
            window_->show();
            QTRY_VERIFY(ordered > 0);
            least = std::min(least, ordered - painted.at);
            closeWindow();
            openWindow();
        }
        QVERIFY2(least < 0.15, qPrintable(QString::number(least)));
    }

    void aDragTellsMarksAndBarsOncePerTurnOfTheEventLoop()
    {
        window_->choose(1);
        settle();
        History& history = window_->history();
        // Makes the protected function accessible.
        struct Open : History {
            using QObject::receivers;
        };
        const int immediate = (history.*&Open::receivers)(SIGNAL(changed(std::size_t, std::size_t)));
        // Picture, B that follows A, tables from files, the session, and two sliders that start anew.
        QVERIFY2(immediate <= 6, qPrintable(QString::number(immediate)));
        QSignalSpy changed(&history, &History::changed),
            marked(&window_->presetController(), &PresetController::marked);
        QSignalSpy settled(&history, &History::changesSettled);
        const Gesture drag = newGesture();
        for (int i = 1; i <= 60; ++i) history.set(1, gallery_->table().roughness.row, 0.3 + i / 200.0, drag);
        QCOMPARE(changed.count(), 60);
        QCOMPARE(marked.count(), 0);
        QTRY_COMPARE(settled.count(), 1);
        QCOMPARE(marked.count(), 1);
        QVERIFY(settled[0][0].value<std::set<std::size_t>>() == std::set<std::size_t>{1});
        auto* slider = in<ValueSlider>("roughness");
        QCOMPARE(slider->value(), slider->minimum() + (slider->maximum() - slider->minimum()) * 6 / 10);
    }

    void longTheVisitorWalksAndWallsStopHim()
    {
        Viewport& viewport = window_->viewport();
        viewport.setFocus();
        viewport.visitor().jumpTo({{1.35, 1.65, 10.2}, {1.35, 1.65, 12}, 0.96});
        QTest::keyPress(&viewport, Qt::Key_W);
        QTRY_VERIFY(window_->history().sceneState().camera.eye.z > 10.7);
        QTest::qWait(2500);  // Long enough to get far outside.
        QTest::keyRelease(&viewport, Qt::Key_W);
        settle();
        QVERIFY(window_->history().sceneState().camera.eye.z < 12 - 0.27);  // A visitor reaches 0.28 m to each side.
        QCOMPARE(window_->history().stack().count(), 0);
    }

    void longAClickVisitsAnExhibitDraggingOrbitsAndEscWalksOn()
    {
        Viewport& viewport = window_->viewport();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.rect().center());
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::orbit);
        QCOMPARE(window_->chosen(), std::size_t{1});
        const glm::dvec3 eye = window_->history().sceneState().camera.eye;
        QTest::mousePress(&viewport, Qt::LeftButton, {}, {200, 200});
        QTest::mouseMove(&viewport, {240, 200});
        QTest::mouseMove(&viewport, {280, 200});
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, {280, 200});
        QVERIFY(window_->history().sceneState().camera.eye.x < eye.x);
        QTest::keyClick(&viewport, Qt::Key_Escape);
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::walk);
    }

    void aPresetIsSavedAndTheNextSessionLoadsIt()
    {
        window_->choose(1);
        dragRoughness(60);
        const double saved = roughness();
        window_->presetController().saveUnder("Dull");
        closeWindow();
        openWindow();
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(roughness(), saved);  // The last session is restored automatically ...
        QVERIFY(!window_->history().stack().canUndo());
        action("Reset all parameters")->trigger();
        QCOMPARE(roughness(), 0.25);
        QCOMPARE(rowsNamed("Dull").size(), 1);
        window_->presetController().load(rowsNamed("Dull").front()->data(Qt::UserRole).toString());
        QCOMPARE(roughness(), saved);  // ... and the preset from disk.
        window_->history().stack().undo();
        QCOMPARE(roughness(), 0.25);
    }

    void thePresetsOfTheVisitorStandFirstAndOnlyTheyAreMarked()
    {
        window_->choose(1);
        auto* list = window_->findChild<PresetList*>()->findChild<QListWidget*>();
        const int shipped = list->count();
        QVERIFY(shipped > 0);
        window_->presetController().saveUnder("Zz, the last by name");
        QCOMPARE(list->count(), shipped + 1);
        QCOMPARE(list->item(0)->text(), QString("Zz, the last by name"));
        QCOMPARE(list->item(0)->data(TileDelegate::secondLine).toString(), QString("Yours"));
        for (int i = 1; i < list->count(); ++i)
            QCOMPARE(list->item(i)->data(TileDelegate::secondLine).toString(), QString());
    }

    void longLockedParametersComeBackAndAreLeftOutWhenTheOthersAreVaried()
    {
        window_->choose(1);
        window_->panel().choices().set(PanelChoice::locked, {"sdf_morph/roughness"}, true);
        window_->panel().choices().set(PanelChoice::pinned, {"fur/comb"}, true);
        closeWindow();
        openWindow();
        QCOMPARE(window_->panel().choices().list(PanelChoice::locked), QStringList{"sdf_morph/roughness"});
        QCOMPARE(window_->panel().choices().list(PanelChoice::pinned), QStringList{"fur/comb"});
        window_->choose(1);
        const auto morph = [this] { return window_->history().sceneState().values[1][gallery_->table().morph]; };
        const double before = morph();
        action("Randomize parameters")->trigger();
        QCOMPARE(roughness(), 0.25);
        QVERIFY(morph() != before);
    }

    void theFrameReportNamesExhibitsByTheirTitles()
    {
        FrameReportView frameReport;
        frameReport.setTitles({{"sdf_morph", "Torus to mug"}});
        frameReport.show();
        render::FrameReport report;
        report.ran = {{.name = "sdf_morph/cone", .reason = "it saves steps"}, {.name = "tonemap", .reason = "always"}};
        frameReport.note(report);
        report.skipped.push_back({.name = "sdf_morph", .reason = "out of view"});
        frameReport.note(report);
        QTRY_COMPARE(frameReport.topLevelItemCount(), 3);
        QCOMPARE(frameReport.topLevelItem(2)->text(0), QString("Torus to mug"));
        QCOMPARE(frameReport.topLevelItem(0)->text(0), QString("Torus to mug: cone"));
        QCOMPARE(frameReport.topLevelItem(0)->toolTip(0), QString("sdf_morph/cone"));
        QCOMPARE(frameReport.topLevelItem(1)->text(0), QString("tonemap"));
    }

    void theFrameReportShowsTheWordsOfItsNarrowColumnsWhole()
    {
        FrameReportView frameReport;
        frameReport.show();
        render::FrameReport report;
        report.ran = {{.name = "tonemap", .reason = "always", .effects = {{.name = "flare"}}}};
        frameReport.note(report);
        QTRY_COMPARE(frameReport.topLevelItemCount(), 2);
        const QTreeWidgetItem* effect = frameReport.topLevelItem(1);
        QCOMPARE(effect->text(2), QString("in the step above"));
        QVERIFY(frameReport.fontMetrics().horizontalAdvance(effect->text(2)) < frameReport.columnWidth(2));
    }

    void aDeletedPresetComesBackByUndo()
    {
        window_->choose(1);
        window_->presetController().saveUnder("Dull");
        QCOMPARE(rowsNamed("Dull").size(), 1);
        auto* list = window_->findChild<PresetList*>()->findChild<QListWidget*>();
        list->setCurrentItem(rowsNamed("Dull").front());
        window_->presetController().remove();
        QCOMPARE(rowsNamed("Dull").size(), 0);
        window_->history().stack().undo();
        QCOMPARE(rowsNamed("Dull").size(), 1);
        window_->history().stack().redo();
        QCOMPARE(rowsNamed("Dull").size(), 0);
    }

    void aBrokenPresetChangesNothingAndSaysWhere()
    {
        window_->choose(1);
        const SceneState before = window_->history().sceneState();
        QFile file(home_->filePath("broken.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\n \"format\": \"vitrine-preset\", \"version\": 1, \"exhibit\": \"sdf_morph\",\n \"values\": "
                   "{\"roughness\": \"very\"}}\n");
        file.close();
        window_->files().open(file.fileName());
        QVERIFY(window_->history().sceneState() == before);
        const QStringList said = window_->findChild<MessageStrip*>()->texts();
        QCOMPARE(said.size(), 1);
        QVERIFY2(said[0].contains("broken.json") && said[0].contains("line 3") && said[0].contains("roughness"),
                 qPrintable(said[0]));
    }

    void aCrashedSessionComesBack()
    {
        window_->choose(1);
        in<NumberField>("roughness")->setFocus();
        dragRoughness(60);
        const double changed = roughness();
        // The journal of a process that has ended.
        const QDir folder(QString::fromLocal8Bit(qgetenv("XDG_STATE_HOME")) + "/vitrine/recovery");
        const auto journalPath = [&] { return folder.filePath(folder.entryList({"*.json"}, QDir::Files).value(0)); };
        const auto written = [&] {
            QFile file(journalPath());
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        QTRY_VERIFY(written().contains("roughness"));
        const QString journal = journalPath();
        QFile::copy(journal, folder.filePath("999999999-1.json"));
        closeWindow();
        QFile::remove(QString::fromLocal8Bit(qgetenv("XDG_STATE_HOME")) + "/vitrine/session.json");
        openWindow();
        QCOMPARE(roughness(), changed);
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("your last state was restored"));
        QVERIFY(folder.entryList({"999999999*"}, QDir::Files).isEmpty());
    }

    void theBarePictureComesAndGoesAndTabOnlyMovesTheFocus()
    {
        auto* dock = window_->findChild<QDockWidget*>("parameters");
        QVERIFY(dock->isVisible());
        window_->viewport().setFocus();
        QApplication::setActiveWindow(window_.get());  // Under Xvfb there is no window manager.
        QTest::keyClick(&window_->viewport(), Qt::Key_F11, Qt::ShiftModifier);
        QTRY_VERIFY(!dock->isVisible());
        QTest::keyClick(&window_->viewport(), Qt::Key_F11, Qt::ShiftModifier);
        QTRY_VERIFY(dock->isVisible());
        QVERIFY(
            !window_->findChild<QDockWidget*>("frame-report")->isVisible());  // It was closed before and stays closed.
        window_->viewport().setFocus();
        QTest::keyClick(&window_->viewport(), Qt::Key_Tab);
        QTRY_VERIFY(!window_->viewport().hasFocus());
        QVERIFY(dock->isVisible());
    }

    void collapsingTheViewportToNothingIsHarmless()
    {
        window_->viewport().setMinimumSize(0, 0);
        window_->viewport().resize(0, 0);
        QTest::qWait(50);
        window_->viewport().resize(1, 1);
        QTest::qWait(50);
        window_->viewport().resize(300, 200);
        settle();
    }

    void everyActionSaysWhatItDoesAndShortcutsAreNotAmbiguous()
    {
        QSet<QString> keys;
        int commands = 0;
        for (QAction* a : window_->findChildren<QAction*>()) {
            if (a->text().isEmpty() || a->menu() || !a->isVisible()) continue;
            for (const QKeySequence& key : a->shortcuts()) {
                QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString()));
                keys << key.toString();
                ++commands;
            }
        }
        QVERIFY(commands >= 20);
        for (const char* key :
             {"Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+S", "Ctrl+Shift+S", "Ctrl+O", "Ctrl+F", "Ctrl+K", "Space",
              "Pause", "F12", "Ctrl+Shift+E", "Ctrl+B", "F11", "F1", "?", "Shift+F11"})
            QVERIFY2(keys.contains(key), key);
    }

    void actionsWithNothingToDoAreGrayAndSayWhy()
    {
        window_->choose(1);
        for (const char* name :
             {"Save scene or shader as…", "Export picture again", "Export measurements…", "Back", "Rename preset",
              "Tags of preset…", "Duplicate preset", "Delete preset", "Export preset…"}) {
            QVERIFY2(!action(name)->isEnabled(), name);
            QVERIFY2(!action(name)->toolTip().isEmpty(), name);
        }
        const QString gray = action("Export picture again")->toolTip();
        QVERIFY2(gray.contains("No picture was exported yet"), qPrintable(gray));
        window_->again().note(jobs::pictureTable().initial(), {});
        QVERIFY(action("Export picture again")->isEnabled());
        QVERIFY(action("Export picture again")->toolTip() != gray);
        window_->visit(1);
        QVERIFY(action("Back")->isEnabled());
        QTRY_VERIFY(action("Press the exhibit's button")->isEnabled());
        action("Back")->trigger();
        QVERIFY(!action("Back")->isEnabled());
        presets()->setCurrentRow(0);
        QVERIFY(action("Rename preset")->isEnabled() && action("Export preset…")->isEnabled());
        QVERIFY(action("Import preset…")->isEnabled());
    }

    void theWindowFitsASmallScreenWithAnyDockOpen()
    {
        window_->choose(1);
        for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
            const bool closed = dock->isHidden();
            dock->show();
            QTest::qWait(50);
            QVERIFY2(window_->minimumSizeHint().width() <= 1024,
                     qPrintable(QString("%1: %2").arg(dock->objectName()).arg(window_->minimumSizeHint().width())));
            dock->setHidden(closed);
        }
    }

    void everyControlOfTheWindowHasAName()
    {
        window_->choose(1);
        for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) dock->show();
        window_->say(MessageStrip::Mood::notice, "Something happened.");
        for (QWidget* widget : window_->findChildren<QWidget*>()) {
            if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible() || !widget->isEnabled()) continue;
            if (widget->inherits("QScrollArea") || widget->objectName().startsWith("qt_")) continue;
            QVERIFY2(!widget->accessibleName().isEmpty(),
                     qPrintable(QString("%1 in %2")
                                    .arg(widget->metaObject()->className(),
                                         widget->parentWidget()->metaObject()->className())));
        }
    }
};

VITRINE_UI_TEST(WindowTest)

#include "window_test.moc"
