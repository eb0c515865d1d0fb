#include "tests/support/balls.h"
#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/parameters/number_field.h"
#include "ui/presets/preset_controller.h"
#include "ui/study/study_dock.h"

#include <QComboBox>
#include <QFile>
#include <QScrollArea>
#include <QScrollBar>

#include <semaphore>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::parameterOf;

/// An exhibit in the window whose parameters a file describes.
class MadeParametersTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t balls = 2;
    test::BallsExhibit* exhibit_ = nullptr;

    std::unique_ptr<Exhibit> anotherExhibit() override
    {
        auto exhibit = std::make_unique<test::BallsExhibit>();
        exhibit_ = exhibit.get();
        return exhibit;
    }
    [[nodiscard]] std::string path(const char* name) const { return home_->filePath(name).toStdString(); }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[balls]; }
    void name(const std::string& file)
    {
        window_->history().set(balls, *exhibit_->parameters().find("scene"), file, newGesture());
    }
    void undo() { window_->history().stack().undo(); }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        test::writeBalls(path("two.json"), {{"red", 0.5}, {"blue", 2}});
        test::writeBalls(path("other.json"), {{"blue", 1}, {"green", 3}});
        window_->choose(balls);
    }
    void cleanup() { finish(); }

    void longThePanelShowsTheRowsOfTheFileAndTheirSlidersAct()
    {
        QVERIFY(!window_->panel().row("redRadius"));
        name(path("two.json"));
        QTRY_VERIFY(window_->panel().row("redRadius"));
        auto* slider = in<ValueSlider>("redRadius");
        QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() - 14, slider->height() / 2));
        const Value set = parameterOf(values(), "redRadius").value();
        QVERIFY(std::get<double>(set) > 5);
        QTRY_COMPARE(parameterOf(gallery_->drawn().values[balls], "redRadius").value_or(Value(0.0)), set);

        name(path("other.json"));
        QTRY_VERIFY(window_->panel().row("greenRadius"));
        QVERIFY(!window_->panel().row("redRadius"));
        undo();
        QCOMPARE(parameterOf(values(), "redRadius").value(), set);
        QVERIFY(window_->panel().row("redRadius"));
        undo();
        QCOMPARE(parameterOf(values(), "redRadius").value(), Value(0.5));
        undo();
        QVERIFY(!window_->panel().row("redRadius"));
        QVERIFY(!window_->history().stack().canUndo());
    }

    void theWindowGoesOnWhileTheFileIsRead()
    {
        std::counting_semaphore<> mayRead(0);
        std::atomic<bool> elsewhere = false;
        exhibit_->beforeReading = [&, here = std::this_thread::get_id()] {
            elsewhere = std::this_thread::get_id() != here;
            mayRead.acquire();
        };
        name(path("two.json"));
        // The reader waits, but not the window: a value is set in the meantime.
        window_->history().set(balls, *exhibit_->parameters().find("spin"), 7.0, newGesture());
        QTest::qWait(50);
        QVERIFY(!parameterOf(values(), "redRadius"));
        mayRead.release(100);
        QTRY_VERIFY(parameterOf(values(), "redRadius"));
        QVERIFY(elsewhere);
        QCOMPARE(parameterOf(values(), "spin").value(), Value(7.0));
        exhibit_->beforeReading = nullptr;
    }

    void aFileThatCannotBeReadLeavesTheRowsAndIsSaid()
    {
        name(path("two.json"));
        QTRY_VERIFY(window_->panel().row("redRadius"));
        QSignalSpy said(window_->findChild<MessageStrip*>(), &MessageStrip::said);
        name(path("gone.json"));
        QTRY_COMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().contains("gone.json"));
        QVERIFY(window_->panel().row("redRadius"));
    }

    void aFileThatIsWrittenAnewGivesItsParametersAnew()
    {
        name(path("two.json"));
        QTRY_VERIFY(window_->panel().row("redRadius"));
        window_->history().set(balls, *values().table().find("blueRadius"), 4.5, newGesture());
        test::writeBalls(path("two.json"), {{"blue", 2}, {"white", 1}});
        QTRY_VERIFY_WITH_TIMEOUT(window_->panel().row("whiteRadius"), vitrine::test::patience);
        QCOMPARE(parameterOf(values(), "blueRadius").value(), Value(4.5));
    }

    void aParameterThatNobodyTouchedFollowsItsFile()
    {
        name(path("two.json"));
        QTRY_VERIFY(window_->panel().row("redRadius"));
        window_->history().set(balls, *values().table().find("blueRadius"), 4.5, newGesture());
        test::writeBalls(path("two.json"), {{"red", 0.75}, {"blue", 3}});
        QTRY_COMPARE_WITH_TIMEOUT(parameterOf(values(), "redRadius").value(), Value(0.75), vitrine::test::patience);
        QVERIFY(values().isInitial(*values().table().find("redRadius")));
        QVERIFY(!window_->panel().row("redRadius")->differs());
        // The picture shows it, and the visitor's value stays.
        QTRY_COMPARE(parameterOf(gallery_->drawn().values[balls], "redRadius").value_or(Value(0.0)), Value(0.75));
        QCOMPARE(parameterOf(values(), "blueRadius").value(), Value(4.5));
        // Undo restores the value that is in the file now.
        undo();
        QTRY_COMPARE(parameterOf(values(), "blueRadius").value(), Value(3.0));
        QTRY_COMPARE(parameterOf(values(), "redRadius").value(), Value(0.75));
    }

    void theMessageAboutAFileLeavesOnceItIsMended()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        name(path("two.json"));
        QTRY_VERIFY(window_->panel().row("redRadius"));
        QFile broken(home_->filePath("two.json"));
        QVERIFY(broken.open(QIODevice::WriteOnly));
        broken.write("{\"balls\": [");
        broken.close();
        QTRY_COMPARE_WITH_TIMEOUT(strip->texts().size(), 1, vitrine::test::patience);
        QVERIFY2(strip->texts().front().contains("two.json"), qPrintable(strip->texts().front()));
        window_->choose(1);  // Whatever is shown in the meantime.
        test::writeBalls(path("two.json"), {{"red", 0.25}});
        QTRY_VERIFY2_WITH_TIMEOUT(strip->texts().isEmpty(), qPrintable(strip->texts().join(' ')),
                                  vitrine::test::patience);
    }

    void aReloadLeavesThePanelWhereItWas()
    {
        std::vector<test::Ball> many;
        for (char c = 'a'; c <= 'z'; ++c) many.push_back({std::string("ball") + c, 1});
        test::writeBalls(path("many.json"), many);
        name(path("many.json"));
        QTRY_VERIFY(window_->panel().row("ballzRadius"));
        QScrollBar* bar = window_->panel().findChild<QScrollArea*>()->verticalScrollBar();
        QTRY_VERIFY(bar->maximum() > 400);
        bar->setValue(300);
        many.front().radius = 2;
        test::writeBalls(path("many.json"), many);
        QTRY_COMPARE_WITH_TIMEOUT(parameterOf(values(), "ballaRadius").value(), Value(2.0), vitrine::test::patience);
        QTest::qWait(50);
        QCOMPARE(bar->value(), 300);
    }

    void longPresetsAndSessionsBringTheParametersBack()
    {
        name(path("two.json"));
        QTRY_VERIFY(window_->panel().row("redRadius"));
        window_->history().set(balls, *values().table().find("redRadius"), 3.5, newGesture());
        window_->presetController().saveUnder("Large");
        name(path("other.json"));
        QTRY_VERIFY(window_->panel().row("greenRadius"));
        window_->presetController().load(rowsNamed("Large").front()->data(Qt::UserRole).toString());
        QTRY_VERIFY(parameterOf(values(), "redRadius").has_value());
        QCOMPARE(parameterOf(values(), "redRadius").value(), Value(3.5));
        QVERIFY(!window_->presetController().titleOfUse().contains('*'));

        closeWindow();
        openWindow();
        QTRY_VERIFY(parameterOf(values(), "redRadius").has_value());
        QCOMPARE(parameterOf(values(), "redRadius").value(), Value(3.5));
        QVERIFY(!window_->history().stack().canUndo());

        // Missing for a whole session, and back again.
        closeWindow();
        QVERIFY(QFile::rename(home_->filePath("two.json"), home_->filePath("aside.json")));
        openWindow();
        QVERIFY(!parameterOf(values(), "redRadius"));
        closeWindow();
        QVERIFY(QFile::rename(home_->filePath("aside.json"), home_->filePath("two.json")));
        openWindow();
        QTRY_VERIFY(parameterOf(values(), "redRadius").has_value());
        QCOMPARE(parameterOf(values(), "redRadius").value(), Value(3.5));
    }

    void studiesOfferTheParametersOfTheFile()
    {
        auto* choices = window_->findChild<StudyDock*>()->findChild<QComboBox*>();
        QCOMPARE(choices->accessibleName(), QString("What to measure"));
        QCOMPARE(choices->count(), 1);
        name(path("two.json"));
        QTRY_COMPARE(choices->count(), 3);
        QCOMPARE(choices->itemText(2), QString("Blue rings"));
    }
};

VITRINE_WINDOW_TEST(MadeParametersTest)

#include "made_parameters_test.moc"
