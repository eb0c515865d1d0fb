// Studies that are kept, compared and exported, and their pictures large, in the real dock. No GL.

#include "tests/ui/study/known_gallery.h"

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
#include <QWheelEvent>
#include <QtTest>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

class KeptStudiesTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<test::KnownGallery> gallery_;
    std::unique_ptr<History> history_;
    std::unique_ptr<RenderThread> thread_;
    std::unique_ptr<StudyDock> dock_;

    void open()
    {
        gallery_ = std::make_unique<test::KnownGallery>();
        history_ = std::make_unique<History>(gallery_->museum.initialSceneState());
        thread_ = std::make_unique<RenderThread>(*gallery_);
        dock_ =
            std::make_unique<StudyDock>(gallery_->museum, *gallery_, *history_, *thread_, test::storeIn(home_->path()));
        dock_->setEffort({16, 9}, 3);
        dock_->setSubject(1);
        dock_->resize(1100, 360);
        dock_->show();
    }
    void close()
    {
        dock_.reset();
        thread_.reset();
        history_.reset();
        gallery_.reset();
    }
    void measure(const char* parameter)
    {
        QSignalSpy finished(dock_.get(), &StudyDock::finished);
        dock_->ask(1, *gallery_->table.find(parameter));
        QVERIFY(finished.wait(20000));
    }
    [[nodiscard]] QListWidget* list() { return dock_->kept().findChild<QListWidget*>(); }
    void showList()
    {
        for (QToolButton* button : dock_->findChildren<QToolButton*>())
            if (button->text() == QLatin1String("Kept")) button->click();
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
    /// A file of a study as the dock wrote it, changed.
    [[nodiscard]] QString changedFile(const QString& name, const std::function<void(QJsonObject&)>& change)
    {
        const StudyStore store = test::storeIn(home_->path());
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
    void init()
    {
        home_ = std::make_unique<QTemporaryDir>();
        QVERIFY(home_->isValid());
        open();
    }
    void cleanup() { close(); }

    void aFinishedStudyIsKeptAndSurvivesARestart()
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
        QCOMPARE(list()->item(0)->text(), QString("Known: steps"));
        QVERIFY(list()->item(0)->toolTip().contains("the painter"));
        QTest::keyClick(list(), Qt::Key_Return);
        QVERIFY(dock_->view().showsKept());
        QCOMPARE(dock_->chart().points().size(), points);
        // Its pictures come a moment later.
        QTRY_VERIFY(pictures()->spokenText().isEmpty());
        QVERIFY(!words().join(' ').contains("pictures were not kept"));
        QTest::keyClick(pictures(), Qt::Key_Return);
        auto* large = dock_->findChild<LargePictures*>();
        QVERIFY(large && large->isVisible());
        large->close();
        pictures()->setFixedSize(size);
        const QImage kept = pictures()->grab().toImage();
        QCOMPARE(kept, measured);
        // A click applies its values, as of one that was just measured.
        const auto& shown = dock_->chart().points();
        std::size_t other = 0;
        while (shown[other].present) ++other;
        QVERIFY(std::any_of(shown.begin(), shown.end(), [](const ChartPoint& p) { return p.present; }));
        const double before = stepsNow();
        dock_->chart().replot();
        QTest::mouseClick(&dock_->chart(), Qt::LeftButton, {}, dock_->chart().placeOf(other).toPoint());
        QVERIFY(stepsNow() != before);
        QVERIFY(dock_->chart().points()[other].present);
        history_->stack().undo();
        QCOMPARE(stepsNow(), before);
    }

    void aStoppedStudyIsKeptOnceItHasThreeSettings()
    {
        dock_->ask(1, *gallery_->table.find("rays"));
        dock_->stop();
        QVERIFY(test::storeIn(home_->path()).list().empty());
        dock_->ask(1, *gallery_->table.find("rays"));
        QTRY_VERIFY_WITH_TIMEOUT(std::count_if(dock_->chart().points().begin(), dock_->chart().points().end(),
                                               [](const ChartPoint& p) { return p.cost > 0; }) >= 3,
                                 20000);
        QVERIFY(dock_->running());
        dock_->stop();
        const std::vector<StudyEntry> kept = test::storeIn(home_->path()).list();
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

    void tickedOnesAreComparedByWhatTheyShare()
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
        const StudyComparison& comparison = dialog->chart().comparison();
        QCOMPARE(comparison.curves.size(), std::size_t{2});
        QCOMPARE(comparison.cost, std::string("work"));
        QCOMPARE(dialog->chart().legend->itemCount(), 2);
        // Told apart by mark and line, not by color alone.
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
        // One machine, one size, one clock: milliseconds are offered, with how sure they are.
        auto* costs = dialog->findChild<QComboBox*>();
        costs->setCurrentIndex(costs->findData("ms"));
        QCOMPARE(dialog->chart().comparison().cost, std::string("ms"));
        QStringList cells;
        for (int row = 0; row < table->rowCount(); ++row) cells << table->item(row, 5)->text();
        QVERIFY2(cells.join(' ').contains("% confidence"), qPrintable(cells.join('\n')));
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

    void tickedOnesAreCopiedAndSaved()
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
            // The dialog is modal: it is answered from within.
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
        // What was saved together opens together.
        close();
        const QString kept = home_->path() + "/studies";
        QVERIFY(QDir(kept).removeRecursively());
        open();
        showList();
        dock_->kept().openFile(home_->filePath("two.json"));
        QCOMPARE(list()->count(), 2);
    }

    void aDoubleClickOpensThePicturesLargeAndTheyFollowTheStudy()
    {
        measure("steps");
        auto* small = dock_->findChild<StudyPictures*>();
        QTest::mouseDClick(small, Qt::LeftButton, {}, QPoint(20, 20));
        auto* large = dock_->findChild<LargePictures*>();
        QVERIFY(large && large->isVisible());
        QVERIFY(dock_->chart().isVisible());
        PicturePanes& panes = large->panes();
        QTRY_VERIFY(panes.panes().size() == 3);
        const QImage before = panes.grab().toImage();
        emit dock_->chart().hovered(0);
        QVERIFY(panes.grab().toImage() != before);
        // The view is that of the study, whichever of the two is changed.
        auto* view = large->findChild<QComboBox*>();
        QCOMPARE(view->count(), 3);
        view->setCurrentIndex(2);
        QCOMPARE(dock_->view().findChild<QComboBox*>()->currentIndex(), 2);
        large->close();
        QTest::keyClick(small, Qt::Key_Return);
        QVERIFY(large->isVisible());
        QCOMPARE(view->currentIndex(), 2);
    }

    void thePicturesAreZoomedAndMovedTogether()
    {
        LargePictures large;
        PicturePanes& panes = large.panes();
        render::Image picture(8, 4, 4), reference(8, 4, 4), errors(8, 4, 1);
        for (float& x : picture.pixels) x = 0.25F;
        for (float& x : reference.pixels) x = 0.5F;
        for (float& x : errors.pixels) x = 0.125F;
        picture.at(6, 1, 0) = 1;
        large.setPictures({picture, reference, errors, 1}, "a setting", "a scale");
        large.resize(900, 400);
        large.show();
        QVERIFY(QTest::qWaitForWindowExposed(&large));
        const double fitting = panes.scale();
        QVERIFY(fitting > 1);
        // Beyond 100 %, every pixel is a square of one color, in all panes at the same place.
        const auto colorAt = [&](std::size_t pane, QPointF pixel) {
            const QPointF at = panes.panes()[pane].center() + (pixel - panes.middle()) * panes.scale();
            return panes.grab().toImage().pixelColor(at.toPoint());
        };
        const QColor bright = colorAt(0, {6.2, 1.2});
        QVERIFY(bright.red() > 250);
        QCOMPARE(colorAt(0, {6.8, 1.8}), bright);
        QCOMPARE(colorAt(1, {6.2, 1.2}), colorAt(1, {6.8, 1.8}));
        // The wheel keeps the pixel below the pointer where it is, whichever pane it is in.
        const auto pixelAt = [&](std::size_t pane, QPointF at) {
            return (at - panes.panes()[pane].center()) / panes.scale() + panes.middle();
        };
        const QPointF at = panes.panes()[1].center() + QPointF(20, 10);
        const QPointF held = pixelAt(1, at);
        QWheelEvent wheel(at, panes.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(&panes, &wheel);
        QVERIFY(panes.scale() > 1.5 * fitting);
        const QPointF now = pixelAt(1, at);
        QVERIFY(std::abs(now.x() - held.x()) < 1e-6 && std::abs(now.y() - held.y()) < 1e-6);
        QCOMPARE(pixelAt(0, panes.panes()[0].center()), pixelAt(2, panes.panes()[2].center()));
        // Dragging takes the picture along.
        const QPoint start = panes.panes()[0].center().toPoint();
        const QPointF middle = panes.middle();
        QTest::mousePress(&panes, Qt::LeftButton, {}, start);
        QTest::mouseMove(&panes, start + QPoint(30, 0));
        QTest::mouseRelease(&panes, Qt::LeftButton, {}, start + QPoint(30, 0));
        QVERIFY(std::abs(middle.x() - panes.middle().x() - 30 / panes.scale()) < 0.05);
        // Keys do the same.
        panes.setFocus();
        QTest::keyClick(&panes, Qt::Key_0);
        const double scale = panes.scale();
        QTest::keyClick(&panes, Qt::Key_Plus);
        QVERIFY(panes.scale() > scale);
        QTest::keyClick(&panes, Qt::Key_Minus);
        QVERIFY(std::abs(panes.scale() - scale) < 1e-9);
        const double x = panes.middle().x();
        QTest::keyClick(&panes, Qt::Key_Right);
        QVERIFY(panes.middle().x() > x);
        QTest::keyClick(&panes, Qt::Key_1);
        QCOMPARE(panes.scale(), 1.0);
        QTest::keyClick(&panes, Qt::Key_0);
        QCOMPARE(panes.scale(), fitting);
    }

    void thePixelBelowThePointerIsReadInBoth()
    {
        LargePictures large;
        PicturePanes& panes = large.panes();
        render::Image picture(8, 4, 4), reference(8, 4, 4), errors(8, 4, 1);
        for (float& x : reference.pixels) x = 0.5F;
        picture.at(6, 1, 0) = 0.25F;
        errors.at(6, 1, 0) = 0.125F;
        large.setPictures({picture, reference, errors, 1}, {}, {});
        large.resize(900, 400);
        large.show();
        QVERIFY(QTest::qWaitForWindowExposed(&large));
        for (const std::size_t pane : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            const QPointF at = panes.panes()[pane].center() + (QPointF(6.5, 1.5) - panes.middle()) * panes.scale();
            QTest::mouseMove(&panes, at.toPoint());
            QTRY_COMPARE(panes.pixel(), std::optional(QPoint(6, 1)));
            QCOMPARE(panes.reading(), QString("Pixel 6, 1: setting 0.25 0 0; reference 0.5 0.5 0.5; error 0.125"));
        }
        // Without a pointer, it is the one in the middle.
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&panes, &leave);
        QCOMPARE(panes.pixel(), std::optional(QPoint(4, 2)));
        QStringList shown;
        for (const QLabel* label : large.findChildren<QLabel*>()) shown << label->text();
        QVERIFY(shown.contains(panes.reading()));
    }

    void theWipeIsDraggedByItsLine()
    {
        LargePictures large;
        PicturePanes& panes = large.panes();
        render::Image picture(8, 4, 4), reference(8, 4, 4), errors(8, 4, 1);
        for (float& x : reference.pixels) x = 1.0F;
        large.setPictures({picture, reference, errors, 1}, {}, {});
        large.resize(900, 400);
        large.show();
        QVERIFY(QTest::qWaitForWindowExposed(&large));
        QToolButton* wipe = nullptr;
        for (QToolButton* each : large.findChildren<QToolButton*>())
            if (each->text() == QLatin1String("Wipe")) wipe = each;
        QVERIFY(wipe);
        QTest::mouseClick(wipe, Qt::LeftButton);
        QCOMPARE(panes.panes().size(), std::size_t{2});
        const QPointF line = panes.panes()[0].center();
        const QPointF middle = panes.middle();
        const double quarter = 2 * panes.scale();
        QTest::mousePress(&panes, Qt::LeftButton, {}, line.toPoint());
        QTest::mouseMove(&panes, (line - QPointF(quarter, 0)).toPoint());
        QTest::mouseRelease(&panes, Qt::LeftButton, {}, (line - QPointF(quarter, 0)).toPoint());
        QVERIFY2(std::abs(panes.wipe() - 0.25) < 0.02, qPrintable(QString::number(panes.wipe())));
        QCOMPARE(panes.middle(), middle);
        const QImage seen = panes.grab().toImage();
        const double left = line.x() - 4 * panes.scale();
        QVERIFY(seen.pixelColor(QPointF(left + 1.5 * panes.scale(), line.y() + panes.scale() * 1.5).toPoint()).red() <
                5);
        QVERIFY(seen.pixelColor(QPointF(left + 5.5 * panes.scale(), line.y() + panes.scale() * 1.5).toPoint()).red() >
                250);
        QTest::keyClick(&panes, Qt::Key_Right, Qt::ControlModifier);
        QVERIFY(panes.wipe() > 0.27);
    }
};

}  // namespace

QTEST_MAIN(KeptStudiesTest)
#include "kept_studies_test.moc"
