#include "tests/ui/open_window.h"
#include "tests/ui/point_at.h"
#include "tests/ui/ui_main.h"

#include "exhibits/museum/picture_settings.h"
#include "render/image/image_io.h"
#include "render/version.h"
#include "ui/compare/compare_controller.h"
#include "ui/export/picture_export.h"
#include "ui/kit/message_strip.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/number_field.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/scene_text.h"
#include "ui/viewport/overlay.h"
#include "ui/window/about_dialog.h"
#include "ui/window/exhibit_list.h"
#include "ui/window/file_opener.h"
#include "ui/window/parameter_tabs.h"
#include "ui/window/status_line.h"
#include "ui/window/visit_card.h"
#include "ui/window/window_docks.h"

#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QToolButton>

using namespace vitrine;
using namespace vitrine::ui;

/// Actions of a visitor in the window, with mouse and keys.
class VisitorTest : public test::OpenWindow {
    Q_OBJECT

    [[nodiscard]] QPoint at(double x, double y)
    {
        return {static_cast<int>(window_->viewport().width() * (x + 1) / 2),
                static_cast<int>(window_->viewport().height() * (1 - y) / 2)};
    }
    /// Returns the center of the exhibit's button in the picture.
    [[nodiscard]] QPoint button()
    {
        Viewport& viewport = window_->viewport();
        const glm::ivec2 size(viewport.width(), viewport.height());
        const render::View view = render::makeView(
            widened(window_->history().sceneState().camera, static_cast<double>(size.x) / size.y), {.size = size});
        const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(test::PaintedGallery::button(), 1);
        return at(clip.x / clip.w, clip.y / clip.w);
    }
    [[nodiscard]] QToolButton* search()
    {
        for (QToolButton* button : window_->docks().parameters().findChildren<QToolButton*>())
            if (button->accessibleName() == "Search") return button;
        return nullptr;
    }
    [[nodiscard]] QStringList overlays()
    {
        QStringList shown;
        for (const Overlay* overlay : window_->viewport().findChildren<Overlay*>())
            if (overlay->isVisible()) shown << overlay->text();
        return shown;
    }
    [[nodiscard]] QTabBar* tabs()
    {
        for (QTabBar* bar : window_->findChildren<QTabBar*>())
            if (bar->accessibleName() == "Parameters of") return bar;
        return nullptr;
    }
    [[nodiscard]] QStringList menu(const char* name)
    {
        QStringList entries;
        for (QAction* top : window_->menuBar()->actions())
            if (top->text().remove('&') == QLatin1String(name))
                for (QAction* entry : top->menu()->actions()) entries << entry->text().remove('&');
        return entries;
    }
    void activate() { QApplication::setActiveWindow(window_.get()); }  // Under Xvfb there is no window manager.

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void theViewMenuListsEveryPanelAndAParameterOpensAClosedOne()
    {
        for (const char* panel : {"Exhibits", "Presets", "Parameters", "Study", "Frame report"})
            QVERIFY2(menu("View").contains(QLatin1String(panel)), panel);
        auto* parameters = window_->findChild<QDockWidget*>("parameters");
        action("Parameters")->trigger();
        QVERIFY(!parameters->isVisible());
        activate();
        window_->showParameter(0, "exposure");
        QVERIFY(parameters->isVisible());
        QVERIFY(window_->panel().row("exposure")->isAncestorOf(QApplication::focusWidget()));
    }

    void longTheTabsOfExhibitAndHallAreThereAfterARestoredSession()
    {
        QVERIFY(tabs()->isVisible() && tabs()->height() >= 20);
        window_->choose(1);
        closeWindow();
        openWindow();
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(tabs()->count(), 2);
        QVERIFY2(tabs()->isVisible() && tabs()->height() >= 20, qPrintable(QString::number(tabs()->height())));
        for (int i = 0; i < 2; ++i)
            QVERIFY(tabs()->tabRect(i).width() > 20 && tabs()->rect().contains(tabs()->tabRect(i).center()));
        QTest::mouseClick(tabs(), Qt::LeftButton, {}, tabs()->tabRect(1).center());
        QCOMPARE(window_->shown(), std::size_t{0});
    }

    void aCrossMarksTheMiddleWhileTheKeyboardIsUsed()
    {
        Viewport& viewport = window_->viewport();
        const auto* cross = viewport.findChild<QWidget*>("crosshair");
        QVERIFY(cross && !cross->isVisible());
        activate();
        viewport.setFocus();
        QTest::keyClick(&viewport, Qt::Key_F12, Qt::ShiftModifier | Qt::AltModifier);  // Another key.
        QVERIFY(!cross->isVisible());
        QTest::keyClick(&viewport, Qt::Key_W);
        QVERIFY(cross->isVisible());
        const auto distance = [&] { return cross->geometry().center() - viewport.rect().center(); };
        QVERIFY(distance().manhattanLength() <= 2);
        // Two lines are drawn beside the middle, which stays open.
        QImage picture(cross->size(), QImage::Format_ARGB32);
        picture.fill(Qt::transparent);
        const_cast<QWidget*>(cross)->render(&picture, {}, {}, QWidget::DrawChildren);
        const QPoint middle = picture.rect().center();
        QCOMPARE(qAlpha(picture.pixel(middle)), 0);
        QVERIFY(qAlpha(picture.pixel(middle + QPoint(8, 0))) > 200);
        QVERIFY(qAlpha(picture.pixel(middle + QPoint(0, -8))) > 200);
        window_->resize(window_->width() + 60, window_->height());
        QTRY_VERIFY(distance().manhattanLength() <= 2);
        QTest::mouseMove(&viewport, at(0.3, 0.3));
        QTRY_VERIFY(!cross->isVisible());
        QTest::keyClick(&viewport, Qt::Key_Left, Qt::ControlModifier);
        QVERIFY(cross->isVisible());
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, at(0.9, 0.9));
        QVERIFY(!cross->isVisible());
    }

    void bracketsExposeByAQuarterOfAStopAndUndoTakesItBack()
    {
        const auto exposure = [this] {
            const ParameterValues& hall = window_->history().sceneState().hall();
            return std::get<double>(hall.row(*hall.table().find("exposure")));
        };
        activate();
        window_->viewport().setFocus();
        const double before = exposure();
        QTest::keyClick(&window_->viewport(), Qt::Key_BracketRight);
        QCOMPARE(exposure(), before + 0.25);
        for (int i = 0; i < 3; ++i) QTest::keyClick(&window_->viewport(), Qt::Key_BracketLeft);
        QCOMPARE(exposure(), before - 0.5);
        window_->history().stack().undo();
        QCOMPARE(exposure(), before - 0.25);
        // In a field, the key is a character.
        window_->choose(1);
        auto* color = in<QLineEdit>("baseColor");
        color->setFocus();
        QTest::keyClick(color, Qt::Key_BracketRight);
        QCOMPARE(exposure(), before - 0.25);
    }

    void undoIsTheWindowsWhereNothingIsTyped()
    {
        window_->choose(1);
        activate();
        auto* color = in<QLineEdit>("baseColor");
        color->setFocus();
        color->selectAll();
        QTest::keyClicks(color, "#336699");
        QTest::keyClick(color, Qt::Key_Return);
        QCOMPARE(window_->history().stack().count(), 1);
        QTest::keyClick(color, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window_->history().stack().index(), 0);
        QTest::keyClick(color, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(window_->history().stack().index(), 1);
        // Incomplete text is undone by the field itself.
        QTest::keyClick(color, Qt::Key_End);
        QTest::keyClick(color, Qt::Key_Backspace);
        QTest::keyClick(color, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window_->history().stack().index(), 1);
        QCOMPARE(color->text(), QString("#336699"));

        auto* file = in<QLineEdit>("environment");
        file->setFocus();
        QTest::keyClicks(file, "/nowhere.hdr");
        QTest::keyClick(file, Qt::Key_Return);
        QCOMPARE(window_->history().stack().index(), 2);
        QTest::keyClick(file, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window_->history().stack().index(), 1);
    }

    void theFirstVisitOfAnExhibitOffersWhatCanBeDoneThereOnce()
    {
        const auto* card = window_->findChild<VisitCard*>();
        const auto press = [card](const char* face) {
            for (QToolButton* button : card->findChildren<QToolButton*>())
                if (button->text() == QLatin1String(face)) return QTest::mouseClick(button, Qt::LeftButton);
            QFAIL(face);
        };
        QVERIFY2(!card->isVisible(), "the hall has the hint of the first start");
        window_->visit(1);
        QVERIFY(card->isVisible() && window_->viewport().rect().contains(card->geometry()));
        press("Compare");
        QVERIFY(!card->isVisible());
        QVERIFY(window_->comparison().other().isSet());
        window_->visit(0);
        window_->visit(1);
        QVERIFY2(!card->isVisible(), "once for each exhibit");

        // Each start has a home of its own here: in the same one, the next window knows the exhibit, too.
        closeWindow();
        openWindow();
        card = window_->findChild<VisitCard*>();
        window_->visit(0);
        window_->visit(1);
        QVERIFY(!card->isVisible());
    }

    void aChangedValueAndTheBarePictureHideTheCardOfTheFirstVisit()
    {
        const auto* card = window_->findChild<VisitCard*>();
        window_->hidePanels(true);
        window_->visit(1);
        QVERIFY(!card->isVisible());
        window_->hidePanels(false);
        window_->visit(0);
        window_->visit(1);
        QVERIFY2(card->isVisible(), "a visit of the bare picture does not count");
        dragRoughness(30);
        QTRY_VERIFY(!card->isVisible());
    }

    void pointingNamesWhatAClickVisitsAndAWallIsNothing()
    {
        Viewport& viewport = window_->viewport();
        vitrine::test::pointAt(viewport, at(0, 0));
        QTRY_VERIFY(overlays().contains("Torus to mug"));
        QCOMPARE(viewport.cursor().shape(), Qt::PointingHandCursor);
        vitrine::test::pointAt(viewport, at(-0.8, 0.6));
        QTRY_VERIFY(!overlays().contains("Torus to mug"));
        QVERIFY(viewport.cursor().shape() != Qt::PointingHandCursor);
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, at(-0.8, 0.6));
        QCOMPARE(viewport.visitor().mode(), CameraControl::Mode::walk);
        QCOMPARE(window_->chosen(), std::size_t{0});
    }

    void longAClickOnAButtonWithinReachPressesIt()
    {
        Viewport& viewport = window_->viewport();
        QSignalSpy pressed(&viewport.interaction(), &Interaction::pressed);
        viewport.visitor().jumpTo(test::PaintedGallery::towardsButton(1.2));
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, button());
        QCOMPARE(pressed.count(), 1);
        QCOMPARE(viewport.visitor().mode(), CameraControl::Mode::walk);
        viewport.visitor().jumpTo(test::PaintedGallery::towardsButton(3));  // From far away, the first click visits ...
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, button());
        QCOMPARE(pressed.count(), 1);
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::orbit);
        settle();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, button());  // ... and the second one presses.
        QCOMPARE(pressed.count(), 2);
        QTest::keyClick(&viewport, Qt::Key_E);
        QCOMPARE(pressed.count(), 3);
    }

    void longADisabledButtonIsNotPressedAndSaysWhy()
    {
        const char* reason = "Nothing in this scene moves with time; choose another scene.";
        Viewport& viewport = window_->viewport();
        QAction* press = action("Press the exhibit's button");
        QSignalSpy pressed(&viewport.interaction(), &Interaction::pressed);
        viewport.visitor().jumpTo(test::PaintedGallery::towardsButton(1.2));
        QTRY_VERIFY(overlays().contains("E – melt it"));
        QTRY_VERIFY2(press->isEnabled(), "the control");

        gallery_->exhibit().disabled = reason;
        viewport.visitor().jumpTo(test::PaintedGallery::towardsButton(1.1));
        QTRY_VERIFY(!press->isEnabled());
        QCOMPARE(press->toolTip(), QString(reason));
        QVERIFY(!overlays().contains("E – melt it"));
        QTest::keyClick(&viewport, Qt::Key_E);
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, button());
        QCOMPARE(pressed.count(), 0);
        vitrine::test::pointAt(viewport, button());
        QTRY_VERIFY(overlays().contains(reason));
        QVERIFY(viewport.accessibleText().contains(reason));

        window_->visit(1);
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::orbit);
        settle();
        QTRY_COMPARE(press->toolTip(), QString(reason));
        QTest::keyClick(&viewport, Qt::Key_E);
        QCOMPARE(pressed.count(), 0);
        gallery_->exhibit().disabled = {};
        QTest::keyClick(&viewport, Qt::Key_E);
        QCOMPARE(pressed.count(), 1);
    }

    void longAfterAWrongClickThereIsAWayBack()
    {
        Viewport& viewport = window_->viewport();
        const render::Camera before = window_->history().sceneState().camera;
        QVERIFY(!viewport.visitor().canGoBack());
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, at(0, 0));
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::orbit);
        QCOMPARE(window_->chosen(), std::size_t{1});
        QTest::keyClick(&viewport, Qt::Key_Backspace);
        QTRY_COMPARE(viewport.visitor().mode(), CameraControl::Mode::walk);
        QVERIFY(window_->history().sceneState().camera == before);
        QCOMPARE(window_->chosen(), std::size_t{0});
        QVERIFY(!viewport.visitor().canGoBack());
        QVERIFY(action("Back")->shortcuts().contains(QKeySequence("Alt+Left")));
    }

    void theFirstWindowFitsItsScreen()
    {
        for (const QSize screen : {QSize(1280, 720), QSize(1366, 768), QSize(1024, 600)}) {
            const QSize size = firstWindowSize(screen);
            QVERIFY(size.width() <= screen.width() - 8 && size.height() <= screen.height() - 40);
        }
        QCOMPARE(firstWindowSize({3840, 2160}), QSize(1400, 860));
        // ... and nothing in the window needs more.
        QVERIFY2(window_->minimumSizeHint().height() <= firstWindowSize({1280, 720}).height(),
                 qPrintable(QString::number(window_->minimumSizeHint().height())));
        closeWindow();
        gallery_ = std::make_unique<test::PaintedGallery>();
        QDir(home_->path()).removeRecursively();
        window_ = std::make_unique<MainWindow>(gallery_->museum(), *gallery_, makeWindowActions);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), vitrine::test::patience));
        QCOMPARE(window_->size(), firstWindowSize(window_->screen()->availableSize()));
    }

    void aLookThatComesBackChoosesItsExhibit()
    {
        window_->choose(1);
        dragRoughness(60);
        QFile file(home_->filePath("exhibition.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(
            vitrine::ui::textOf(gallery_->museum(), window_->history().sceneState(), window_->chosen(), "Look")));
        file.close();
        window_->choose(0);
        window_->files().open(file.fileName());
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(window_->shown(), std::size_t{1});
        QCOMPARE(window_->findChild<ExhibitList*>()->currentItem()->text(), QString("Torus to mug"));
        // A file of an older program does not name it: the exhibit in the middle of its picture is chosen.
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray text = file.readAll();
        file.close();
        QVERIFY(text.contains("\"exhibit\": \"sdf_morph\""));
        text.replace("\"exhibit\": \"sdf_morph\",", "");
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        window_->choose(0);
        window_->files().open(file.fileName());
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(window_->findChild<MessageStrip*>()->texts(), QStringList());
    }

    void visitingByKeyGivesThePictureTheFocus()
    {
        activate();
        window_->choose(1);
        search()->setFocus();
        action("Visit Torus to mug")->trigger();
        QVERIFY(window_->viewport().hasFocus());
    }

    void tabGoesFromTheSearchIntoTheRows()
    {
        activate();
        window_->choose(1);
        search()->setFocus();
        int stops = 0;
        while (!window_->panel().row("morph")->isAncestorOf(QApplication::focusWidget())) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QVERIFY2(++stops <= 3, QApplication::focusWidget()->metaObject()->className());
        }
    }

    void everyStopOfTheTabKeyShowsTheFocus()
    {
        activate();
        window_->choose(1);
        search()->setFocus();
        QTest::keyClick(search(), Qt::Key_Tab);
        QStringList blind;
        QSet<QString> seen;
        for (int i = 0; i < 200 && QApplication::focusWidget() != search(); ++i) {
            QWidget* stop = QApplication::focusWidget();
            QVERIFY(stop);
            if (stop == &window_->viewport()) {  // The viewport handles Tab itself, so the test goes on behind it.
                do stop = stop->nextInFocusChain();
                while (!(stop->focusPolicy() & Qt::TabFocus) || !stop->isVisible() || !stop->isEnabled() ||
                       stop->window() != window_.get());
                stop->setFocus(Qt::TabFocusReason);
                continue;
            }
            QWidget* around = stop->parentWidget();
            seen << stop->accessibleName();
            const QRect there(stop->mapTo(window_.get(), QPoint(-2, -2)), stop->size() + QSize(4, 4));
            const QImage with = window_->grab(there).toImage();
            stop->clearFocus();
            const QImage without = window_->grab(there).toImage();
            if (with == without)
                blind << QString("%1 \"%2\" in %3")
                             .arg(stop->metaObject()->className(), stop->accessibleName(),
                                  around->metaObject()->className());
            stop->setFocus(Qt::TabFocusReason);
            QTest::keyClick(stop, Qt::Key_Tab);
        }
        QVERIFY2(blind.isEmpty(), qPrintable(blind.join("; ")));
        for (const char* stop : {"Exhibits", "Presets", "Save preset", "Parameters of", "Only changed", "Base color"})
            QVERIFY2(seen.contains(QLatin1String(stop)), stop);
    }

    void aFinishedPictureIsSavedAsItIs()
    {
        settle();
        const QDir folder(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
        const int reads = gallery_->pictureReads;
        for (int i = 0; i < 2; ++i) {
            settle();
            action("Screenshot")->trigger();
        }
        QTRY_COMPARE(gallery_->pictureReads, reads + 2);
        QTRY_COMPARE(folder.entryList({"*.png"}, QDir::Files).size(), 2);
        const QImage picture(folder.filePath(folder.entryList({"*.png"}, QDir::Files).first()));
        QCOMPARE(picture.width(), window_->viewport().width());
    }

    void aPictureThatIsNotFinishedIsSavedAtOnce()
    {
        settle();
        const QDir folder(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation));
        const QSize onTheScreen = window_->viewport().pictures().shown().image().size();
        window_->viewport().scene().change();
        QVERIFY(!window_->viewport().pictures().finished());
        action("Screenshot")->trigger();
        const auto* refined = window_->findChild<PictureExport*>();
        QVERIFY(refined);
        const QString path = QString::fromStdString(refined->path().string());
        QTRY_VERIFY(QFile::exists(path));
        const QImage saved = QImage(path).convertToFormat(QImage::Format_RGB32);
        QCOMPARE(saved.size(), onTheScreen);
        QVERIFY(render::embeddedPreset(path.toStdString()).has_value());
        QTRY_VERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains(QFileInfo(path).fileName()));
        // This gallery can draw no finer picture: the saved one stays, and the window gives the reason.
        QTRY_VERIFY(!window_->findChild<PictureExport*>());
        QCOMPARE(QImage(path).convertToFormat(QImage::Format_RGB32), saved);
        QCOMPARE(folder.entryList({"*.png"}, QDir::Files).size(), 1);
    }

    void aBarePictureHasNoStatusBar()
    {
        window_->hidePanels(true);
        QVERIFY(!window_->statusBar()->isVisible());
        window_->hidePanels(false);
        QVERIFY(window_->statusBar()->isVisible());
    }

    void longTheHallInTheListGoesToTheHall()
    {
        auto* list = window_->findChild<ExhibitList*>();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->findItems("Torus to mug", Qt::MatchExactly).front()).center());
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->findItems("The hall", Qt::MatchExactly).front()).center());
        QCOMPARE(window_->chosen(), std::size_t{0});
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::walk);
        QVERIFY(window_->history().sceneState().camera ==
                gallery_->museum().bestView(hallIndex, window_->history().sceneState().hall()));
    }

    void aNarrowPictureIsDrawnWider()
    {
        const double fov = window_->history().sceneState().camera.fovY;
        const double aspect = static_cast<double>(window_->viewport().width()) / window_->viewport().height();
        QVERIFY(aspect < 1.4);
        const double drawn = gallery_->requests().back().camera.fovY;
        QVERIFY(std::abs(std::tan(drawn / 2) * aspect - std::tan(fov / 2) * 1.5) < 1e-9);
    }

    void longAPausedJumpStandsStillWhileItIsRefined()
    {
        window_->viewport().pictures().setLimits(asTheHallRequests, 0);
        gallery_->exhibit().movesFor = 3;
        window_->visit(1);
        settle();
        window_->viewport().interaction().press();
        QTRY_VERIFY(gallery_->requests().back().sincePressed[1] > 0.3);
        action("Pause clock")->trigger();
        settle();
        std::vector<double> moments;
        const std::vector<FrameRequest> drawn = gallery_->requests();
        for (auto request = drawn.rbegin(); moments.size() < 16; ++request) {
            QCOMPARE(request->samples, 16);
            moments.push_back(request->sincePressed[1]);
        }
        for (const double moment : moments) QCOMPARE(moment, moments.front());
        QTest::qWait(300);
        window_->viewport().scene().change();
        settle();
        QCOMPARE(gallery_->requests().back().sincePressed[1], moments.front());
        action("Pause clock")->trigger();
        QTRY_VERIFY(gallery_->requests().back().sincePressed[1] > moments.front() + 0.05);
    }

    void menusHoldWhatTheyAreNamedFor()
    {
        for (const char* entry :
             {"Save preset", "Save preset as…", "Rename preset", "Delete preset", "Import preset…"}) {
            QVERIFY2(menu("Preset").contains(QString::fromUtf8(entry)), entry);
            QVERIFY2(!menu("File").contains(QString::fromUtf8(entry)), entry);
        }
        QVERIFY(menu("Help").contains("About Vitrine") && menu("Help").contains("Manual"));
#ifdef NDEBUG
        QVERIFY(!menu("View").contains("Reload shaders"));  // There are no shader files to read.
#endif
        action("About Vitrine")->trigger();
        auto* about = window_->findChild<AboutDialog*>();
        QVERIFY(about && about->isVisible());
        QString words;
        for (const QLabel* label : about->findChildren<QLabel*>()) words += label->text();
        for (const char* part : {render::programVersion().c_str(), "Qt", "GNU General Public License"})
            QVERIFY2(words.contains(QLatin1String(part)), part);
        about->close();
    }

    void theTitleNamesExhibitAndPreset()
    {
        QVERIFY(!window_->windowIcon().isNull());
        window_->choose(1);
        QCOMPARE(window_->windowTitle(), QString::fromUtf8("Torus to mug — Vitrine"));
        window_->presetController().saveUnder("Dull");
        QCOMPARE(window_->windowTitle(), QString::fromUtf8("Torus to mug: Dull — Vitrine"));
        dragRoughness(60);
        QTRY_COMPARE(window_->windowTitle(), QString::fromUtf8("Torus to mug: Dull * — Vitrine"));
    }

    void fileDialogsOfferWhatCanBeRead()
    {
        action("Open…")->trigger();
        auto* open = window_->findChild<QFileDialog*>();
        QVERIFY(open);
        const QString offered = open->nameFilters().front();
        for (const char* ending :
             {"*.json", "*.glb", "*.gltf", "*.hdr", "*.exr", "*.png", "*.jpg", "*.jpeg", "*.tif", "*.tiff"})
            QVERIFY2(offered.contains(QLatin1String(ending)), ending);
        delete open;
        window_->choose(1);
        for (QToolButton* button : window_->panel().row("environment")->findChildren<QToolButton*>())
            if (button->accessibleName().contains("choose a file")) QTest::mouseClick(button, Qt::LeftButton);
        auto* dialog = window_->findChild<QFileDialog*>();
        QVERIFY(dialog);
        QVERIFY2(dialog->nameFilters().front().contains("*.hdr *.exr"), qPrintable(dialog->nameFilters().join(';')));
        delete dialog;
    }
};

VITRINE_UI_TEST(VisitorTest)

#include "visitor_test.moc"
