// Bookmarks, copies of the picture, and recordings, in the real window.

#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/framework/files/state_folder.h"
#include "exhibits/jobs/record/record_table.h"
#include "exhibits/recording/tour.h"
#include "render/image/image_io.h"
#include "ui/export/copies.h"
#include "ui/jobs/job_dialog.h"
#include "ui/kit/message_strip.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/record/bookmarks.h"
#include "ui/record/bookmarks_dialog.h"

#include <QClipboard>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>

#include <fstream>

using namespace vitrine;
using namespace vitrine::ui;

class RecordWindowTest : public test::OpenWindow {
    Q_OBJECT

    [[nodiscard]] render::Camera camera() { return window_->history().sceneState().camera; }
    void stand(double x)
    {
        render::Camera there;
        there.eye.x = x;
        window_->viewport().visitor().jumpTo(there);
        settle();
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with)
    {
        QApplication::setActiveWindow(window_.get());  // Under Xvfb there is no window manager.
        QTest::keyClick(&window_->viewport(), key, with);
        settle();
    }
    [[nodiscard]] JobDialog* openDialog(jobs::RecordPath path)
    {
        action("Record…")->trigger();
        auto* dialog = window_->findChild<JobDialog*>();
        const jobs::RecordTable& t = jobs::recordTable();
        ParameterValues values = dialog->setup().values();
        values.set(t.path, path);
        values.set(t.seconds, 0.5);
        values.set(t.framesPerSecond, 10.0);
        values.set(t.width, 16);
        values.set(t.height, 16);
        values.set(t.samples, 1);
        dialog->setup().change("Change", values);
        waitFor(*dialog);
        return dialog;
    }
    static void waitFor(const JobDialog& dialog) { QTRY_VERIFY(dialog.settled()); }
    [[nodiscard]] QString at(const char* name) const { return home_->filePath(QString::fromUtf8(name)); }
    static bool says(const QDialog& dialog, const char* words)
    {
        for (const QLabel* label : dialog.findChildren<QLabel*>())
            if (label->text().contains(QString::fromUtf8(words))) return true;
        return false;
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void twoWindowsKeepEachOthersBookmarks()
    {
        Bookmarks a(*window_, window_.get()), b(*window_, window_.get());
        a.set(1);
        b.set(2);
        a.set(3);
        const Bookmarks read(*window_, window_.get());
        for (const int number : {1, 2, 3}) QVERIFY2(!read.name(number).isEmpty(), qPrintable(QString::number(number)));
        QVERIFY2(!a.name(2).isEmpty(), "it knows what it has read");
        b.forgetAll();
        a.set(4);
        QVERIFY(a.name(1).isEmpty());
        QVERIFY(!a.name(4).isEmpty());
    }

    void longABookmarkBringsBackWhereItWasSetAlsoInTheNextSession()
    {
        stand(0.5);
        const render::Camera kept = camera();
        press(Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(window_->bookmarks().name(3).left(1), QStringLiteral("3"));
        stand(-0.5);
        press(Qt::Key_4, Qt::NoModifier);  // There is no bookmark, so the camera stays.
        QCOMPARE(camera().eye.x, -0.5);
        QVERIFY(window_->bookmarks().name(4).isEmpty());
        press(Qt::Key_4, Qt::ControlModifier);  // The camera becomes the bookmark.
        QCOMPARE(window_->bookmarks().name(4).left(1), QStringLiteral("4"));
        stand(0.25);
        press(Qt::Key_4, Qt::ControlModifier);
        QTRY_COMPARE(camera().eye.x, -0.5);
        stand(0.25);
        press(Qt::Key_4, Qt::NoModifier);
        QTRY_COMPARE(camera().eye.x, -0.5);
        closeWindow();
        openWindow();
        stand(-0.5);
        press(Qt::Key_3, Qt::ControlModifier);
        QTRY_VERIFY(glm::length(camera().eye - kept.eye) < 1e-9);
        QVERIFY(glm::length(glm::normalize(camera().target - camera().eye) - glm::normalize(kept.target - kept.eye)) <
                1e-9);
        QVERIFY2(window_->viewport().visitor().canGoBack(), "Backspace leads back");
        window_->bookmarks().forgetAll();
        QVERIFY(window_->bookmarks().tour().bookmarks.empty());
    }

    void bookmarksAreAddedVisitedAndDeletedInTheirDialog()
    {
        action("Manage bookmarks…")->trigger();
        auto* dialog = window_->findChild<BookmarksDialog*>();
        auto* list = dialog->findChild<QListWidget*>();
        const auto button = [dialog](const char* text) {
            for (QPushButton* each : dialog->findChildren<QPushButton*>())
                if (each->text().remove('&') == QString::fromUtf8(text)) return each;
            return static_cast<QPushButton*>(nullptr);
        };
        QCOMPARE(list->count(), Bookmarks::most);
        for (const char* text : {"Go there", "Delete", "Save as a tour…", "Delete all"})
            QVERIFY2(!button(text)->isEnabled(), text);
        stand(0.5);
        action("Add bookmark")->trigger();
        stand(-0.5);
        action("Add bookmark")->trigger();
        for (const char* text : {"Go there", "Delete", "Save as a tour…", "Delete all"})
            QVERIFY2(button(text)->isEnabled(), text);
        QVERIFY(list->item(1)->text().startsWith("2 ") && list->item(2)->text().startsWith("3 (not set"));
        list->setCurrentRow(0);
        button("Go there")->click();
        QTRY_COMPARE(camera().eye.x, 0.5);
        button("Delete")->click();
        QVERIFY(window_->bookmarks().name(1).isEmpty() && !window_->bookmarks().name(2).isEmpty());
        QCOMPARE(list->currentRow(), 0);
        list->setCurrentRow(3);
        button("Set to this view")->click();
        QVERIFY(!window_->bookmarks().name(4).isEmpty());
        button("Delete all")->click();
        QVERIFY(!window_->bookmarks().hasSome());
        for (int k = 0; k < Bookmarks::most; ++k) window_->bookmarks().add();
        window_->bookmarks().add();
        QVERIFY(!window_->findChild<MessageStrip*>()->texts().filter("All nine bookmarks").isEmpty());
        window_->bookmarks().forgetAll();
        dialog->close();
    }

    void bookmarksThatCannotBeReadAreLeftAsTheyAre()
    {
        closeWindow();
        const std::filesystem::path file = stateFolder() / "bookmarks.json";
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << "{";
        openWindow();
        press(Qt::Key_1, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(!window_->bookmarks().name(1).isEmpty());
        std::ifstream read(file);
        QCOMPARE(QString::fromStdString({std::istreambuf_iterator<char>(read), {}}), QStringLiteral("{"));
    }

    void aTourIsSavedForTheCommandLine()
    {
        stand(0.5);
        press(Qt::Key_2, Qt::ControlModifier | Qt::AltModifier);
        stand(-0.5);
        press(Qt::Key_1, Qt::ControlModifier | Qt::AltModifier);
        window_->bookmarks().saveAs(at("tour.json"));
        QFile file(at("tour.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const recording::Tour tour = recording::parseTour(file.readAll().toStdString(), "tour.json");
        QCOMPARE(tour.bookmarks.size(), std::size_t{2});
        QCOMPARE(tour.bookmarks[0].camera.eye.x, -0.5);  // Sorted by number.
        QCOMPARE(tour.bookmarks[1].camera.eye.x, 0.5);
    }

    void copiesOfThePictureGoToTheClipboard()
    {
        action("Copy picture")->trigger();
        const QImage copied = QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32);
        QCOMPARE(copied, window_->viewport().pictures().shown().image().convertToFormat(QImage::Format_RGB32));
        window_->choose(1);
        dragRoughness(60);
        settle();
        action("Copy as command line")->trigger();
        const QString line = QGuiApplication::clipboard()->text();
        QCOMPARE(line, commandLineOf(*window_));
        QVERIFY2(line.startsWith("vitrine render hall --size "), qPrintable(line));
        QVERIFY2(
            line.contains(QStringLiteral(" --samples %1 ").arg(window_->viewport().pictures().schedule().samples())),
            qPrintable(line));
        const FrameRequest shown = window_->viewport().pictures().shown().request();
        QVERIFY(line.contains(QStringLiteral("--size %1x%2 ").arg(shown.raster.size.x).arg(shown.raster.size.y)));
        QVERIFY2(line.contains(".roughness=") && line.contains("--eye="), qPrintable(line));
    }

    void longAFilmAlongTheBookmarksIsRecordedBesideTheWindow()
    {
        JobDialog* dialog = openDialog(jobs::RecordPath::bookmarks);
        QVERIFY2(says(*dialog, "Set two bookmarks"), "and there is nothing to record");
        stand(0.5);
        window_->bookmarks().set(1);
        stand(-0.5);
        window_->bookmarks().set(2);
        waitFor(*dialog);
        QVERIFY(!says(*dialog, "Set two bookmarks"));
        QSignalSpy ended(dialog, &JobDialog::exportEnded);
        dialog->setPath(at("film.apng"));
        dialog->startExport();
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY2(ended[0][0].toBool(), qPrintable(dialog->findChild<MessageStrip*>()->texts().join('\n')));
        QVERIFY(QFile::exists(at("film.apng")));
        QVERIFY(QFile::exists(at("film.apng.vitrine-job.json")));
        QVERIFY2(dialog->path() != at("film.apng"), "the next one does not replace it");
        dialog->setPath(at("frames/%02d.png"));
        dialog->startExport();
        QTRY_COMPARE(ended.count(), 2);
        QVERIFY2(ended[1][0].toBool(), qPrintable(dialog->findChild<MessageStrip*>()->texts().join('\n')));
        QCOMPARE(QDir(at("frames")).entryList({"*.png"}, QDir::Files).size(), 5);
        const auto preset = render::embeddedPreset(at("frames/05.png").toStdString());
        QVERIFY(preset && preset->find("-0.5") != std::string::npos);
    }

    void everySettingOfTheTableIsAParameterOfTheDialog()
    {
        JobDialog* dialog = openDialog(jobs::RecordPath::still);
        const auto* panel = dialog->findChild<ParameterPanel*>();
        for (const ParameterInfo& parameter : jobs::recordTable().rows())
            QVERIFY2(panel->row(parameter.name), std::string(parameter.name).c_str());
    }

    void theFilmOfTheDialogIsThatOfItsCommandLine()
    {
        stand(0.5);
        JobDialog* dialog = openDialog(jobs::RecordPath::still);
        dialog->setPath(at("window.apng"));
        const QString line = dialog->commandLine();
        QVERIFY2(line.startsWith("vitrine record hall ") && line.contains(" --path=still "), qPrintable(line));
        QVERIFY2(line.contains(" --eye=0.5,") && line.contains(" --fps=10 ") && line.contains(" --size=16x16 "),
                 qPrintable(line));
        stand(-0.5);
        QVERIFY2(dialog->commandLine().contains(" --eye=-0.5,"), "the scene is that of now");
    }

    void whatCannotBeRecordedIsSaidAndNothingBegins()
    {
        JobDialog* dialog = openDialog(jobs::RecordPath::still);
        dialog->setPath(at("film.avi"));
        dialog->startExport();
        QVERIFY(!dialog->exporting());
        const auto said = [&] { return dialog->findChild<MessageStrip*>()->texts().join('\n'); };
        QVERIFY2(said().contains(".mp4"), qPrintable(said()));
        dialog->setPath(at("missing/film.apng"));
        QSignalSpy ended(dialog, &JobDialog::exportEnded);
        dialog->startExport();
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY(!ended[0][0].toBool());
        QVERIFY2(said().contains("missing"), qPrintable(said()));
    }

    void canceledItLeavesNoFileAndTheWindowAsksBeforeItCloses()
    {
        JobDialog* dialog = openDialog(jobs::RecordPath::still);
        ParameterValues values = dialog->setup().values();
        values.set(jobs::recordTable().seconds, 3600.0);
        dialog->setup().change("Change", values);
        waitFor(*dialog);
        dialog->setPath(at("film.apng"));
        dialog->startExport();
        QTRY_VERIFY(dialog->exporting());
        window_->close();
        QVERIFY2(window_->isVisible(), "a film is being recorded");
        window_->findChild<QMessageBox*>()->reject();
        dialog->reject();
        QVERIFY(!dialog->exporting());
        QVERIFY2(dialog->isVisible(), "canceled, not closed");
        QTest::qWait(200);
        QVERIFY(!QFile::exists(at("film.apng")));
        QCOMPARE(QDir(home_->path()).entryList({"*film*"}, QDir::Files | QDir::Hidden).size(), 0);
    }
};

VITRINE_WINDOW_TEST(RecordWindowTest)
#include "record_window_test.moc"
