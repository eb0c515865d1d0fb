#include "tests/ui/open_window.h"

#include "ui/kit/message_strip.h"
#include "ui/kit/theme.h"
#include "ui/kit/tile_delegate.h"
#include "ui/parameters/color_picker.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/value_slider.h"
#include "ui/presets/preset_list.h"
#include "ui/presets/preset_shelf.h"
#include "ui/viewport/gl_probe.h"
#include "ui/viewport/viewport.h"
#include "ui/window/command_palette.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/file_opener.h"
#include "ui/window/ledger_view.h"
#include "ui/window/log_view.h"
#include "ui/window/main_window.h"
#include "ui/window/status_line.h"
#include "ui/window/theme_choice.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <clocale>
#include <future>
#include <memory>
#include <set>
#include <thread>

#include <QSignalSpy>

using namespace vitrine;
using namespace vitrine::ui;

/// The whole window on a real OpenGL context, over a gallery whose picture is one color.
class WindowTest : public test::OpenWindow {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void oneMoveOfTheMouseStartsThePictureAnewOnce()
    {
        window_->choose(1);
        settle();
        const auto before = static_cast<std::ptrdiff_t>(gallery_->requests().size());
        QSignalSpy changed(&window_->history(), &History::changed);
        auto* slider = in<ValueSlider>("roughness");
        QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() - 20, slider->height() / 2});
        QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() - 20, slider->height() / 2});
        settle();
        QCOMPARE(changed.count(), 1);
        const std::vector<FrameRequest> requests = gallery_->requests();
        const glm::ivec2 whole = requests.back().raster.size;
        const auto full = std::count_if(requests.begin() + before, requests.end(), [&](const FrameRequest& request) {
            return request.sample == 0 && request.raster.size == whole;
        });
        QCOMPARE(full, 1);
    }

    void aColorIsChosenBesideThePicture()
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

    void anIdleWindowDrawsNothing()
    {
        settle();
        QTest::qWait(300);
        const long long drawn = window_->viewport().picturesDrawn();
        QTest::qWait(2000);
        QCOMPARE(window_->viewport().picturesDrawn(), drawn);
        QVERIFY(window_->findChild<StatusLine*>()->text().contains("nothing to draw, because nothing changes"));
    }

    void aStillPictureIsRefinedOverSixteenSamples()
    {
        gallery_->forgetRequests();
        window_->viewport().lookChanged();
        QTRY_VERIFY(gallery_->requests().size() >= 16);
        settle();
        QCOMPARE(gallery_->requests().back().sample, 15);
        QCOMPARE(gallery_->requests().back().samples, 16);
    }

    void theVisitorWalksAndWallsStopHim()
    {
        Viewport& viewport = window_->viewport();
        viewport.setFocus();
        viewport.jumpTo({{1.35, 1.65, 10.2}, {1.35, 1.65, 12}, 0.96});
        QTest::keyPress(&viewport, Qt::Key_W);
        QTRY_VERIFY(window_->history().look().camera.eye.z > 10.7);
        QTest::qWait(2500);  // Long enough to be far outside.
        QTest::keyRelease(&viewport, Qt::Key_W);
        settle();
        QVERIFY(window_->history().look().camera.eye.z < 12 - 0.27);  // A visitor is 0.28 m wide to each side.
        QCOMPARE(window_->history().stack().count(), 0);
    }

    void aClickVisitsAnExhibitDraggingOrbitsAndEscWalksOn()
    {
        Viewport& viewport = window_->viewport();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.rect().center());
        QTRY_COMPARE(viewport.mode(), CameraControl::Mode::orbit);
        QCOMPARE(window_->chosen(), std::size_t{1});
        const glm::dvec3 eye = window_->history().look().camera.eye;
        QTest::mousePress(&viewport, Qt::LeftButton, {}, {200, 200});
        QTest::mouseMove(&viewport, {240, 200});
        QTest::mouseMove(&viewport, {280, 200});
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, {280, 200});
        QVERIFY(window_->history().look().camera.eye.x < eye.x);
        QTest::keyClick(&viewport, Qt::Key_Escape);
        QTRY_COMPARE(viewport.mode(), CameraControl::Mode::walk);
    }

    void aPresetIsSavedAndTheNextSessionLoadsIt()
    {
        window_->choose(1);
        dragRoughness(60);
        const double saved = roughness();
        window_->shelf().saveUnder("Dull");
        closeWindow();
        openWindow();
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(roughness(), saved);  // The last session comes back by itself ...
        QVERIFY(!window_->history().stack().canUndo());
        action("Reset all parameters")->trigger();
        QCOMPARE(roughness(), 0.25);
        QCOMPARE(rowsNamed("Dull").size(), 1);
        window_->shelf().load(rowsNamed("Dull").front()->data(Qt::UserRole).toString());
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
        window_->shelf().saveUnder("Zz, the last by name");
        QCOMPARE(list->count(), shipped + 1);
        QCOMPARE(list->item(0)->text(), QString("Zz, the last by name"));
        QCOMPARE(list->item(0)->data(TileDelegate::secondLine).toString(), QString("Yours"));
        for (int i = 1; i < list->count(); ++i)
            QCOMPARE(list->item(i)->data(TileDelegate::secondLine).toString(), QString());
    }

    void theThemeIsChosenInTheViewMenuAndKept()
    {
        QVERIFY(theme().dark);
        action("Light")->trigger();
        QVERIFY(!theme().dark);
        QVERIFY(QApplication::palette().color(QPalette::Window) == lightTheme().window);
        closeWindow();
        openWindow();
        QVERIFY(action("Light")->isChecked());
        QCOMPARE(savedThemeChoice(), ThemeChoice::light);
        action("Dark")->trigger();
        QVERIFY(theme().dark);
        QCOMPARE(savedThemeChoice(), ThemeChoice::dark);
    }

    void theLedgerNamesExhibitsByTheirTitles()
    {
        LedgerView ledger;
        ledger.setTitles({{"sdf_morph", "Torus to mug"}});
        ledger.show();
        render::FrameReport report;
        report.ran = {{.name = "sdf_morph/cone", .reason = "it saves steps"}, {.name = "tonemap", .reason = "always"}};
        ledger.note(report);
        report.skipped.push_back({.name = "sdf_morph", .reason = "out of view"});
        ledger.note(report);
        QTRY_COMPARE(ledger.topLevelItemCount(), 3);
        QCOMPARE(ledger.topLevelItem(2)->text(0), QString("Torus to mug"));
        QCOMPARE(ledger.topLevelItem(0)->text(0), QString("Torus to mug: cone"));
        QCOMPARE(ledger.topLevelItem(0)->toolTip(0), QString("sdf_morph/cone"));
        QCOMPARE(ledger.topLevelItem(1)->text(0), QString("tonemap"));
    }

    void aDeletedPresetComesBackByUndo()
    {
        window_->choose(1);
        window_->shelf().saveUnder("Dull");
        QCOMPARE(rowsNamed("Dull").size(), 1);
        auto* list = window_->findChild<PresetList*>()->findChild<QListWidget*>();
        list->setCurrentItem(rowsNamed("Dull").front());
        window_->shelf().remove();
        QCOMPARE(rowsNamed("Dull").size(), 0);
        window_->history().stack().undo();
        QCOMPARE(rowsNamed("Dull").size(), 1);
        window_->history().stack().redo();
        QCOMPARE(rowsNamed("Dull").size(), 0);
    }

    void aBrokenPresetChangesNothingAndSaysWhere()
    {
        window_->choose(1);
        const Look before = window_->history().look();
        QFile file(home_->filePath("broken.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\n \"format\": \"vitrine-preset\", \"version\": 1, \"exhibit\": \"sdf_morph\",\n \"values\": "
                   "{\"roughness\": \"very\"}}\n");
        file.close();
        window_->files().open(file.fileName());
        QVERIFY(window_->history().look() == before);
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
        // The journal of a process that is no longer there.
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

    void tabHidesEverythingAndBringsItBack()
    {
        auto* dock = window_->findChild<QDockWidget*>("parameters");
        QVERIFY(dock->isVisible());
        window_->viewport().setFocus();
        QApplication::setActiveWindow(window_.get());  // No window manager does it under Xvfb.
        QTest::keyClick(&window_->viewport(), Qt::Key_Tab);
        QTRY_VERIFY(!dock->isVisible());
        QTest::keyClick(&window_->viewport(), Qt::Key_Tab);
        QTRY_VERIFY(dock->isVisible());
        QVERIFY(!window_->findChild<QDockWidget*>("ledger")->isVisible());  // Was closed, stays closed.
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
             {"Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+S", "Ctrl+Shift+S", "Ctrl+O", "Ctrl+F", "Ctrl+Shift+P", "Space",
              "Pause", "F12", "Ctrl+Shift+E", "Ctrl+B", "F11", "F1", "?", "Tab"})
            QVERIFY2(keys.contains(key), key);
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

    void aShaderProblemIsShownOverThePicture()
    {
        gallery_->shaderProblems = {{"sdf_morph/march.frag", 42, "'hitDistance' : undeclared identifier"}};
        window_->viewport().reloadShaders();
        const auto shown = [&] {
            const auto labels = window_->viewport().findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
                return label->isVisible() && label->text().contains("sdf_morph/march.frag:42");
            });
        };
        QTRY_VERIFY(shown());
    }

    void messagesStayUntilDismissedAndAreListedOnce()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        window_->say(MessageStrip::Mood::problem, "<b>not bold</b>");
        window_->say(MessageStrip::Mood::problem, "<b>not bold</b>");
        QCOMPARE(strip->texts(), QStringList{"<b>not bold</b>"});
        for (QLabel* label : strip->findChildren<QLabel*>()) QCOMPARE(label->textFormat(), Qt::PlainText);
        strip->dismissAll();
        QTRY_VERIFY(!strip->isVisible());
    }

    void messagesLieOverThePictureAndNoticesOfOneKindBecomeOne()
    {
        settle();
        auto* strip = window_->findChild<MessageStrip*>();
        const QSize before = window_->viewport().size();
        const long long drawn = window_->viewport().picturesDrawn();
        for (int i = 1; i <= 4; ++i)
            window_->say(MessageStrip::Mood::notice, QString("Screenshot saved to %1.png.").arg(i),
                         "%1 screenshots saved, the last one to %2.", QString("%1.png").arg(i));
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        QCOMPARE(strip->texts(), (QStringList{"4 screenshots saved, the last one to 4.png.", "The disk is full."}));
        QTRY_VERIFY(strip->isVisible());
        QTest::qWait(100);
        QCOMPARE(window_->viewport().size(), before);
        QCOMPARE(window_->viewport().picturesDrawn(), drawn);  // The same picture: nothing to refine again.
        QCOMPARE(strip->mapToGlobal(QPoint(0, 0)), window_->viewport().mapToGlobal(QPoint(0, 0)));
        QCOMPARE(strip->width(), window_->viewport().width());
    }

    void noticesGoByThemselvesAndProblemsStay()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        QCursor::setPos(window_->mapToGlobal(window_->rect().bottomRight() -
                                             QPoint(5, 5)));  // Not on the strip: there, notices stay.
        strip->setNoticeTime(50);
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        window_->say(MessageStrip::Mood::notice, "Saved.");
        QTRY_COMPARE(strip->texts(), QStringList{"The disk is full."});
        QTest::qWait(300);
        QCOMPARE(strip->texts(), QStringList{"The disk is full."});
    }

    void theBarePictureHidesMessages()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        QTRY_VERIFY(strip->isVisible());
        window_->hidePanels(true);
        QVERIFY(!strip->isVisible());
        window_->say(MessageStrip::Mood::problem, "The other disk, too.");
        QVERIFY(!strip->isVisible());
        window_->hidePanels(false);
        QVERIFY(strip->isVisible());
        QCOMPARE(strip->texts().size(), 2);
    }

    void aRowThatDoesNotActDrawsNothingAgain()
    {
        window_->choose(1);
        Look next = window_->history().look();
        next.values[1].set(gallery_->table().animated, false);
        window_->history().change("Stand still", next);
        settle();
        const long long drawn = window_->viewport().picturesDrawn();
        next.values[1].set(gallery_->table().speed, 3.0);  // Acts only while it is animated.
        window_->history().change("Change speed", next);
        QTest::qWait(300);
        QCOMPARE(window_->viewport().picturesDrawn(), drawn);
        next.values[1].set(gallery_->table().animated, true);
        window_->history().change("Move", next);
        QTRY_VERIFY(window_->viewport().picturesDrawn() > drawn);
    }

    void badInputIsOneLineInTheLogHoweverManyFramesItLasts()
    {
        window_->choose(1);
        const auto lines = [&] {
            return window_->findChild<LogView*>()->toPlainText().count(
                QStringLiteral("fur/clock: the time is no number"));
        };
        bool up = true;
        const auto drawFrames = [&](std::vector<render::Skipped> complaints) {
            gallery_->complaints = std::move(complaints);
            const auto before = gallery_->requests().size();
            dragRoughness(up ? 60 : 20);
            up = !up;
            QTRY_VERIFY(gallery_->requests().size() > before + 2);
            settle();
        };
        const render::Skipped wrong{.name = "fur/clock",
                                    .reason = "the time is no number",
                                    .work = render::Work::simulation,
                                    .complaint = true};
        drawFrames({});
        QCOMPARE(lines(), 0);
        drawFrames({wrong});
        drawFrames({wrong});
        QCOMPARE(lines(), 1);
        drawFrames({});
        drawFrames({wrong});
        QCOMPARE(lines(), 2);
    }

    void aNewWindowAroundThePictureShowsItAndLeavesWhatDrawsItAlone()
    {
        // Without shared contexts a new top-level window means a new context for the widget.
        const QColor before = window_->viewport().grabFramebuffer().pixelColor(20, 20);
        auto* other = new QWidget;
        QWidget* home = window_->viewport().parentWidget();
        window_->viewport().setParent(other);
        other->resize(320, 240);
        window_->viewport().resize(320, 240);
        window_->viewport().show();
        other->show();
        QVERIFY(QTest::qWaitForWindowExposed(other, vitrine::test::patience));
        QTRY_COMPARE(window_->viewport().shown().size(), QSize(320, 240));
        settle();
        QCOMPARE(window_->viewport().grabFramebuffer().pixelColor(20, 20), before);
        QCOMPARE(gallery_->opened, 1);
        QCOMPARE(gallery_->closed, 0);
        window_->viewport().setParent(home);
        delete other;
    }

    void theWindowsThreadDrawsNothing()
    {
        window_->choose(1);
        dragRoughness(60);
        window_->visit(1);
        settle();
        QVERIFY(!gallery_->requests().empty());
        QVERIFY(gallery_->thread != std::this_thread::get_id());
        QCOMPARE(gallery_->strangers, 0);
    }

    void untilTheFirstPictureTheViewportSaysThatItComes()
    {
        closeWindow();
        gallery_ = std::make_unique<test::PaintedGallery>();
        std::atomic<bool> held = true;
        gallery_->beforeDrawing = [&](const FrameRequest&, const Renderers::Unwanted&) {
            while (held) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        };
        window_ = std::make_unique<MainWindow>(gallery_->museum(), *gallery_);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), test::patience));
        const auto colors = [&] {
            const QImage picture = window_->viewport().grabFramebuffer();
            std::set<QRgb> found;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x) found.insert(picture.pixel(x, y));
            return found.size();
        };
        const auto opening = colors();
        held = false;
        settle();
        QVERIFY2(opening > 3, "no words");
        QCOMPARE(colors(), std::size_t(1));
    }

    void aPictureThatTakesLongHoldsNothingUpAndTheNewestComesNext()
    {
        window_->choose(1);
        settle();
        std::promise<void> begun, enough;
        std::shared_future<void> released = enough.get_future().share();
        std::atomic<int> pictures = 0;
        gallery_->beforeDrawing = [&](const FrameRequest&, const Renderers::Unwanted&) {
            if (++pictures != 1) return;
            begun.set_value();
            released.wait();
        };
        dragRoughness(10);
        QTRY_VERIFY(pictures == 1);
        begun.get_future().wait();
        // The window goes on: every one of these is another picture to draw, and none can be drawn.
        double last = roughness();
        for (const int pixels : {30, 50, 40, 60}) {
            dragRoughness(pixels);
            QVERIFY(roughness() != last);
            last = roughness();
        }
        action("About Vitrine")->trigger();
        QCOMPARE(pictures, 1);
        gallery_->forgetRequests();
        enough.set_value();
        QTRY_VERIFY(gallery_->requests().size() >= 2);
        // The held one ends, and the next one is of the newest value: the four between are never drawn.
        QTRY_VERIFY(window_->viewport().schedule().current());
        settle();
        QCOMPARE(window_->viewport().shown().pixelColor(20, 20).red(),
                 QColor::fromRgbF(static_cast<float>(last), 0, 0).red());
        QVERIFY2(pictures <= 2 + 16, qPrintable(QString::number(pictures)));
        gallery_->beforeDrawing = {};
    }

    void anOutdatedSupersampleIsGivenUp()
    {
        window_->choose(1);
        settle();
        std::atomic<int> abandoned = 0;
        std::atomic<bool> reached = false;
        gallery_->beforeDrawing = [&](const FrameRequest& request, const Renderers::Unwanted& unwanted) {
            if (request.sample != 3 || abandoned > 0) return;
            reached = true;
            while (!unwanted()) std::this_thread::yield();
            ++abandoned;
            throw render::gl::Abandoned();
        };
        window_->viewport().lookChanged();
        QTRY_VERIFY(reached);
        dragRoughness(60);
        QTRY_COMPARE(int(abandoned), 1);
        settle();
        QCOMPARE(window_->viewport().shown().pixelColor(20, 20).red(),
                 QColor::fromRgbF(static_cast<float>(roughness()), 0, 0).red());
        QVERIFY(window_->findChild<MessageStrip*>()->texts().isEmpty());
        gallery_->beforeDrawing = {};
    }

    void whatIsAskedOfOneMomentIsPreparedOnce()
    {
        Viewport& viewport = window_->viewport();
        settle();
        const long long before = viewport.preparations();
        viewport.jumpTo(test::PaintedGallery::towardsButton(1.2));  // Which button he looks at, and what moves.
        settle();
        QCOMPARE(viewport.preparations(), before + 1);
        QTest::mouseMove(&viewport, viewport.rect().center());
        QTRY_COMPARE(viewport.cursor().shape(), Qt::PointingHandCursor);
        QCOMPARE(viewport.preparations(), before + 1);
    }

    void whatMovesFarAwayNeitherCoarsensNorRestartsThePicture()
    {
        window_->choose(1);
        Look alight = window_->history().look();  // A shadow on the floor would move, too.
        alight.hall().setRow(*alight.hall().table().find("sunShadows"), 0.0);
        window_->history().change("Without shadows", alight);
        settle();
        const QImage before = window_->viewport().shown();
        const int height = before.height();
        FrameRequest request = gallery_->requests().back();
        request.raster.size = {before.width(), height};
        const Museum& museum = gallery_->museum();
        gallery_->exhibit().moves = true;
        const PictureRegion region =
            museum.movingRegion(museum.prepare(window_->history().look(), request), request).value();
        QVERIFY(region.size.x > 10 && region.size.y > 10 && 4 * region.size.x < before.width());
        window_->viewport().lookChanged();
        QTRY_VERIFY(window_->viewport().regionsDrawn() >= 2);
        const long long whole = window_->viewport().picturesDrawn();
        const auto requests = gallery_->requests();
        QVERIFY(std::none_of(requests.end() - 1, requests.end(),
                             [](const FrameRequest& r) { return r.raster.size.x < 100; }));
        const QImage now = window_->viewport().shown();
        QCOMPARE(now.size(), before.size());
        int moved = 0, elsewhere = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < now.width(); ++x) {
                if (now.pixel(x, y) == before.pixel(x, y)) continue;
                const glm::ivec2 place = glm::ivec2(x, height - 1 - y) - region.offset;
                const bool within = glm::all(glm::greaterThanEqual(place, glm::ivec2(0))) &&
                                    glm::all(glm::lessThan(place, region.size));
                ++(within ? moved : elsewhere);
            }
        QCOMPARE(moved, region.size.x * region.size.y);
        QCOMPARE(elsewhere, 0);
        const long long regions = window_->viewport().regionsDrawn();
        QTRY_VERIFY(window_->viewport().regionsDrawn() > regions);
        gallery_->exhibit().moves = false;  // It has come to rest.
        QTest::qWait(500);
        const long long rested = window_->viewport().regionsDrawn();
        const long long refined = window_->viewport().picturesDrawn();
        QVERIFY(refined - whole <= 16);
        QVERIFY(window_->viewport().schedule().still());
        QTest::qWait(500);
        QCOMPARE(window_->viewport().regionsDrawn(), rested);
        QCOMPARE(window_->viewport().picturesDrawn(), refined);
        // A screenshot of it is drawn apart: the picture behind is of another moment.
        QVERIFY(!window_->viewport().pictureFinished());
    }
};

QTEST_MAIN(WindowTest)

#include "window_test.moc"
