#include "exhibits/framework/state_folder.h"
#include "exhibits/printing/print_json.h"
#include "exhibits/printing/sheet.h"
#include "render/files/read_file.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/theme.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/print/eyes_preview.h"
#include "ui/print/print_dialog.h"
#include "ui/print/print_numbers.h"
#include "ui/print/sheet_bar.h"
#include "ui/print/source_bar.h"
#include "ui/print/strip_preview.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <clocale>
#include <cmath>
#include <memory>

using namespace vitrine;
using namespace vitrine::ui;

/// The print dialog with views from files: no OpenGL.
class PrintDialogTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> home_;
    QPointer<PrintDialog> dialog_;

    void openDialog()
    {
        dialog_ = new PrintDialog(nullptr, nullptr);
        dialog_->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog_, vitrine::test::patience));
        settle();
    }
    void settle() { QTRY_VERIFY(dialog_->settled()); }
    void closeDialog()
    {
        if (dialog_) dialog_->close();
        QTRY_VERIFY(!dialog_);
    }
    [[nodiscard]] static QColor colorOf(int view, int count) { return QColor::fromHsv(view * 300 / count, 255, 220); }
    QStringList solidViews(int count)
    {
        QStringList files;
        for (int k = 0; k < count; ++k) {
            QImage image(60, 40, QImage::Format_RGB32);
            image.fill(colorOf(k, count));
            files << home_->filePath(QStringLiteral("view%1.png").arg(k));
            image.save(files.back());
        }
        return files;
    }
    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Types a number, as a visitor does.
    void type(const char* row, const QString& text)
    {
        auto* field = dialog_->findChild<ParameterPanel*>()->row(row)->findChild<NumberField*>();
        QVERIFY(field);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Return);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        settle();
    }
    void set(const char* row, double value)
    {
        ParameterValues values = dialog_->values();
        values.setRow(*values.table().find(row), value);
        dialog_->setValues(values);
        settle();
    }
    [[nodiscard]] double number(const char* label)
    {
        return dialog_->findChild<PrintNumbersView*>()->shown(QString::fromLatin1(label)).section(' ', 0, 0).toDouble();
    }
    [[nodiscard]] QString warnings() { return dialog_->findChild<PrintNumbersView*>()->messages(); }
    [[nodiscard]] QString said() { return dialog_->findChild<MessageStrip*>()->texts().join('\n'); }
    QPushButton* button(const QString& text)
    {
        for (QPushButton* each : dialog_->findChildren<QPushButton*>())
            if (each->text() == text) return each;
        return nullptr;
    }
    [[nodiscard]] QStringList filesIn(const QString& folder)
    {
        return QDir(folder).entryList(QDir::Files | QDir::Hidden, QDir::Name);
    }

private slots:
    void initTestCase()
    {
        std::setlocale(LC_NUMERIC, "C");
        applyTheme(*qApp, darkTheme());
    }
    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        QVERIFY(home_->isValid());
        for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
            qputenv(name, home_->path().toLocal8Bit());
        openDialog();
    }
    void cleanup()
    {
        if (dialog_) closeDialog();
    }

    void opensWithNumbersAndWithoutViewsNothingCanBeExported()
    {
        QVERIFY(number("Pixels per lens") > 12);
        QCOMPARE(warnings(), QString());
        QVERIFY(!button("Export")->isEnabled());
        QVERIFY(dialog_->findChild<SourceBar*>()->said().contains("drop"));
        dialog_->open(solidViews(4));
        settle();
        QVERIFY(button("Export")->isEnabled());
        QVERIFY(dialog_->findChild<SourceBar*>()->said().contains("4 views"));
        QCOMPARE(dialog_->findChild<PrintNumbersView*>()->shown("Views that show"), QString("4 of 4"));
    }

    void typingAnotherLpiUpdatesTheNumbersAsTheClosedFormSays()
    {
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
        dialog_->open(solidViews(3));  // 3:2, for a print of 148 x 105.
        settle();
        QVERIFY2(warnings().contains("stretched"), qPrintable(warnings()));
        set("width", 0.1575);
        QCOMPARE(warnings(), QString());
    }

    void aSheetThatCannotBeIsRefusedWithItsLimitAndNothingIsExported()
    {
        dialog_->open(solidViews(4));
        settle();
        QVERIFY(button("Export")->isEnabled());
        set("width", 0.1575);  // The views' shape.
        set("zone", 1.2);      // Of 58.5 degrees at most, with this index.
        QVERIFY2(warnings().contains("58.49"), qPrintable(warnings()));
        QVERIFY(!button("Export")->isEnabled());
        set("zone", 0.6);  // A sheet for depth: of one for flips, the dialog would warn.
        QCOMPARE(warnings(), QString());
        QVERIFY(button("Export")->isEnabled());
    }

    void draggingTurnsTheCardThroughItsViews()
    {
        const int count = 5;
        dialog_->open(solidViews(count));
        settle();
        ParameterValues values = dialog_->values();
        values.setRow(*values.table().find("infiniteDistance"), 1.0);  // One direction for the whole card.
        values.setRow(*values.table().find("width"), 0.03);
        values.setRow(*values.table().find("height"), 0.02);
        values.setRow(*values.table().find("dotsPerInch"), 1440.0);
        dialog_->setValues(values);
        settle();
        auto* eyes = dialog_->findChild<EyesPreview*>();
        // Chief rays: the middle of view k's part of a zone of 30 degrees; the mean over the lens differs by 4 %.
        for (const int k : {0, 4, 2, 3, 1}) {
            const double angle = std::atan(((k + 0.5) / count - 0.5) * 2 * std::tan(3.14159265358979 / 12) * 1.04);
            const QPoint from(200, 60);
            const QPoint to =
                from +
                QPoint(static_cast<int>(std::lround((angle - eyes->angle()) / (0.15 * 3.14159265358979 / 180))), 0);
            QTest::mousePress(eyes, Qt::LeftButton, {}, from);
            QTest::mouseMove(eyes, (from + to) / 2);
            QTest::mouseMove(eyes, to);
            QTest::mouseRelease(eyes, Qt::LeftButton, {}, to);
            QVERIFY(std::abs(eyes->angle() - angle) < 0.003);
            QTRY_COMPARE(eyes->shownAngle(), eyes->angle());
            for (const std::size_t eye : {std::size_t{0}, std::size_t{1}}) {
                const QImage& seen = eyes->seen(eye);
                const QColor at = seen.pixelColor(seen.width() / 2, seen.height() / 2);
                int best = 0;
                int bestDistance = 1000;
                for (int view = 0; view < count; ++view) {
                    const QColor color = colorOf(view, count);
                    const int distance = std::abs(color.red() - at.red()) + std::abs(color.green() - at.green()) +
                                         std::abs(color.blue() - at.blue());
                    if (distance < bestDistance) best = view;
                    bestDistance = std::min(bestDistance, distance);
                }
                QCOMPARE(best, k);
            }
        }
    }

    void theTwoEyesSeeNeighboringViewsAtAFiniteDistance()
    {
        const int count = 12;
        dialog_->open(solidViews(count));
        settle();
        auto* eyes = dialog_->findChild<EyesPreview*>();
        QTRY_VERIFY(!eyes->seen(1).isNull());
        const auto hue = [&](std::size_t eye) {
            return eyes->seen(eye).pixelColor(eyes->seen(eye).width() / 2, eyes->seen(eye).height() / 2).hueF();
        };
        // 65 mm at 400 mm are 9.3 of the zone's 31 degrees, so about 3.6 of 12 views, of 25 degrees of hue each.
        const double views = static_cast<double>(hue(1) - hue(0)) * 360 / 25;
        QVERIFY2(views > 2.6 && views < 4.6, qPrintable(QString::number(views)));
        QTest::keyClick(eyes, Qt::Key_Right);
        QVERIFY(std::abs(eyes->angle() - 3.14159265358979 / 180) < 1e-9);
        QTest::keyClick(eyes, Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(std::abs(eyes->angleAlong() - 3.14159265358979 / 1800) < 1e-9);
        QTest::keyClick(eyes, Qt::Key_Home);
        QCOMPARE(eyes->angle(), 0.0);
    }

    void exportWritesAPrintWhoseJsonIsTheSettings()
    {
        const QStringList views = solidViews(6);
        dialog_->open(views);
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
        QCOMPARE(written.sources.size(), std::size_t{6});

        // Everything else, then the print dropped on the dialog: all is back.
        set("phase", 0);
        set("lensesPerInch", 30);
        dialog_->open({out + "/card.tif"});
        settle();
        QVERIFY(dialog_->values() == before);
        QCOMPARE(dialog_->files(), views);
    }

    void nothingThatIsFinishedIsReplacedWithoutAQuestion()
    {
        dialog_->open(solidViews(3));
        set("width", 0.02);
        set("height", 0.02);
        const QString out = home_->filePath("out");
        QDir().mkpath(out);
        // A chart has a name of its own: it never takes a print's place.
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
        // The next one is written beside it without being asked for.
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

    void cancelAndEscapeLeaveNoFileAndTheDialogOpen()
    {
        dialog_->open(solidViews(12));
        settle();
        set("width", 1.2);
        set("height", 1.2);  // 34,000 x 34,000 dots: seconds at least.
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
        dialog_->open(solidViews(3));
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
        // And views that cannot be read.
        dialog_->open({home_->filePath("absent.png"), home_->filePath("absent2.png")});
        settle();
        QVERIFY2(said().contains("absent.png"), qPrintable(said()));
    }

    void chartsAreWrittenToo()
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

    void theRasterIsZoomedByTheWheelAboutThePointer()
    {
        dialog_->open(solidViews(3));
        settle();
        auto* strips = dialog_->findChild<StripPreview*>();
        QTRY_VERIFY(!strips->image().isNull());
        const double before = strips->zoom();
        const QPointF at(40, 30);
        for (int i = 0; i < 4; ++i) {
            QWheelEvent turn(at, strips->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
            QApplication::sendEvent(strips, &turn);
        }
        QVERIFY(std::abs(strips->zoom() / before - std::pow(1.25, 4)) < 1e-9);
        QTest::keyClick(strips, Qt::Key_Minus);
        QVERIFY(strips->zoom() < before * 2);
        for (int i = 0; i < 40; ++i) QTest::keyClick(strips, Qt::Key_Minus);
        QTRY_VERIFY(strips->image().width() > strips->width());  // Whole dots, shown smaller.
    }

    void whatWasSetComesBackTheNextTime()
    {
        dialog_->open(solidViews(5));
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
        other.write("{\"vitrinePrint\": 7}");
        other.close();
        dialog_->open({other.fileName()});
        QVERIFY2(said().contains("other.json"), qPrintable(said()));
        QVERIFY(dialog_->files().isEmpty());
    }

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
        bar->save("40-3d");  // A shipped one: refused.
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
            // Derived for 30 and 50 degrees by the paraxial focus; the exact ray through the middle differs by a
            // little.
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

    void settingsFilesAndSheetsAreUndoneAndRedone()
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
        dialog_->open(views);
        settle();
        type("lensesPerInch", "40");
        const ParameterValues typed = dialog_->values();
        dialog_->findChild<SheetBar*>()->choose("20-flip");
        settle();
        const ParameterValues chosen = dialog_->values();
        QVERIFY(typed != before && chosen != typed);

        undo();
        QVERIFY(dialog_->values() == typed);
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString("40-3d"));
        QVERIFY(std::abs(number("LPI in the file") - 40) < 1);
        undo();
        QVERIFY(dialog_->values() == before);
        QCOMPARE(dialog_->files(), views);
        undo();
        QVERIFY(dialog_->files().isEmpty());
        QVERIFY(!button("Export")->isEnabled());
        undo();  // Nothing before that.
        QVERIFY(dialog_->values() == before);

        redo();
        QCOMPARE(dialog_->files(), views);
        QVERIFY(button("Export")->isEnabled());
        redo();
        redo();
        QVERIFY(dialog_->values() == chosen);
        QCOMPARE(dialog_->findChild<SheetBar*>()->current(), QString("20-flip"));
        // Also from a number field in which nothing is typed.
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
            values.setRow(phase, to);
            emit panel->row("phase")->findChild<NumberField*>()->edited(to, gesture);
        }
        settle();
        QVERIFY(dialog_->values() == values);
        QApplication::setActiveWindow(dialog_);
        QTest::keyClick(dialog_->findChild<StripPreview*>(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(dialog_->values() == before);
    }

    void whileAPrintIsWrittenNothingIsUndone()
    {
        dialog_->open(solidViews(12));
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

    void escClosesAndEveryControlIsReachedByTabAndHasAName()
    {
        dialog_->open(solidViews(3));
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
        dialog_->open(solidViews(3));
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

QTEST_MAIN(PrintDialogTest)
#include "print_dialog_test.moc"
