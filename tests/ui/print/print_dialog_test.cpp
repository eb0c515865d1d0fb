#include "tests/ui/ui_main.h"

#include "exhibits/framework/files/state_folder.h"
#include "tests/ui/print/open_print_dialog.h"

#include "ui/print/place_bar.h"
#include "ui/print/sheet_bar.h"
#include "ui/print/source_bar.h"
#include "ui/print/strip_preview.h"

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QTabBar>
#include <QToolButton>

#include <cmath>

using namespace vitrine;
using namespace vitrine::ui;

/// Print dialog with views from files: settings, messages, and restoring them.
class PrintDialogTest : public test::OpenPrintDialog {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void opensWithNumbersAndWithoutViewsNothingCanBeExported()
    {
        QVERIFY(std::abs(number("Pixels per lens") - 12) < 6e-5);
        QCOMPARE(warnings(), QString());
        QVERIFY(!button("Export")->isEnabled());
        QVERIFY(dialog_->findChild<SourceBar*>()->said().contains("drop"));
        dialog_->openFiles(solidViews(4));
        settle();
        QVERIFY(button("Export")->isEnabled());
        QVERIFY(dialog_->findChild<SourceBar*>()->said().contains("4 views"));
        QCOMPARE(dialog_->findChild<PrintNumbersView*>()->shown("Views that show"), QString("4 of 4"));
    }

    void typingAnotherLpiUpdatesTheNumbersAsTheClosedFormSays()
    {
        set("distance", 0.4);
        for (const double lpi : {40.0, 75.0, 20.0}) {
            type("lensesPerInch", QString::number(lpi));
            const double pitch = 25.4 / lpi;
            const double thickness = 1.56 * pitch / (2 * std::tan(3.14159265358979 / 12));
            const double radius = thickness * 0.56 / 1.56;
            const double stretch = (400 + thickness) / (400 + radius);
            QVERIFY(std::abs(number("Pixels per lens") - 720 / lpi * stretch) < 6e-5);
            QVERIFY(std::abs(number("LPI in the file") - lpi / stretch) < 6e-5);
        }
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString("20-3d"));
        type("refractiveIndex", "1.5");
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString());
    }

    void warningsComeAndGo()
    {
        set("views", 30);
        QVERIFY2(warnings().contains("30 views share"), qPrintable(warnings()));
        set("views", 8);
        QCOMPARE(warnings(), QString());
        set("dotsPerInch", 90);
        QVERIFY2(warnings().contains("cannot separate"), qPrintable(warnings()));
        set("dotsPerInch", 720);
        dialog_->openFiles(solidViews(3));  // 3:2, for a print of 148 x 105.
        settle();
        QVERIFY2(warnings().contains("6 % of their width is cut off"), qPrintable(warnings()));
        set("fitting", 2);
        settle();
        QVERIFY2(warnings().contains("stretched"), qPrintable(warnings()));
        set("width", 0.1575);
        QCOMPARE(warnings(), QString());
    }

    void longPicturesAreTurnedAndMovedByHand()
    {
        auto& bar = dialog_->findChild<SourceBar*>()->places();
        const auto field = [&](const char* name) -> QAbstractSpinBox* {
            for (auto* each : bar.findChildren<QAbstractSpinBox*>())
                if (each->accessibleName() == name) return each;
            return nullptr;
        };
        auto* view = qobject_cast<QSpinBox*>(field("View to turn and shift"));
        auto* turn = qobject_cast<QDoubleSpinBox*>(field("Turn of the view, clockwise"));
        auto* right = qobject_cast<QDoubleSpinBox*>(field("Shift of the view to the right"));
        QVERIFY(view && turn && right);
        QVERIFY(!view->isEnabled() && !turn->isEnabled());
        dialog_->openFiles(solidViews(5));
        settle();
        set("views", 3);  // Pictures 1, 3 and 5.
        QVERIFY(view->isEnabled() && turn->isEnabled());
        QCOMPARE(view->maximum(), 3);
        const auto places = [this] { return dialog_->values()[printing::printTable().places]; };
        const auto type = [this](QAbstractSpinBox* into, const char* text) {
            into->setFocus();
            into->selectAll();
            QTest::keyClicks(into, text);
            QTest::keyClick(into, Qt::Key_Return);
            settle();
        };
        type(view, "2");
        type(turn, "1.5");
        type(right, "-2");
        QCOMPARE(places(), std::string("3:1.5,-2,0"));
        type(view, "1");
        QCOMPARE(turn->value(), 0.0);
        type(view, "2");
        QCOMPARE(turn->value(), 1.5);
        // Consecutive steps in one field are one undo step.
        right->setFocus();
        for (int i = 0; i < 3; ++i) QTest::keyClick(right, Qt::Key_Up);
        settle();
        QCOMPARE(places(), std::string("3:1.5,-1.7,0"));
        QTest::keyClick(dialog_, Qt::Key_Z, Qt::ControlModifier);
        settle();
        QCOMPARE(places(), std::string("3:1.5,-2,0"));
        for (auto* button : bar.findChildren<QToolButton*>()) button->click();
        settle();
        QCOMPARE(places(), std::string());
        type(turn, "3");
        // Places belong to their pictures: other pictures have none.
        dialog_->openFiles(solidViews(4));
        settle();
        QCOMPARE(places(), std::string());
        dialog_->findChild<SourceBar*>()->showOrigin(printing::ViewOrigin::shown);
        QVERIFY(!bar.isVisible());
    }

    void aSheetThatCannotBeIsRefusedWithItsLimitAndNothingIsExported()
    {
        dialog_->openFiles(solidViews(4));
        settle();
        QVERIFY(button("Export")->isEnabled());
        set("width", 0.1575);  // Aspect ratio of the views.
        set("zone", 1.2);      // Beyond the largest zone of 58.5 degrees for this index.
        QVERIFY2(warnings().contains("58.49"), qPrintable(warnings()));
        QVERIFY(!button("Export")->isEnabled());
        set("zone", 0.6);  // A sheet for depth; one for flips would cause a warning.
        QCOMPARE(warnings(), QString());
        QVERIFY(button("Export")->isEnabled());
    }

    void whatWasSetComesBackTheNextTime()
    {
        dialog_->openFiles(solidViews(5));
        settle();
        set("lensesPerInch", 50);
        set("phase", 0.1);
        const ParameterValues before = dialog_->values();
        closeDialog();
        openDialog();
        QVERIFY(dialog_->values() == before);
        QCOMPARE(dialog_->files().size(), 5);
        QVERIFY(button("Export")->isEnabled());
        closeDialog();
        QFile file(QString::fromStdString((configFolder() / "print.json").string()));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{ broken");
        file.close();
        openDialog();
        QVERIFY2(said().contains("print.json"), qPrintable(said()));
        ParameterValues first = printing::printTable().initial();
        first.set(printing::printTable().origin, printing::ViewOrigin::files);
        QVERIFY(dialog_->values() == first);
        QFile other(home_->filePath("other.json"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write("{\"format\": \"vitrine-job\", \"job\": \"sprite\"}");
        other.close();
        dialog_->openFiles({other.fileName()});
        QVERIFY2(said().contains("other.json"), qPrintable(said()));
        QVERIFY(dialog_->files().isEmpty());
    }

    void escClosesAndEveryControlIsReachedByTabAndHasAName()
    {
        dialog_->openFiles(solidViews(3));
        settle();
        QApplication::setActiveWindow(dialog_);
        QSet<QWidget*> reached;
        dialog_->findChild<QTabBar*>()->setFocus();
        for (int i = 0; i < 300; ++i) {
            if (QWidget* focus = QApplication::focusWidget()) {
                reached << focus;
                QTest::keyClick(focus, Qt::Key_Tab);
            }
        }
        int controls = 0;
        for (QWidget* widget : dialog_->findChildren<QWidget*>()) {
            if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible() || !widget->isEnabled()) continue;
            if (widget->inherits("QScrollArea") || widget->objectName().startsWith("qt_")) continue;
            const QString what =
                QString("%1 in %2")
                    .arg(widget->metaObject()->className(), widget->parentWidget()->metaObject()->className());
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(what));
            QVERIFY2(reached.contains(widget), qPrintable(what + ' ' + widget->accessibleName()));
            ++controls;
        }
        QVERIFY(controls > 30);
        QTest::keyClick(dialog_->findChild<StripPreview*>(), Qt::Key_Escape);
        QTRY_VERIFY(!dialog_);
    }

    void nothingIsClippedAtTheSmallestScreen()
    {
        dialog_->openFiles(solidViews(3));
        settle();
        QVERIFY2(dialog_->width() <= 1280 && dialog_->height() <= 690,
                 qPrintable(QString("%1 x %2").arg(dialog_->width()).arg(dialog_->height())));
        QVERIFY(dialog_->minimumSizeHint().height() <= 690);
        for (QPushButton* each : dialog_->findChildren<QPushButton*>()) {
            if (!each->isVisible()) continue;
            QVERIFY2(each->width() >= each->fontMetrics().horizontalAdvance(each->text()) + 8,
                     qPrintable(each->text()));
            QVERIFY(dialog_->rect().contains(QRect(each->mapTo(dialog_.data(), QPoint()), each->size())));
        }
    }
};

VITRINE_UI_TEST(PrintDialogTest)

#include "print_dialog_test.moc"
