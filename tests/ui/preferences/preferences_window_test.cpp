#include "tests/ui/cheap_pictures.h"
#include "tests/ui/preferences/open_preferences.h"
#include "tests/ui/ui_main.h"

#include "ui/export/copies.h"
#include "ui/kit/language.h"
#include "ui/kit/message_strip.h"
#include "ui/report/frame_report_dock.h"
#include "ui/window/recent_files.h"
#include "ui/window/window_docks.h"

#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QThread>
#include <QWheelEvent>

#include <cmath>

using namespace vitrine;
using namespace vitrine::ui;

/// All preferences except shortcuts, set in the dialog with keys and clicks, and their effect on the window.
class PreferencesWindowTest : public test::OpenPreferences {
    Q_OBJECT

    /// Returns the rotation of the view in radians by a drag of this many pixels: sideways and up.
    [[nodiscard]] glm::dvec2 turnOf(const QPoint& drag)
    {
        Viewport& viewport = window_->viewport();
        viewport.visitor().jumpTo({{1.35, 1.65, 10.2}, {1.35, 1.65, 0}, 0.96});
        const auto look = [this] {
            const render::Camera& camera = window_->history().sceneState().camera;
            return headingOf(camera.target - camera.eye);
        };
        const Heading before = look();
        const QPoint from(300, 200);
        QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
        QTest::mouseMove(&viewport, from + drag / 2);
        QTest::mouseMove(&viewport, from + drag);
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, from + drag);
        return {look().yaw - before.yaw, look().pitch - before.pitch};
    }
    [[nodiscard]] double zoomOf()
    {
        Viewport& viewport = window_->viewport();
        viewport.visitor().jumpTo({{0, 1.2, 6}, {0, 1, 0}, 0.96});
        const auto distance = [this] {
            const render::Camera& camera = window_->history().sceneState().camera;
            return glm::distance(camera.eye, camera.target);
        };
        const double before = distance();
        QWheelEvent turn(QPointF(200, 200), viewport.mapToGlobal(QPointF(200, 200)), {}, {0, 120}, {}, {},
                         Qt::NoScrollPhase, false);
        QApplication::sendEvent(&viewport, &turn);
        return distance() / before;
    }
    [[nodiscard]] QStringList said() { return window_->findChild<MessageStrip*>()->texts(); }

private slots:
    void initTestCase()
    {
        mostSamples_ = asTheHallRequests;
        prepare();
    }
    void init() { start(); }
    void cleanup()
    {
        finish();
        lookLikeNothingWasChosen();
    }

    void longTheThemeIsAppliedAtOnceKeptAndReset()
    {
        QVERIFY(openDialog());
        choose("Theme", "High contrast");
        QVERIFY(theme().highContrast);
        QCOMPARE(QApplication::palette().color(QPalette::WindowText), theme().text);
        QCOMPARE(Preferences::saved().theme, ThemeChoice::highContrast);
        closeWindow();
        openWindow();
        QCOMPARE(values().theme, ThemeChoice::highContrast);
        QVERIFY(openDialog());
        reset("Reset Theme");
        QVERIFY(!theme().highContrast);
        QCOMPARE(Preferences::saved().theme, ThemeChoice::desktop);
    }

    void theLanguageIsKeptForTheNextStartAndReset()
    {
        QVERIFY(openDialog());
        choose("Language", "Deutsch");
        QCOMPARE(savedLanguage(), QString("de"));
        choose("Theme", "Light");  // Writes the same file.
        QCOMPARE(savedLanguage(), QString("de"));
        reset("Reset Language");
        QCOMPARE(savedLanguage(), QString());
        QCOMPARE(control<QComboBox>("Language")->currentIndex(), 0);
        QCOMPARE(Preferences::saved().theme, ThemeChoice::light);
    }

    void longTypeOfAnotherSizeIsEverywhereAtOnce()
    {
        PreferencesDialog* dialog = openDialog();
        QVERIFY(dialog);
        window_->choose(1);
        const double points = QApplication::font().pointSizeF();
        const int row = window_->panel().row("roughness")->height();
        const int label = dialog->findChild<QLabel*>()->fontMetrics().height();
        type("Size of type", 200);
        QCOMPARE(QApplication::font().pointSizeF(), 2 * points);
        QTRY_VERIFY(window_->panel().row("roughness")->height() >= 1.7 * row);
        QVERIFY(dialog->findChild<QLabel*>()->fontMetrics().height() >= 1.7 * label);
        QCOMPARE(Preferences::saved().typeSize, 200);
        reset("Reset Size of type");
        QCOMPARE(QApplication::font().pointSizeF(), points);
        QTRY_COMPARE(window_->panel().row("roughness")->height(), row);
    }

    void thePointerTurnsAsFastAndTheWayRoundThatIsPreferred()
    {
        QVERIFY(openDialog("Picture and mouse"));
        const glm::dvec2 usual = turnOf({60, 40});
        QVERIFY(usual.x != 0 && usual.y < 0);
        type("Speed of looking", 200);
        const glm::dvec2 fast = turnOf({60, 40});
        QVERIFY2(std::abs(fast.x / usual.x - 2) < 1e-6, qPrintable(QString::number(fast.x / usual.x)));
        auto* inverted = control<QCheckBox>("Dragging down looks up");
        QTest::mouseClick(inverted, Qt::LeftButton, {}, QPoint(8, inverted->height() / 2));
        QVERIFY(values().invertedLook);
        const glm::dvec2 other = turnOf({60, 40});
        QCOMPARE(other.x, fast.x);
        QVERIFY(std::abs(other.y + fast.y) < 1e-9);
        reset("Reset Speed of looking");
        reset("Reset Dragging down looks up");
        QVERIFY(std::abs(turnOf({60, 40}).y - usual.y) < 1e-9);
    }

    void theWheelGoesAsFarAsIsPreferred()
    {
        QVERIFY(openDialog("Picture and mouse"));
        const double usual = zoomOf();
        QVERIFY(usual < 1);
        type("Speed of the wheel", 300);
        QVERIFY2(std::abs(zoomOf() - std::pow(usual, 3)) < 1e-9, qPrintable(QString::number(zoomOf())));
    }

    void longFewerSamplesAreDrawnAndStatusFrameReportAndCommandLineSaySo()
    {
        test::takeFewSamples(*window_, 8);
        settle();
        QVERIFY(openDialog("Picture and mouse"));
        choose("Samples when idle", "2 at most");
        QCOMPARE(values().mostSamples, 2);
        QTRY_VERIFY(window_->viewport().pictures().schedule().still() &&
                    window_->viewport().pictures().schedule().samples() == 2);
        gallery_->forgetRequests();
        window_->viewport().scene().change();
        settle();
        QVERIFY(!gallery_->requests().empty());
        for (const FrameRequest& request : gallery_->requests()) QVERIFY(request.samples <= 2);
        const QString reason = window_->viewport().pictures().reason();
        QVERIFY2(reason.startsWith("Done (2 samples)") && reason.contains("the hall requests 8") &&
                     reason.contains("allow 2"),
                 qPrintable(reason));
        action("Frame report")->trigger();
        window_->viewport().scene().change();
        settle();
        QTRY_COMPARE(window_->docks().frameReport().reasonText(), reason);
        QVERIFY2(commandLineOf(*window_).contains("--samples 2 "), qPrintable(commandLineOf(*window_)));
        // The hall's parameter stays unchanged.
        QCOMPARE(pictureQuality(window_->history().sceneState().hall()).supersamples, 8);
        choose("Samples when idle", "As set in the hall");
        QTRY_VERIFY(window_->viewport().pictures().schedule().still() &&
                    window_->viewport().pictures().schedule().samples() == 8);
        QVERIFY(!window_->viewport().pictures().reason().contains("preferences"));
    }

    void longAPictureInMotionIsNeverCoarserThanIsPreferred()
    {
        QVERIFY(openDialog("Picture and mouse"));
        choose("Resolution in motion", "50 % at least");
        gallery_->beforeDrawing = [](const FrameRequest&, const auto&) { QThread::msleep(300); };  // A slow machine.
        gallery_->forgetRequests();
        Viewport& viewport = window_->viewport();
        viewport.setFocus();
        QTest::keyPress(&viewport, Qt::Key_A);
        QTRY_COMPARE(viewport.pictures().schedule().scaleWhileMoving(), 0.5);
        QTRY_VERIFY(gallery_->requests().size() >= 6);
        QTest::keyRelease(&viewport, Qt::Key_A);
        QCOMPARE(viewport.pictures().schedule().scaleWhileMoving(), 0.5);
        for (const FrameRequest& request : gallery_->requests())
            QVERIFY(request.raster.size.x >= viewport.width() / 2 - 1);
        settle();
        gallery_->beforeDrawing = {};
    }

    void longReducedMotionCutsWhereTheCameraWouldGlideAndHoldsTheClock()
    {
        gallery_->exhibit().moves = true;
        QVERIFY(openDialog());
        choose("Motion", "Reduced");
        QVERIFY(reducedMotion() && !window_->isAnimated());
        QVERIFY(action("Pause clock")->isChecked());
        settle();
        const double stood = window_->viewport().clock().time();
        gallery_->forgetRequests();
        window_->visit(1);
        QCOMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);  // Immediately.
        settle();
        QCOMPARE(window_->viewport().clock().time(), stood);
        const std::vector<FrameRequest> drawn = gallery_->requests();
        QVERIFY(!drawn.empty());
        for (const FrameRequest& request : drawn) QVERIFY(request.camera == drawn.back().camera);
        QVERIFY(drawn.front().resetHistory);  // The history is discarded.
        QTest::keyClick(&window_->viewport(), Qt::Key_Escape);
        QCOMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::walk);
        window_->viewport().visitor().goBack();
        QCOMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        // A visitor who presses a button wants to see its effect.
        window_->viewport().interaction().press();
        QVERIFY(!action("Pause clock")->isChecked());
        QTRY_VERIFY(window_->viewport().clock().time() > stood);
        gallery_->exhibit().moves = false;
        choose("Motion", "Full");
        QVERIFY(!reducedMotion() && window_->isAnimated());
        window_->visit(0);
        QCOMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::glide);
    }

    void aClockThatTheVisitorStoppedIsNotStartedByFullMotion()
    {
        QVERIFY(openDialog());
        choose("Motion", "Reduced");
        QVERIFY(action("Pause clock")->isChecked());
        choose("Motion", "Full");
        QVERIFY(!action("Pause clock")->isChecked());  // It was stopped only for this reason.
        action("Pause clock")->trigger();
        choose("Motion", "Reduced");
        choose("Motion", "Full");
        QVERIFY(action("Pause clock")->isChecked());
    }

    void longTheDesktopsWishesAreFollowedWhileTheWindowIsOpen()
    {
        const QString address = qEnvironmentVariable("DBUS_SESSION_BUS_ADDRESS");
        if (address.isEmpty()) QSKIP("There is no dbus-daemon here.");
        closeWindow();
        test::FakePortal desktop(QDBusConnection::connectToBus(address, "desktop"));
        desktop.settings[test::FakePortal::appearance] = {{"color-scheme", 2U}, {"contrast", 1U}};
        openWindow();
        QTRY_COMPARE(theme(), highContrastTheme(false));
        QVERIFY(!reducedMotion());
        desktop.change(test::FakePortal::gnome, "enable-animations", false);
        QTRY_VERIFY(reducedMotion());
        desktop.change(test::FakePortal::appearance, "color-scheme", 1U);
        QTRY_COMPARE(theme(), highContrastTheme(true));
        desktop.change(test::FakePortal::appearance, "contrast", 0U);
        QTRY_COMPARE(theme(), darkTheme());
        // The visitor's own choice has priority.
        QVERIFY(openDialog());
        choose("Motion", "Full");
        QVERIFY(!reducedMotion());
        desktop.change(test::FakePortal::gnome, "enable-animations", true);
    }

    void asManyRecentFilesAreKeptAsArePreferredAndTheListIsCleared()
    {
        for (int i = 0; i < 6; ++i) {
            QFile file(home_->filePath(QString("scene%1.json").arg(i)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            addRecentFile(file.fileName());
        }
        QCOMPARE(recentFiles().size(), 6);
        QVERIFY(openDialog("Files"));
        type("Recent files", 2);
        QCOMPARE(recentFiles().size(), 2);
        QVERIFY(recentFiles().front().endsWith("scene5.json"));
        addRecentFile(home_->filePath("scene0.json"));
        QCOMPARE(recentFiles().size(), 2);
        QVERIFY(recentFiles().front().endsWith("scene0.json"));
        QMenu* menu = nullptr;
        for (QMenu* each : window_->findChildren<QMenu*>())
            if (each->title() == "Open &recent") menu = each;
        QVERIFY(menu);
        emit menu->aboutToShow();
        QCOMPARE(menu->actions().back()->text(), QString("&Clear the list"));
        menu->actions().back()->trigger();
        QVERIFY(recentFiles().isEmpty());
        addRecentFile(home_->filePath("scene1.json"));
        QTest::mouseClick(button("Clear the list now"), Qt::LeftButton);
        QVERIFY(recentFiles().isEmpty());
        type("Recent files", 0);
        addRecentFile(home_->filePath("scene1.json"));
        QVERIFY(recentFiles().isEmpty());
    }

    void longDamagedPreferencesAreSaidOnceInTheWindow()
    {
        closeWindow();
        const QString path = home_->filePath("vitrine/window.ini");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("theme=plaid\ntypeSize=9000\n[keys]\nquit=Nonsense+9\n");
        file.close();
        openWindow();
        QVERIFY(values() == PreferenceValues());
        const QStringList told = said().filter("window.ini");
        QCOMPARE(told.size(), 1);
        for (const char* name : {"theme", "typeSize", "keys/quit"}) QVERIFY2(told.front().contains(name), name);
    }
};

VITRINE_ADD_TEST(PreferencesWindowTest, &test::runWithBus<PreferencesWindowTest>)

#include "preferences_window_test.moc"
