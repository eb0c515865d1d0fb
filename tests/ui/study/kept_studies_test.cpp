// Studies kept, compared and exported in the real dock. No GL.

#include "tests/ui/study/open_study_dock.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/name_dialog.h"
#include "ui/study/comparison_chart.h"
#include "ui/study/comparison_dialog.h"
#include "ui/study/kept_studies.h"
#include "ui/study/large_pictures.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_dock.h"
#include "ui/study/study_pictures.h"
#include "ui/study/study_view.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

class KeptStudiesTest : public test::OpenStudyDock {
    Q_OBJECT

    [[nodiscard]] QListWidget* list() { return dock_->kept().findChild<QListWidget*>(); }
    void showList()
    {
        for (QToolButton* button : dock_->findChildren<QToolButton*>())
            if (button->text() == QLatin1String("History")) button->click();
        QTRY_VERIFY(list()->isVisible() && dock_->kept().width() >= list()->minimumWidth());
    }
    [[nodiscard]] StudyPictures* pictures() { return dock_->view().findChild<StudyPictures*>(); }
    [[nodiscard]] QPushButton* button(const QString& start)
    {
        for (QPushButton* each : dock_->findChildren<QPushButton*>())
            if (each->text().startsWith(start)) return each;
        return nullptr;
    }
    [[nodiscard]] QAction* listAction(const QString& text)
    {
        for (QAction* each : list()->actions())
            if (each->text() == text) return each;
        return nullptr;
    }
    [[nodiscard]] QStringList words()
    {
        QStringList all;
        for (const QLabel* label : dock_->view().findChildren<QLabel*>()) all << label->text();
        return all;
    }
    [[nodiscard]] double stepsNow()
    {
        return std::get<double>(history_->sceneState().values[1].row(*gallery_->table.find("steps")));
    }
    void tick(int row)
    {
        list()->setCurrentRow(row);
        QTest::keyClick(list(), Qt::Key_Space);
        QCOMPARE(list()->item(row)->checkState(), Qt::Checked);
    }
    /// Writes a changed copy of a study's file.
    [[nodiscard]] QString changedFile(const QString& name, const std::function<void(QJsonObject&)>& change)
    {
        const study::StudyStore store = test::storeIn(home_->path());
        QFile file(QString::fromStdString(store.list().front().path.string()));
        if (!file.open(QIODevice::ReadOnly)) return {};
        QJsonObject object = QJsonDocument::fromJson(file.readAll()).object();
        change(object);
        const QString path = home_->filePath(name);
        QFile out(path);
        if (!out.open(QIODevice::WriteOnly)) return {};
        out.write(QJsonDocument(object).toJson());
        return path;
    }

private slots:
    void init() { start(); }
    void cleanup() { close(); }

    void longAFinishedStudyIsKeptAndSurvivesARestart()
    {
        measure("steps");
        const std::size_t points = dock_->result().points.size();
        const QSize size(400, 180);
        pictures()->setFixedSize(size);
        const QImage measured = pictures()->grab().toImage();
        close();
        open();
        showList();
        QCOMPARE(list()->count(), 1);
        QCOMPARE(list()->item(0)->text(), QString("Known: Steps"));
        QVERIFY(list()->item(0)->toolTip().contains("the painter"));
        QTest::keyClick(list(), Qt::Key_Return);
        QVERIFY(dock_->view().showsKept());
        QCOMPARE(dock_->chart().points().size(), points);
        // Its pictures are read a moment later.
        QTRY_VERIFY(pictures()->accessibleText().isEmpty());
        QVERIFY(!words().join(' ').contains("pictures were not kept"));
        QTest::keyClick(pictures(), Qt::Key_Return);
        auto* large = dock_->findChild<LargePictures*>();
        QVERIFY(large && large->isVisible());
        large->close();
        pictures()->setFixedSize(size);
        const QImage kept = pictures()->grab().toImage();
        QCOMPARE(kept, measured);
        // A click applies its values, like for a study that was just measured.
        const auto& shown = dock_->chart().points();
        std::size_t other = 0;
        while (shown[other].present) ++other;
        QVERIFY(std::any_of(shown.begin(), shown.end(), [](const ChartPoint& p) { return p.present; }));
        const double before = stepsNow();
        dock_->chart().replot();
        QTest::mouseClick(&dock_->chart(), Qt::LeftButton, {}, dock_->chart().placeOf(other).toPoint());
        QVERIFY(stepsNow() != before);
        QTRY_VERIFY(dock_->chart().points()[other].present);
        history_->stack().undo();
        QCOMPARE(stepsNow(), before);
    }

    void aStoppedStudyIsKeptOnceItHasThreeSettings()
    {
        gallery_->frame = std::chrono::milliseconds(5);
        dock_->ask(1, *gallery_->table.find("rays"));
        dock_->stop();
        QVERIFY(test::storeIn(home_->path()).list().empty());
        dock_->ask(1, *gallery_->table.find("rays"));
        QTRY_VERIFY_WITH_TIMEOUT(std::count_if(dock_->chart().points().begin(), dock_->chart().points().end(),
                                               [](const ChartPoint& p) { return p.cost > 0; }) >= 3,
                                 20000);
        QVERIFY(dock_->running());
        dock_->stop();
        const std::vector<study::StudyEntry> kept = test::storeIn(home_->path()).list();
        QCOMPARE(kept.size(), std::size_t{1});
        QCOMPARE(kept[0].problem, std::string());
        QVERIFY(!kept[0].study.complete);
        QVERIFY(kept[0].study.measuredPoints() >= 3);
        showList();
        QVERIFY(list()->item(0)->data(Qt::AccessibleTextRole).toString().contains("stopped early"));
    }

    void oneIsRenamedDeletedAndBroughtBack()
    {
        measure("method");
        showList();
        QTest::keyClick(list(), Qt::Key_F2);
        auto* ask = dock_->findChild<NameDialog*>();
        QVERIFY(ask);
        auto* line = ask->findChild<QLineEdit*>();
        line->selectAll();
        QTest::keyClicks(line, "Before the grid");
        ask->accept();
        QTRY_COMPARE(list()->item(0)->text(), QString("Before the grid"));
        QCOMPARE(history_->stack().count(), 0);
        QTest::keyClick(list(), Qt::Key_Delete);
        QCOMPARE(list()->count(), 0);
        QVERIFY(history_->stack().undoText().contains("Before the grid"));
        history_->stack().undo();
        QCOMPARE(list()->count(), 1);
        QCOMPARE(list()->item(0)->text(), QString("Before the grid"));
        history_->stack().redo();
        QCOMPARE(list()->count(), 0);
    }

    void longTickedOnesAreComparedByWhatTheyShare()
    {
        measure("steps");
        measure("rays");
        showList();
        QCOMPARE(list()->count(), 2);
        QVERIFY(!button("Compare")->isEnabled());
        tick(0);
        QVERIFY(!button("Compare")->isEnabled());
        tick(1);
        QSignalSpy failed(dock_.get(), &StudyDock::failed);
        QTest::mouseClick(button("Compare 2"), Qt::LeftButton);
        auto* dialog = dock_->findChild<ComparisonDialog*>();
        QVERIFY2(failed.isEmpty(), failed.isEmpty() ? "" : qPrintable(failed[0][0].toString()));
        QVERIFY(dialog && dialog->isVisible());
        const study::StudyComparison& comparison = dialog->chart().comparison();
        QCOMPARE(comparison.curves.size(), std::size_t{2});
        QCOMPARE(comparison.cost, std::string("ms"));
        QCOMPARE(dialog->chart().legend->itemCount(), 2);
        // Distinguished by mark and line, and not by color only.
        QList<QCPGraph*> fronts;
        for (int i = 0; i < dialog->chart().graphCount(); ++i)
            if (dialog->chart().legend->hasItemWithPlottable(dialog->chart().graph(i)))
                fronts << dialog->chart().graph(i);
        QCOMPARE(fronts.size(), 2);
        QVERIFY(fronts[0]->scatterStyle().shape() != fronts[1]->scatterStyle().shape());
        QVERIFY(fronts[0]->pen().style() != fronts[1]->pen().style());
        auto* table = dialog->findChild<QTableWidget*>();
        QCOMPARE(static_cast<std::size_t>(table->rowCount()), comparison.differences.size());
        QVERIFY(table->rowCount() > 0);
        // One machine, size and clock: milliseconds are offered, with their confidence.
        auto* costs = dialog->findChild<QComboBox*>();
        QStringList cells;
        for (int row = 0; row < table->rowCount(); ++row) cells << table->item(row, 5)->text();
        QVERIFY2(cells.join(' ').contains("% confidence"), qPrintable(cells.join('\n')));
        costs->setCurrentIndex(costs->findData("work"));
        QCOMPARE(dialog->chart().comparison().cost, std::string("work"));
        costs->setCurrentIndex(costs->findData("ms"));
        QVERIFY(dialog->exported("csv").contains("ratio of costs"));
        QVERIFY(QJsonDocument::fromJson(dialog->exported("json")).object()["differences"].toArray().size() ==
                table->rowCount());
        QVERIFY(dialog->exported("svg").contains("<svg"));
        QCOMPARE(QImage::fromData(dialog->exported("png")).size(), QSize(1920, 1200));
    }

    void timesOfTwoMachinesAreNotComparedAndWorkIs()
    {
        measure("steps");
        const QString other = changedFile("elsewhere.json", [](QJsonObject& study) {
            QJsonObject machine = study["machine"].toObject();
            machine["renderer"] = "a graphics card";
            study["machine"] = machine;
        });
        showList();
        dock_->kept().openFile(other);
        QCOMPARE(list()->count(), 2);
        QVERIFY(dock_->view().showsKept());
        tick(0);
        tick(1);
        QTest::mouseClick(button("Compare 2"), Qt::LeftButton);
        auto* dialog = dock_->findChild<ComparisonDialog*>();
        QVERIFY(dialog);
        auto* costs = dialog->findChild<QComboBox*>();
        QCOMPARE(costs->findData("ms"), -1);
        QVERIFY(costs->findData("work") >= 0);
        QStringList said;
        for (const QLabel* label : dialog->findChildren<QLabel*>())
            if (label->isVisible()) said << label->text();
        QVERIFY2(said.join(' ').contains("different machines"), qPrintable(said.join('\n')));
    }

    void aStudyOfWhatIsNotHereShowsItsNumbersAndIsNotApplied()
    {
        measure("steps");
        const QString file = changedFile("gone.json", [](QJsonObject& study) { study["exhibit"] = "gone"; });
        showList();
        dock_->kept().openFile(file);
        QVERIFY(dock_->view().showsKept());
        QVERIFY(words().join(' ').contains(QString::fromUtf8("no exhibit “gone”")));
        QVERIFY(words().join(' ').contains("pictures were not kept"));
        QSignalSpy failed(dock_.get(), &StudyDock::failed);
        const SceneState before = history_->sceneState();
        dock_->chart().replot();
        QTest::mouseClick(&dock_->chart(), Qt::LeftButton, {}, dock_->chart().placeOf(0).toPoint());
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed[0][0].toString().contains("gone"));
        QVERIFY(history_->sceneState() == before);
        QCOMPARE(history_->stack().count(), 0);
    }

    void aDamagedFileIsSaidOnceAndNothingIsLost()
    {
        measure("steps");
        showList();
        const QString shown = words().join(' ');
        const QString file = changedFile("damaged.json", [](QJsonObject& study) { study["front"] = "soup"; });
        QSignalSpy failed(dock_.get(), &StudyDock::failed);
        dock_->kept().openFile(file);
        QCOMPARE(failed.count(), 1);
        QVERIFY2(failed[0][0].toString().contains("damaged.json") && failed[0][0].toString().contains("front"),
                 qPrintable(failed[0][0].toString()));
        QCOMPARE(list()->count(), 1);
        QCOMPARE(words().join(' '), shown);
    }

    void longTickedOnesAreCopiedAndSaved()
    {
        measure("steps");
        measure("rays");
        showList();
        tick(0);
        tick(1);
        const qsizetype points = static_cast<qsizetype>(test::storeIn(home_->path()).list()[0].study.points.size() +
                                                        test::storeIn(home_->path()).list()[1].study.points.size());
        listAction("Copy the ticked as a table")->trigger();
        QCOMPARE(QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts).size(), 1 + points);
        for (const char* name : {"two.csv", "two.json", "two.png", "two.svg"}) {
            const QString path = home_->filePath(name);
            // The dialog is modal and is answered by a timer.
            QTimer answer;
            connect(&answer, &QTimer::timeout, &answer, [&] {
                auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
                if (!dialog) return;
                answer.stop();
                dialog->findChild<QLineEdit*>()->setText(path);
                static_cast<QDialog*>(dialog)->accept();
            });
            answer.start(20);
            qApp->setAttribute(Qt::AA_DontUseNativeDialogs);
            listAction("Save the ticked…")->trigger();
            QTRY_VERIFY2(QFileInfo(path).size() > 100, name);
        }
        QCOMPARE(QImage(home_->filePath("two.png")).size(), QSize(1920, 1200));
        // A file with several studies can be opened.
        close();
        const QString kept = home_->path() + "/studies";
        QVERIFY(QDir(kept).removeRecursively());
        open();
        showList();
        dock_->kept().openFile(home_->filePath("two.json"));
        QCOMPARE(list()->count(), 2);
    }
};

}  // namespace

VITRINE_UI_TEST(KeptStudiesTest)
#include "kept_studies_test.moc"
