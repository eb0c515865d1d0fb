// Usual kinds of work in the window over the real museum, by real events. Each counts what a visitor does, and may take
// no more than its limit. A click, a key with its modifiers and a typed text count as one action each. What the machine
// needs meanwhile is printed.

#include "exhibits/exhibits.h"
#include "tests/ui/open_museum.h"
#include "tests/ui/study/small_studies.h"
#include "tests/ui/ui_main.h"
#include "ui/export/export_dialog.h"
#include "ui/jobs/job_dialog.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/preset_list.h"
#include "ui/print/print_dialog.h"
#include "ui/study/study_dock.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/search_dialog.h"
#include "ui/window/window_docks.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <memory>

using namespace vitrine;
using namespace vitrine::ui;

class FewClicksTest : public test::OpenMuseum {
    Q_OBJECT

    std::size_t mug_ = 0;
    int actions_ = 0;
    QElapsedTimer since_;

    /// Begins to count.
    void begin()
    {
        actions_ = 0;
        since_.start();
    }
    /// Reports the actions and the time, and checks the number.
    void end(const char* work, int most)
    {
        qInfo("%s: %d actions, %.1f s", work, actions_, static_cast<double>(since_.elapsed()) / 1000);
        QVERIFY2(actions_ <= most, qPrintable(QString("%1 takes %2 actions").arg(work).arg(actions_)));
    }
    void click(QWidget* widget, const QPoint& at)
    {
        QVERIFY(widget && widget->isVisible() && widget->isEnabled());
        QVERIFY(widget->visibleRegion().contains(at));
        ++actions_;
        QTest::mouseClick(widget, Qt::LeftButton, {}, at);
    }
    void click(QWidget* widget)
    {
        QVERIFY(widget);
        click(widget, widget->rect().center());
    }
    void click(QListWidget& list, const QString& text)
    {
        const auto items = list.findItems(text, Qt::MatchExactly);
        QCOMPARE(items.size(), 1);
        // A list that was just shown gets its place with the next events.
        QTRY_VERIFY(list.viewport()->visibleRegion().contains(list.visualItemRect(items.front()).center()));
        click(list.viewport(), list.visualItemRect(items.front()).center());
    }
    static void key(QWidget& widget, Qt::Key code, Qt::KeyboardModifiers with = {})
    {
        QApplication::setActiveWindow(widget.window());  // Under Xvfb there is no window manager.
        if (widget.inherits("QOpenGLWidget")) widget.setFocus();
        QTest::keyClick(&widget, code, with);
    }
    void press(QWidget* widget, Qt::Key code, Qt::KeyboardModifiers with = {})
    {
        QVERIFY(widget);
        ++actions_;
        key(*widget, code, with);
    }
    void type(QWidget* field, const QString& text)
    {
        QVERIFY(field);
        ++actions_;
        QTest::keyClicks(field, text);
    }
    [[nodiscard]] QLineEdit* fieldOf(QWidget* dialog) { return dialog ? dialog->findChild<QLineEdit*>() : nullptr; }
    /// Returns the button whose name for screen readers begins with these words.
    [[nodiscard]] static QToolButton* buttonOf(QWidget& parent, const char* name)
    {
        for (auto* button : parent.findChildren<QToolButton*>())
            if (button->isVisible() && button->accessibleName().startsWith(name)) return button;
        return nullptr;
    }
    /// Returns the list of recent presets of other exhibits.
    [[nodiscard]] QListWidget* recent()
    {
        for (auto* list : window_->findChild<PresetList*>()->findChildren<QListWidget*>())
            if (list->accessibleName() == "Recent, of other exhibits") return list;
        return nullptr;
    }
    template <typename T> [[nodiscard]] T* opened()
    {
        T* found = nullptr;
        (void)QTest::qWaitFor([&] { return (found = window_->findChild<T*>()) && found->isVisible(); }, 10000);
        return found;
    }
    /// Names the settings of the shown page of the export dialog, which happens once and is not counted.
    void nameSettings(ExportDialog& dialog, const QString& name)
    {
        auto* list = dialog.findChild<ExportPresetList*>();
        for (auto* button : list->findChildren<QPushButton*>())
            if (button->text() == "Save…") button->click();
        QLineEdit* field = nullptr;
        QTRY_VERIFY((field = list->findChild<QLineEdit*>()) != nullptr);
        field->setText(name);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(list->names(), QStringList(name));
    }
    static void set(JobDialog& page, const char* parameter, double value)
    {
        ParameterValues values = page.setup().values();
        values.setParameter(*values.table().find(parameter), value);
        page.setup().change(QString(), values);
    }
    static void set(PrintDialog& page, const char* parameter, double value)
    {
        ParameterValues values = page.values();
        values.setParameter(*values.table().find(parameter), value);
        page.setValues(values);
    }
    [[nodiscard]] QStringList written() const
    {
        return QDir(home_->filePath("Pictures")).entryList(QDir::Files, QDir::Name);
    }

private slots:
    void initTestCase()
    {
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        prepare();
        museum_ = std::make_unique<Museum>(allExhibits());
        mug_ = museum_->find("sdf_morph").value();
    }
    void init()
    {
        makeHome();
        QDir(home_->path()).mkdir("Pictures");
        makeWindow({.scale = 0.25});  // Actions are counted, not pixels.
        showWindow({1280, 720});
        window_->visit(mug_);
        QTRY_VERIFY(window_->viewport().pictures().schedule().still());
    }
    void cleanup() { closeWindow(); }

    void longTheCostOfAParameterBecomesAFigure()
    {
        StudyDock& study = window_->docks().study();
        vitrine::test::setEffort(study, {64, 36}, 2);
        QSignalSpy finished(&study, &StudyDock::finished);
        begin();
        // The parameter is found by its name: only six parameters are unfolded.
        press(&window_->viewport(), Qt::Key_F, Qt::ControlModifier);
        QLineEdit* words = fieldOf(opened<SearchDialog>());
        type(words, "hit tolerance");
        press(words, Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(written(), QStringList("sdf_morph-hitTolerance.svg"));
        end("Study as a figure", 3);
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(window_->panel().row("hitTolerance")->isVisible());
        QFile file(home_->filePath("Pictures/sdf_morph-hitTolerance.svg"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("<svg"));
        // A second one has a name of its own. The name is that of what was measured, whatever is visited now.
        window_->visit(museum_->find("fur").value());
        QToolButton* save = nullptr;
        for (auto* button : study.findChildren<QToolButton*>())
            if (button->accessibleName() == "Save the chart as a figure") save = button;
        click(save);
        QTRY_COMPARE(written().size(), 2);
        QVERIFY2(written().filter("sdf_morph-hitTolerance").size() == 2, qPrintable(written().join(' ')));
    }

    void longTheCostOfAParameterBecomesAFigureByTheMouse()
    {
        StudyDock& study = window_->docks().study();
        vitrine::test::setEffort(study, {64, 36}, 2);
        begin();
        click(buttonOf(*window_, "Search"));
        auto* search = opened<SearchDialog>();
        type(fieldOf(search), "hit tolerance");
        QToolButton* both = buttonOf(*search, "Measure and save figure");
        click(both);
        QTRY_COMPARE(written(), QStringList("sdf_morph-hitTolerance.svg"));
        end("Study as a figure, by the mouse", 3);
        QVERIFY(!window_->findChild<SearchDialog*>() || !window_->findChild<SearchDialog*>()->isVisible());
    }

    void longAStudyThatIsStoppedBecomesNoFigure()
    {
        StudyDock& study = window_->docks().study();
        vitrine::test::setEffort(study, {64, 36}, 2);
        QSignalSpy stopped(&study, &StudyDock::stopped), finished(&study, &StudyDock::finished);
        const std::size_t tolerance = *museum_->subject(mug_).parameters().find("hitTolerance");
        window_->docks().measureIntoFigure(mug_, tolerance);
        QVERIFY(study.running());
        study.stop();
        QCOMPARE(stopped.count(), 1);
        // A study that was asked for without a figure writes nothing at its end.
        window_->docks().measureAccuracy(mug_, tolerance);
        QTRY_COMPARE(finished.count(), 1);
        QCOMPARE(written(), QStringList());
    }

    void aPrintWithSettingsThatHaveAName()
    {
        key(window_->viewport(), Qt::Key_P, Qt::ControlModifier);
        auto* dialog = opened<ExportDialog>();
        auto* page = opened<PrintDialog>();
        for (const auto& [parameter, value] :
             std::initializer_list<std::pair<const char*, double>>{{"views", 2},
                                                                   {"viewWidth", 96},
                                                                   {"samples", 1},
                                                                   {"width", 0.03},
                                                                   {"height", 0.02},
                                                                   {"dotsPerInch", 300}})
            set(*page, parameter, value);
        nameSettings(*dialog, "Postcard");
        set(*page, "width", 0.1);
        dialog->close();
        QTRY_VERIFY(!window_->findChild<PrintDialog*>());
        begin();
        press(&window_->viewport(), Qt::Key_P, Qt::ControlModifier);
        page = opened<PrintDialog>();
        QTRY_VERIFY(page->isVisible());
        click(*dialog->findChild<ExportPresetList*>()->findChild<QListWidget*>(), "Postcard");
        QTRY_VERIFY(page->settled());
        QSignalSpy ended(page, &PrintDialog::exportEnded);
        press(dialog, Qt::Key_Return, Qt::ControlModifier);
        QTRY_COMPARE(ended.count(), 1);
        end("Print with named settings", 3);
        QCOMPARE(written(), (QStringList{"lenticular-print.tif", "lenticular-print.tif.json"}));
        QVERIFY(std::abs(page->values()[printing::printTable().width] - 0.03) < 1e-9);
    }

    void longAPictureWithSettingsThatHaveAName()
    {
        key(window_->viewport(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        auto* dialog = opened<ExportDialog>();
        auto* page = opened<JobDialog>();
        for (const auto& [parameter, value] : std::initializer_list<std::pair<const char*, double>>{
                 {"width", 160}, {"height", 90}, {"samples", 2}, {"transparent", 1}})
            set(*page, parameter, value);
        nameSettings(*dialog, "Cut out");
        set(*page, "width", 320);
        dialog->close();
        QTRY_VERIFY(!window_->findChild<JobDialog*>());
        begin();
        press(&window_->viewport(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        page = opened<JobDialog>();
        click(*dialog->findChild<ExportPresetList*>()->findChild<QListWidget*>(), "Cut out");
        QTRY_VERIFY(page->settled());
        QSignalSpy ended(page, &JobDialog::exportEnded);
        press(dialog, Qt::Key_Return, Qt::ControlModifier);
        QTRY_COMPARE(ended.count(), 1);
        end("Picture with named settings", 3);
        const QImage picture(home_->filePath("Pictures/sdf_morph.png"));
        QCOMPARE(picture.size(), QSize(160, 90));
        QCOMPARE(qAlpha(picture.pixel(0, 0)), 0);
    }

    void longThePictureOnTheScreen()
    {
        begin();
        press(&window_->viewport(), Qt::Key_F12);
        QTRY_COMPARE(written().size(), 1);
        end("Screenshot", 1);
    }

    void longAPresetIsKeptAndUsedFromAnotherExhibit()
    {
        const std::size_t morph = *museum_->subject(mug_).parameters().find("morph");
        window_->history().set(mug_, morph, 0.25, newGesture());
        begin();
        press(&window_->viewport(), Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
        const auto* presets = window_->findChild<PresetList*>()->findChild<QListWidget*>();
        QTRY_COMPARE(presets->findItems("Morph 0.25", Qt::MatchExactly).size(), 1);
        end("Preset kept", 1);
        window_->history().set(mug_, morph, 0.75, newGesture());
        window_->visit(museum_->find("fur").value());
        begin();
        click(*recent(), "Morph 0.25 – Torus to Mug");
        QTRY_COMPARE(std::get<double>(window_->history().sceneState().values[mug_].row(morph)), 0.25);
        end("Preset of another exhibit", 1);
        QCOMPARE(window_->chosen(), mug_);
        // By the keyboard: the search opens with what was used last.
        window_->history().set(mug_, morph, 0.75, newGesture());
        window_->visit(museum_->find("fur").value());
        begin();
        press(&window_->viewport(), Qt::Key_F, Qt::ControlModifier);
        press(fieldOf(opened<SearchDialog>()), Qt::Key_Return);
        QTRY_COMPARE(std::get<double>(window_->history().sceneState().values[mug_].row(morph)), 0.25);
        end("Preset of another exhibit, by the keyboard", 2);
        QCOMPARE(window_->chosen(), mug_);
    }

    void longRecentPresetsOfTheHallEndNoVisitAndRoomIsKeptForThePresetsOfTheExhibit()
    {
        window_->visit(0);
        QTRY_VERIFY(window_->viewport().pictures().schedule().still());
        window_->presetController().saveUnder("My evening");
        window_->visit(mug_);
        click(*recent(), "My evening – The hall");
        QTRY_COMPARE(window_->shown(), hallIndex);
        QCOMPARE(window_->chosen(), mug_);
        QTRY_VERIFY(!recent()->isVisible());  // The hall's own presets are shown now.
        // A panel that is short shows its own presets only.
        window_->visit(museum_->find("fur").value());
        QTRY_VERIFY(recent()->isVisible());
        auto* list = window_->findChild<PresetList*>();
        const QListWidget* own = list->findChild<QListWidget*>();
        QTRY_VERIFY2(own->height() >= 2 * own->minimumHeight(), qPrintable(QString::number(own->height())));
        window_->findChild<QDockWidget*>("exhibits")->setMinimumHeight(460);
        QTRY_VERIFY(!recent()->isVisible());
        window_->findChild<QDockWidget*>("exhibits")->setMinimumHeight(0);
    }
};

VITRINE_UI_TEST(FewClicksTest)

#include "few_clicks_test.moc"
