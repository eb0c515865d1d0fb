#include "tests/ui/ui_main.h"

#include "exhibits/printing/print_json.h"
#include "render/files/read_file.h"
#include "tests/ui/print/open_print_dialog.h"

#include "ui/print/eyes_preview.h"
#include "ui/print/strip_preview.h"

#include <QMessageBox>
#include <QTabBar>

using namespace vitrine;
using namespace vitrine::ui;

/// Writing of prints and charts by the print dialog, and failures.
class PrintExportTest : public test::OpenPrintDialog {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longExportWritesAPrintWhoseJsonIsTheSettings()
    {
        const QStringList views = solidViews(6);
        dialog_->openFiles(views);
        set("phase", 0.25);
        set("width", 0.05);
        set("height", 0.03);
        const QString out = home_->filePath("out");
        QDir().mkpath(out);
        dialog_->setPath(out + "/card.tif");
        settle();
        const ParameterValues before = dialog_->values();
        button("Export")->click();
        QVERIFY(dialog_->exporting());
        QTRY_VERIFY(!dialog_->exporting());
        QVERIFY2(said().contains("Saved " + out + "/card.tif"), qPrintable(said()));
        QCOMPARE(filesIn(out), (QStringList{"card.tif", "card.tif.json"}));
        const printing::SavedSettings written =
            printing::savedSettings(render::readFile((out + "/card.tif.json").toStdString(), 1 << 20), "card.tif.json");
        QVERIFY(written.values == before);
        QCOMPARE(printing::picturesOf(written.values).size(), std::size_t{6});

        // After changing everything, dropping the print on the dialog restores all settings.
        set("phase", 0);
        set("lensesPerInch", 30);
        dialog_->openFiles({out + "/card.tif"});
        settle();
        QVERIFY(dialog_->values() == before);
        QCOMPARE(dialog_->files(), views);
    }

    void nothingThatIsFinishedIsReplacedWithoutAQuestion()
    {
        dialog_->openFiles(solidViews(3));
        set("width", 0.02);
        set("height", 0.02);
        const QString out = home_->filePath("out");
        QDir().mkpath(out);
        // A chart has its own file name and never replaces a print.
        dialog_->setPath(out + "/card.tif");
        dialog_->setChart(true);
        QVERIFY2(dialog_->path().contains("chart"), qPrintable(dialog_->path()));
        dialog_->setChart(false);
        QCOMPARE(dialog_->path(), out + "/card.tif");
        settle();
        const auto write = [&] {
            dialog_->startExport();
            QTRY_VERIFY(!dialog_->exporting());
        };
        const auto answer = [&](const char* button) {
            dialog_->setPath(out + "/card.tif");
            settle();
            dialog_->startExport();
            QVERIFY(!dialog_->exporting());
            auto* chosen = dialog_->findChild<QMessageBox*>()->findChild<QPushButton*>(button);
            if (chosen)
                chosen->click();
            else
                dialog_->findChild<QMessageBox*>()->reject();
            QTRY_VERIFY(!dialog_->findChild<QMessageBox*>());
            QTRY_VERIFY(!dialog_->exporting());
        };
        write();
        QCOMPARE(filesIn(out), (QStringList{"card.tif", "card.tif.json"}));
        // The next export has the next free name automatically.
        QCOMPARE(dialog_->path(), out + "/card-2.tif");
        const QByteArray first = contentOf(out + "/card.tif");
        set("phase", 0.5);
        answer("no such button");
        QCOMPARE(contentOf(out + "/card.tif"), first);
        answer("keepBoth");
        QCOMPARE(contentOf(out + "/card.tif"), first);
        QCOMPARE(filesIn(out), (QStringList{"card-2.tif", "card-2.tif.json", "card.tif", "card.tif.json"}));
        answer("replace");
        QVERIFY(contentOf(out + "/card.tif") != first);
    }

    void longCancelAndEscapeLeaveNoFileAndTheDialogOpen()
    {
        dialog_->openFiles(solidViews(12));
        settle();
        set("width", 1.2);
        set("height", 1.2);  // 34,000 x 34,000 dots take several seconds.
        const QString out = home_->filePath("out");
        QDir().mkpath(out);
        dialog_->setPath(out + "/card.tif");
        settle();
        dialog_->startExport();
        QTest::qWait(300);
        QVERIFY(dialog_->exporting());
        button("Cancel")->click();
        QTRY_VERIFY(!dialog_->exporting());
        QCOMPARE(filesIn(out), QStringList());
        dialog_->startExport();
        QVERIFY(dialog_->exporting());
        QTest::keyClick(dialog_, Qt::Key_Escape);
        QTRY_VERIFY(!dialog_->exporting());
        QVERIFY(dialog_->isVisible());
        QCOMPARE(filesIn(out), QStringList());
        QVERIFY(button("Export")->isEnabled());
        QCOMPARE(said(), QString());
    }

    void aFolderThatIsNotThereGivesAMessageAndNothingIsLost()
    {
        dialog_->openFiles(solidViews(3));
        settle();
        set("width", 0.03);
        set("height", 0.02);
        const ParameterValues before = dialog_->values();
        dialog_->setPath(home_->filePath("nowhere/card.tif"));
        settle();
        dialog_->startExport();
        QTRY_VERIFY(!dialog_->exporting());
        QVERIFY2(said().contains("nowhere/card.tif"), qPrintable(said()));
        QVERIFY(dialog_->values() == before);
        QVERIFY(!QDir(home_->filePath("nowhere")).exists());
        QVERIFY(button("Export")->isEnabled());
        // The same for unreadable views.
        dialog_->openFiles({home_->filePath("absent.png"), home_->filePath("absent2.png")});
        settle();
        QVERIFY2(said().contains("absent.png"), qPrintable(said()));
    }

    void longChartsAreWrittenToo()
    {
        QTabBar* tabs = dialog_->findChild<QTabBar*>();
        tabs->setCurrentIndex(1);
        settle();
        QVERIFY(!dialog_->findChild<EyesPreview*>()->isVisible());
        QVERIFY(dialog_->findChild<ParameterPanel*>()->row("chart")->isVisible());
        QVERIFY(!dialog_->findChild<ParameterPanel*>()->row("samples")->isVisible());
        const QString out = home_->filePath("out");
        QDir().mkpath(out);
        for (int kind = 0; kind < 4; ++kind) {
            set("chart", kind);
            const QString file = QStringLiteral("%1/chart%2.png").arg(out).arg(kind);
            dialog_->setPath(file);
            settle();
            QVERIFY(button("Export chart")->isEnabled());
            button("Export chart")->click();
            QTRY_VERIFY(!dialog_->exporting());
            QVERIFY2(QFile::exists(file), qPrintable(said()));
        }
        tabs->setCurrentIndex(0);
        settle();
        QVERIFY(!dialog_->findChild<ParameterPanel*>()->row("chart")->isVisible());
    }

    void whileAPrintIsWrittenNothingIsUndone()
    {
        dialog_->openFiles(solidViews(12));
        settle();
        set("width", 1.2);
        set("height", 1.2);
        const ParameterValues before = dialog_->values();
        dialog_->setPath(home_->filePath("card.tif"));
        settle();
        dialog_->startExport();
        QVERIFY(dialog_->exporting());
        QApplication::setActiveWindow(dialog_);
        QTest::keyClick(dialog_->findChild<StripPreview*>(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(dialog_->values() == before);
        dialog_->stopExport();
        QTRY_VERIFY(!dialog_->exporting());
        QTest::keyClick(dialog_->findChild<StripPreview*>(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(dialog_->values() != before);
    }
};

VITRINE_UI_TEST(PrintExportTest)

#include "print_export_test.moc"
