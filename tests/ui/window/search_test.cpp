#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/presets/preset_controller.h"
#include "ui/window/search_dialog.h"

#include <QLabel>
#include <QLineEdit>
#include <QTabBar>
#include <QTreeWidget>

using namespace vitrine;
using namespace vitrine::ui;

/// The search over everything, by the keyboard alone.
class SearchTest : public test::OpenWindow {
    Q_OBJECT

    [[nodiscard]] SearchDialog* dialog() { return window_->findChild<SearchDialog*>(); }
    [[nodiscard]] QTreeWidget& list() { return *dialog()->findChild<QTreeWidget*>(); }
    [[nodiscard]] QString first() { return list().topLevelItem(0)->text(0); }
    [[nodiscard]] QString firstPlace() { return list().topLevelItem(0)->text(1); }
    /// Opens the search by its key, and types the words.
    void search(const QString& words, Qt::Key key = Qt::Key_F)
    {
        QApplication::setActiveWindow(window_.get());  // Under Xvfb there is no window manager.
        window_->viewport().setFocus();
        QTest::keyClick(&window_->viewport(), key, Qt::ControlModifier);
        QTRY_VERIFY(dialog());
        QTest::keyClicks(dialog()->findChild<QLineEdit*>(), words);
    }
    void press(Qt::Key key)
    {
        QTest::keyClick(dialog()->findChild<QLineEdit*>(), key);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longAMisspelledParameterOfAnotherExhibitIsFoundAndShown()
    {
        QCOMPARE(window_->chosen(), std::size_t{0});
        search("rougness mug");
        QCOMPARE(first(), QString("Roughness"));
        QVERIFY2(firstPlace().startsWith("Torus to mug: "), qPrintable(firstPlace()));
        press(Qt::Key_Return);
        QVERIFY(!dialog());
        QCOMPARE(window_->chosen(), std::size_t{1});
        QVERIFY(window_->panel().row("roughness")->isVisible());
        QApplication::setActiveWindow(window_.get());
        QTRY_VERIFY(window_->panel().row("roughness")->isAncestorOf(QApplication::focusWidget()));
    }

    void aParameterOfTheHallTurnsTheTabAndLeavesTheVisit()
    {
        window_->choose(1);
        search("exposure hall", Qt::Key_K);
        QCOMPARE(first(), QString("Exposure"));
        press(Qt::Key_Return);
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(window_->shown(), std::size_t{0});
        QVERIFY(window_->panel().row("exposure")->isVisible());
    }

    void aCommandIsRunAndShowsItsKeys()
    {
        search("pause");
        QCOMPARE(first(), QString("Pause clock"));
        QVERIFY(list().topLevelItem(0)->text(2).contains("Space"));
        press(Qt::Key_Return);
        QVERIFY(action("Pause clock")->isChecked());
    }

    void aPresetOfAnotherExhibitIsLoaded()
    {
        window_->choose(1);
        window_->history().set(1, gallery_->table().roughness.row, 0.75, newGesture());
        window_->presetController().saveUnder("Dull slate");
        window_->history().set(1, gallery_->table().roughness.row, 0.5, newGesture());
        window_->choose(0);
        search("dull slate");
        QCOMPARE(first(), QString("Dull slate"));
        QCOMPARE(firstPlace(), QString("Preset of Torus to mug"));
        press(Qt::Key_Return);
        QCOMPARE(window_->chosen(), std::size_t{1});
        QCOMPARE(roughness(), 0.75);
    }

    void arrowsChooseAndTheHelpOfTheChosenOneIsShown()
    {
        search("roughness");
        const auto help = [this] { return dialog()->findChild<QLabel*>()->text(); };
        QCOMPARE(help(), QString("0 mirrors, 1 is chalk."));
        dialog()->findChild<QLineEdit*>()->setText("mug");  // All parameters of this exhibit.
        QVERIFY(list().topLevelItemCount() > 1);
        press(Qt::Key_Down);
        QCOMPARE(list().currentItem(), list().topLevelItem(1));
        press(Qt::Key_Up);
        QCOMPARE(list().currentItem(), list().topLevelItem(0));
        press(Qt::Key_Escape);
        QVERIFY(!dialog());
    }

    void nothingFoundIsSaidAndTheWordsStay()
    {
        search("qqzzxx");
        QCOMPARE(dialog()->findChild<QLabel*>()->text(),
                 QString("Nothing found for “qqzzxx”. Try fewer or other words."));
        QVERIFY(!list().isVisible());
        press(Qt::Key_Return);
        QVERIFY(dialog());
        QCOMPARE(dialog()->findChild<QLineEdit*>()->text(), QString("qqzzxx"));
        press(Qt::Key_Escape);
    }

    void allCommandsAreListedBeforeAnythingIsTyped()
    {
        search({});
        QVERIFY(list().topLevelItemCount() > 40);
        QVERIFY(!list().findItems("Quit", Qt::MatchExactly).isEmpty());
        press(Qt::Key_Escape);
        search("how it works mug");
        QCOMPARE(first(), QString("How it works: Torus to mug"));
        press(Qt::Key_Escape);
    }
};

VITRINE_UI_TEST(SearchTest)

#include "search_test.moc"
