#include "tests/ui/ui_main.h"

#include "exhibits/printing/sheet.h"
#include "tests/ui/print/open_print_dialog.h"

#include "ui/print/sheet_bar.h"
#include "ui/print/strip_preview.h"

#include <QComboBox>

#include <cmath>

using namespace vitrine;
using namespace vitrine::ui;

/// Lens sheets in the print dialog, and undo of all its settings.
class PrintSheetsTest : public test::OpenPrintDialog {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void ownSheetsAreSavedChosenAndDeleted()
    {
        auto* bar = dialog_->findChild<SheetBar*>();
        set("measuredPerInch", 60.12);
        QCOMPARE(bar->current(), QString());
        bar->save("Mine");
        QCOMPARE(bar->current(), QString("Mine"));
        bar->choose("40-3d");
        settle();
        QCOMPARE(bar->current(), QString("40-3d"));
        bar->choose("Mine");
        settle();
        QVERIFY(number("LPI in the file") > 60);
        bar->save("40-3d");  // Shipped sheets cannot be replaced.
        QVERIFY2(said().contains("40-3d"), qPrintable(said()));
        bar->remove("Mine");
        QCOMPARE(bar->current(), QString());
    }

    void sheetsAreNamedByWhatTheyAreAndKeepTheirNamesInFiles()
    {
        auto* list = dialog_->findChild<SheetBar*>()->findChild<QComboBox*>();
        for (const printing::Sheet& sheet : printing::knownSheets()) {
            const int at = list->findData(QString::fromStdString(sheet.name));
            QVERIFY2(at >= 0, sheet.name.c_str());
            const QString shown = list->itemText(at);
            QVERIFY2(shown.startsWith(QString("%1 LPI, ").arg(sheet.nominalLpi)), qPrintable(shown));
            // Derived for 30 and 50 degrees by the paraxial focus; the exact ray through the center differs a little.
            const double degrees = shown.mid(shown.lastIndexOf(' ')).chopped(1).toDouble();
            const QString name = QString::fromStdString(sheet.name);
            if (name.endsWith("-3d")) QVERIFY2(shown.contains("3D") && std::abs(degrees - 30) <= 3, qPrintable(shown));
            if (name.endsWith("-flip"))
                QVERIFY2(shown.contains("flip") && std::abs(degrees - 50) <= 6, qPrintable(shown));
        }
        emit list->activated(list->findData(QString("60-flip")));
        settle();
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString("60-flip"));
    }

    void anOwnSheetWithAShippedSheetsNumbersStaysTheOwnOne()
    {
        auto* bar = dialog_->findChild<SheetBar*>();
        const QString shipped = bar->current();
        QVERIFY(!shipped.isEmpty());
        bar->save("Mine");
        QCOMPARE(bar->current(), QString("Mine"));
        set("phase", 0.2);
        QCOMPARE(bar->current(), QString("Mine"));
        closeDialog();
        openDialog();
        bar = dialog_->findChild<SheetBar*>();
        QCOMPARE(bar->current(), QString("Mine"));
        bar->choose(shipped);
        QCOMPARE(bar->current(), shipped);
        bar->choose("Mine");
        bar->remove("Mine");
        QCOMPARE(bar->current(), shipped);
    }

    void longSettingsFilesAndSheetsAreUndoneAndRedone()
    {
        const auto press = [&](Qt::KeyboardModifiers modifiers, QWidget* at) {
            QTest::keyClick(at, Qt::Key_Z, modifiers);
            settle();
        };
        const auto undo = [&] { press(Qt::ControlModifier, dialog_->findChild<StripPreview*>()); };
        const auto redo = [&] { press(Qt::ControlModifier | Qt::ShiftModifier, dialog_->findChild<StripPreview*>()); };
        QApplication::setActiveWindow(dialog_);
        const QStringList views = solidViews(4);
        const ParameterValues before = dialog_->values();
        dialog_->openFiles(views);
        settle();
        const ParameterValues opened = dialog_->values();
        type("lensesPerInch", "40");
        const ParameterValues typed = dialog_->values();
        dialog_->findChild<SheetBar*>()->choose("20-flip");
        settle();
        const ParameterValues chosen = dialog_->values();
        QVERIFY(opened != before && typed != opened && chosen != typed);

        undo();
        QVERIFY(dialog_->values() == typed);
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString("40-3d"));
        QVERIFY(std::abs(number("LPI in the file") - 40) < 1);
        undo();
        QVERIFY(dialog_->values() == opened);
        QCOMPARE(dialog_->files(), views);
        undo();
        QVERIFY(dialog_->files().isEmpty());
        QVERIFY(!button("Export")->isEnabled());
        undo();  // There is nothing before it.
        QVERIFY(dialog_->values() == before);

        redo();
        QCOMPARE(dialog_->files(), views);
        QVERIFY(button("Export")->isEnabled());
        redo();
        redo();
        QVERIFY(dialog_->values() == chosen);
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString("20-flip"));
        // Also from a number field without typed text.
        press(Qt::ControlModifier, dialog_->findChild<ParameterPanel*>()->row("phase")->findChild<NumberField*>());
        QVERIFY(dialog_->values() == typed);
    }

    void aDragIsOneStepOfUndo()
    {
        const ParameterValues before = dialog_->values();
        auto* panel = dialog_->findChild<ParameterPanel*>();
        ParameterValues values = before;
        const std::size_t phase = *values.table().find("phase");
        const Gesture gesture = newGesture();
        for (const double to : {0.1, 0.2, 0.3}) {
            values.setParameter(phase, to);
            emit panel->row("phase")->findChild<NumberField*>()->edited(to, gesture);
        }
        settle();
        QVERIFY(dialog_->values() == values);
        QApplication::setActiveWindow(dialog_);
        QTest::keyClick(dialog_->findChild<StripPreview*>(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(dialog_->values() == before);
    }
};

VITRINE_UI_TEST(PrintSheetsTest)

#include "print_sheets_test.moc"
