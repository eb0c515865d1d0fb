#include "painted_gallery.h"

#include "ui/command_palette.h"
#include "ui/exhibit_list.h"
#include "ui/gl_probe.h"
#include "ui/log_view.h"
#include "ui/main_window.h"
#include "ui/message_strip.h"
#include "ui/number_field.h"
#include "ui/parameter_panel.h"
#include "ui/parameter_row.h"
#include "ui/preset_list.h"
#include "ui/preset_shelf.h"
#include "ui/status_line.h"
#include "ui/theme.h"
#include "ui/value_slider.h"
#include "ui/viewport.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QListWidget>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <memory>

using namespace vitrine;
using namespace vitrine::ui;

/// The whole window on a real OpenGL context, over a gallery whose picture is one color.
class WindowTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<test::PaintedGallery> gallery_;
    std::unique_ptr<MainWindow> window_;

    void openWindow()
    {
        gallery_ = std::make_unique<test::PaintedGallery>();
        window_ = std::make_unique<MainWindow>(*gallery_);
        window_->resize(1200, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), vitrine::test::patience));
        settle();
    }
    void settle() { QTRY_VERIFY(window_->viewport().schedule().still()); }
    void closeWindow()
    {
        window_->close();
        window_.reset();
    }
    [[nodiscard]] int red() { return window_->viewport().grabFramebuffer().pixelColor(20, 20).red(); }
    [[nodiscard]] double roughness() { return window_->history().look().values[1][gallery_->table(1).roughness]; }
    /// The presets of that name; shipped ones are in the list, too.
    [[nodiscard]] QList<QListWidgetItem*> rowsNamed(const char* name)
    {
        return window_->findChild<PresetList*>()->findChild<QListWidget*>()->findItems(QString::fromLatin1(name), Qt::MatchExactly);
    }
    template <typename T> T* in(const char* row) { return window_->panel().row(row)->findChild<T*>(); }
    QAction* action(const char* text)
    {
        for (QAction* a : window_->findChildren<QAction*>())
            if (a->text().remove('&') == QLatin1String(text)) return a;
        return nullptr;
    }
    void dragRoughness(int pixels)
    {
        auto* slider = in<ValueSlider>("roughness");
        const QPoint from(12, slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        for (int x = 0; x <= pixels; x += 2) QTest::mouseMove(slider, from + QPoint(x, 0));
        QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(pixels, 0));
    }

private slots:
    void initTestCase()
    {
        std::setlocale(LC_NUMERIC, "C");
        applyTheme(*qApp, darkTheme());
        QVERIFY2(whyNoOpenGl().isEmpty(), qPrintable(whyNoOpenGl()));
    }
    void init()
    {
        // Every case has folders of its own; nothing of the user's is ever touched.
        home_ = std::make_unique<QTemporaryDir>();
        QVERIFY(home_->isValid());
        for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            qputenv(name, home_->path().toLocal8Bit());
        openWindow();
    }
    void cleanup()
    {
        if (window_) closeWindow();
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
        gallery_->requests.clear();
        window_->viewport().lookChanged();
        QTRY_VERIFY(gallery_->requests.size() >= 16);
        settle();
        QCOMPARE(gallery_->requests.back().sample, 15);
        QCOMPARE(gallery_->requests.back().samples, 16);
    }

    void theVisitorWalksAndWallsStopHim()
    {
        Viewport& viewport = window_->viewport();
        viewport.setFocus();
        const double start = window_->history().look().camera.eye.z;
        QTest::keyPress(&viewport, Qt::Key_W);
        QTRY_VERIFY(window_->history().look().camera.eye.z < start - 0.5);
        QTest::keyRelease(&viewport, Qt::Key_W);
        settle();
        QVERIFY(window_->history().look().camera.eye.z >= 2);  // The painted gallery's wall.
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
        window_->openFile(file.fileName());
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
        QTRY_VERIFY(!folder.entryList({"*.json"}, QDir::Files).isEmpty());
        const QString journal = folder.filePath(folder.entryList({"*.json"}, QDir::Files).first());
        QFile::copy(journal, folder.filePath("999999999-1.json"));
        closeWindow();
        QFile::remove(QString::fromLocal8Bit(qgetenv("XDG_STATE_HOME")) + "/vitrine/session.json");
        openWindow();
        QCOMPARE(roughness(), changed);
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("did not end by itself"));
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
        for (const char* key : {"Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y", "Ctrl+S", "Ctrl+Shift+S", "Ctrl+O", "Ctrl+F", "Ctrl+Shift+P",
                                "F5", "Ctrl+R", "Space", "Pause", "F12", "Ctrl+Shift+E", "Ctrl+B", "F11", "F1", "?", "Tab"})
            QVERIFY2(keys.contains(key), key);
    }

    void theWindowFitsASmallScreenWithAnyDockOpen()
    {
        window_->choose(1);
        for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
            const bool closed = dock->isHidden();
            dock->show();
            QTest::qWait(50);
            QVERIFY2(window_->minimumSizeHint().width() <= 1024, qPrintable(QString("%1: %2").arg(dock->objectName()).arg(window_->minimumSizeHint().width())));
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
                                    .arg(widget->metaObject()->className(), widget->parentWidget()->metaObject()->className())));
        }
    }

    void aShaderProblemIsShownOverThePicture()
    {
        gallery_->shaderProblems = {{"sdf_morph/march.frag", 42, "'hitDistance' : undeclared identifier"}};
        window_->viewport().reloadShaders();
        bool shown = false;
        for (QLabel* label : window_->viewport().findChildren<QLabel*>())
            shown = shown || (label->isVisible() && label->text().contains("sdf_morph/march.frag:42"));
        QVERIFY(shown);
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

    void badInputIsOneLineInTheLogHoweverManyFramesItLasts()
    {
        window_->choose(1);
        const auto lines = [&] { return window_->findChild<LogView*>()->toPlainText().count(QStringLiteral("fur/clock: the time is no number")); };
        bool up = true;
        const auto drawFrames = [&](std::vector<render::Skipped> complaints) {
            gallery_->complaints = std::move(complaints);
            const auto before = gallery_->requests.size();
            dragRoughness(up ? 60 : 20);
            up = !up;
            QTRY_VERIFY(gallery_->requests.size() > before + 2);
            settle();
        };
        const render::Skipped wrong{.name = "fur/clock", .reason = "the time is no number", .work = render::Work::simulation, .complaint = true};
        drawFrames({});
        QCOMPARE(lines(), 0);
        drawFrames({wrong});
        drawFrames({wrong});
        QCOMPARE(lines(), 1);
        drawFrames({});
        drawFrames({wrong});
        QCOMPARE(lines(), 2);
    }

    void aLostContextIsBuiltAgain()
    {
        // Without shared contexts a new top-level window means a new context.
        QCOMPARE(gallery_->opened, 1);
        auto* other = new QWidget;
        QWidget* home = window_->viewport().parentWidget();
        window_->viewport().setParent(other);
        other->resize(320, 240);
        window_->viewport().resize(320, 240);
        window_->viewport().show();
        other->show();
        QVERIFY(QTest::qWaitForWindowExposed(other, vitrine::test::patience));
        settle();
        QCOMPARE(gallery_->opened, gallery_->closed + 1);
        window_->viewport().setParent(home);
        delete other;
    }
};

QTEST_MAIN(WindowTest)

#include "window_test.moc"
