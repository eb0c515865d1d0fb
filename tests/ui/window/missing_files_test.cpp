#include "tests/ui/ui_main.h"

#include "exhibits/exhibits.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/picture/picture_table.h"
#include "render/files/assets.h"
#include "render/image/image_io.h"
#include "render/plan/frame_plan.h"
#include "tests/ui/open_museum.h"
#include "tests/ui/painted_gallery.h"
#include "tests/ui/window/broken_files.h"
#include "ui/compare/compare_controller.h"
#include "ui/export/export_dialog.h"
#include "ui/export/export_presets.h"
#include "ui/export/picture_export.h"
#include "ui/jobs/export_again.h"
#include "ui/jobs/job_dialog.h"
#include "ui/jobs/job_draft.h"
#include "ui/jobs/picture_preview.h"
#include "ui/kit/inline_dialog.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/name_dialog.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/print/print_dialog.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"
#include "ui/window/window_dialogs.h"

#include <QDesktopServices>
#include <QDir>
#include <QDropEvent>
#include <QImage>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QUrl>

#include <map>
#include <memory>
#include <stdexcept>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

/// Renderers that draw nothing, for tests of dialogs over the real museum.
class BlankRenderers final : public Renderers {
public:
    void open() override {}
    void close() override {}
    render::FrameReport draw(const SceneState&, const FrameRequest&, const IsCanceled&) override { return {}; }
    [[nodiscard]] QImage screenImage(const QSize& screen) override { return blank(screen); }
    [[nodiscard]] QImage drawRegion(const SceneState&, const FrameRequest&, const PictureRegion& region, int,
                                    const IsCanceled&) override
    {
        return blank({region.size.x, region.size.y});
    }
    [[nodiscard]] render::Image shownPicture() override { return {}; }
    void timeSteps(bool) override {}
    bool reloadChangedShaders() override { return false; }
    [[nodiscard]] std::vector<render::gl::ShaderProblem> problems() const override { return {}; }
    [[nodiscard]] PictureJob makePicture(const SceneState&, const PictureRequest&) override { return {}; }
    void nextPicture(PictureJob&, const SceneState&, const PictureRequest&) override {}
    [[nodiscard]] StudyJob makeStudy(const study::StudyRequest&) override { return {}; }
    [[nodiscard]] std::unique_ptr<render::RenderBackend> makeBackend(bool) override
    {
        return std::make_unique<test::BlankBackend>();
    }

private:
    [[nodiscard]] static QImage blank(const QSize& size)
    {
        QImage image(size, QImage::Format_RGBX8888);
        image.fill(Qt::gray);
        return image;
    }
};

}  // namespace

/// The window over the real museum with unreadable files, which it reports once.
class MissingFilesTest : public vitrine::test::OpenMuseum {
    Q_OBJECT

    QStringList unreadable_;  // Unreadable files of the last picture.
    std::size_t fur_ = 0;

    [[nodiscard]] QString path(const QString& name) const { return home_->filePath(name); }
    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile::remove(path(name));
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    /// Converts apostrophes to quotes.
    static QByteArray json(const QByteArray& text) { return test::withQuotes(text); }
    QStringList writeBrokenFiles() const { return test::writeBrokenFiles(home_->path()); }

    void openWindow() { openWindowOver(nullptr); }
    /// Opens a window whose picture is gray, for tests of dialogs alone.
    void openBlankWindow() { openWindowOver(std::make_unique<BlankRenderers>()); }
    void openWindowOver(std::unique_ptr<Renderers> renderers)
    {
        makeWindow({.scale = 0.25}, std::move(renderers));  // Messages are tested, not pixels.
        connect(&window_->viewport().pictures(), &ViewportPictures::drawn, this,
                [this](const render::FrameReport& report) {
                    unreadable_.clear();
                    for (const render::CulledPass& skipped : report.skipped)
                        if (!skipped.unreadable.empty()) unreadable_ << QString::fromStdString(skipped.unreadable);
                });
        showWindow({1000, 560});
        drawAnother();
    }
    /// Checks that the window still draws.
    void drawAnother()
    {
        window_->viewport().scene().change();
        QTRY_VERIFY(window_->viewport().pictures().schedule().current());
    }
    [[nodiscard]] QStringList said() const { return window_->findChild<MessageStrip*>()->texts(); }
    void dismiss()
    {
        window_->findChild<MessageStrip*>()->dismissAll();
        QTRY_VERIFY(said().isEmpty());
    }
    void drop(const QString& file) const
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window_.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(window_.get(), &event);
    }
    void type(const char* row, const QString& text)
    {
        auto* line = window_->panel().row(row)->findChild<QLineEdit*>();
        QVERIFY(line);
        line->setText(text);
        emit line->editingFinished();
    }
    [[nodiscard]] std::string value(std::size_t exhibit, const char* row) const
    {
        const ParameterValues& values = window_->history().sceneState().values[exhibit];
        return std::get<std::string>(values.row(*values.table().find(row)));
    }
    /// Opens the export dialog and returns its list of kinds.
    [[nodiscard]] QListWidget& exportKinds()
    {
        window_->dialogs().openJob(*jobs::findJob("render"));
        for (QListWidget* list : window_->findChild<ExportDialog*>()->findChildren<QListWidget*>())
            if (list->accessibleName() == "Kind of export") return *list;
        throw std::logic_error("the export dialog has no list of kinds");
    }
    static QPushButton* buttonOf(const QWidget& parent, const QString& text)
    {
        for (QPushButton* each : parent.findChildren<QPushButton*>())
            if (each->text() == text && each->isVisible()) return each;
        return nullptr;
    }
    static JobDialog* pageOf(const ExportDialog& dialog, std::string_view job)
    {
        for (JobDialog* page : dialog.findChildren<JobDialog*>())
            if (page->job().name() == job) return page;
        throw std::logic_error("the export dialog has no such page");
    }
    /// Returns the settings of the shown page.
    static ParameterValues settingsOf(const ExportDialog& dialog)
    {
        for (JobDialog* page : dialog.findChildren<JobDialog*>())
            if (page->isVisible()) return page->setup().values();
        return dialog.findChild<PrintDialog*>()->values();
    }
    static void changeSettings(const ExportDialog& dialog, const ParameterValues& values)
    {
        for (JobDialog* page : dialog.findChildren<JobDialog*>())
            if (page->isVisible()) return page->setup().change("Change", values);
        dialog.findChild<PrintDialog*>()->setValues(values);
    }
    /// Returns the values with another value of the first number, or of the first choice where there is no number.
    static ParameterValues withAnotherNumber(ParameterValues values)
    {
        for (std::size_t i = 0; i < values.rows().size(); ++i) {
            const ParameterInfo& row = values.rows()[i];
            if (!row.isNumeric()) continue;
            const bool isHigh = std::get<double>(values.row(i)) == row.range.softHigh;
            values.setParameter(i, nearestLegal(row, isHigh ? row.range.softLow : row.range.softHigh).value());
            return values;
        }
        for (std::size_t i = 0; i < values.rows().size(); ++i)
            if (values.rows()[i].kind == Kind::choice) {
                values.setParameter(i, 1.0);
                return values;
            }
        return values;
    }
    void writeSession(const QByteArray& exhibit, const QByteArray& row, const QString& file,
                      const render::Camera& camera)
    {
        QDir().mkpath(path("vitrine"));
        const auto three = [](const glm::dvec3& v) {
            return QStringLiteral("[%1,%2,%3]").arg(v.x).arg(v.y).arg(v.z).toUtf8();
        };
        write("vitrine/session.json", json("{'format':'vitrine-exhibition','version':1,'app':'0.1.0','name':'S','"
                                           "values':{'hall.supersamples':1,'" +
                                           exhibit + "." + row + "':'" + file.toUtf8() + "'},'camera':{'eye':" +
                                           three(camera.eye) + ",'target':" + three(camera.target) + ",'fov':0.9}}"));
    }

private slots:
    void initTestCase()
    {
        prepare();
        museum_ = std::make_unique<Museum>(allExhibits());
        fur_ = museum_->find("fur").value();
    }
    void init() { makeHome(); }
    void cleanup() { closeWindow(); }

    void longASessionThatNamesAMissingFileOpensAndDrawsItWhenItComesBack_data()
    {
        QTest::addColumn<QByteArray>("exhibit");
        QTest::addColumn<QByteArray>("row");
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("label");
        QTest::newRow("panorama") << QByteArray("hall") << QByteArray("environment") << "gone.jpg"
                                  << "Environment of The hall";
        QTest::newRow("model") << QByteArray("hall") << QByteArray("model") << "gone.glb"
                               << "Model of The hall";
        QTest::newRow("ring") << QByteArray("fur") << QByteArray("ringModel") << "gone.glb"
                              << "Ring model of Fur with Physics";
        QTest::newRow("print") << QByteArray("lenticular") << QByteArray("frontPrint") << "gone.jpg"
                               << "Front print of Lenticular Card";
    }
    void longASessionThatNamesAMissingFileOpensAndDrawsItWhenItComesBack()
    {
        QFETCH(QByteArray, exhibit);
        QFETCH(QByteArray, row);
        QFETCH(QString, file);
        QFETCH(QString, label);
        const std::size_t index = museum_->find(exhibit.toStdString()).value();
        const SceneState initial = museum_->initialSceneState();
        writeSession(exhibit, row, path(file),
                     index == 0 ? initial.camera : museum_->bestView(index, initial.values[index]));
        openWindow();
        QTRY_COMPARE(unreadable_.size(), 1);
        QCOMPARE(said().size(), 1);
        QVERIFY2(said().front().startsWith(label + ": ") && said().front().contains(path(file)),
                 qPrintable(said().front()));
        QCOMPARE(value(index, row.constData()), path(file).toStdString());
        drawAnother();
        QCOMPARE(said().size(), 1);
        // Without input, the window notices it by itself.
        if (file.endsWith("glb")) {
            write(file, test::goodModel());
        } else {
            QImage picture(64, 32, QImage::Format_RGB32);
            picture.fill(Qt::green);
            picture.save(path(file));
        }
        QTRY_VERIFY(unreadable_.isEmpty());
        QTRY_VERIFY2(said().isEmpty(), qPrintable(said().join(" | ")));  // The message has been removed.
        QCOMPARE(value(index, row.constData()), path(file).toStdString());
    }

    void longBrokenFilesThatAreDroppedChangeNothingAndSayWhyOnce()
    {
        const QStringList broken = writeBrokenFiles();
        openWindow();
        const SceneState before = window_->history().sceneState();
        for (const QString& file : broken) {
            drop(file);
            QTRY_VERIFY(!said().isEmpty());
            drawAnother();
            QVERIFY2(said().size() == 1, qPrintable(file + ": " + said().join(" | ")));
            QVERIFY2(said().front().contains(QFileInfo(file).fileName()), qPrintable(said().front()));
            QVERIFY2(window_->history().sceneState().values == before.values, qPrintable(file));
            dismiss();
        }
    }

    void longBrokenFilesThatAreTypedStayInTheFieldAndAreSaidOnce()
    {
        const QStringList broken = writeBrokenFiles();
        openWindow();
        window_->choose(0);
        for (const QString& file : broken) {
            const char* row = file.contains(".gl") ? "model" : "environment";
            type(row, file);
            drawAnother();
            drawAnother();
            QVERIFY2(said().size() == 1, qPrintable(file + ": " + said().join(" | ")));
            QVERIFY2(said().front().contains(QFileInfo(file).fileName()), qPrintable(said().front()));
            QCOMPARE(value(0, row), file.toStdString());
            type(row, QString());
            drawAnother();
            dismiss();
        }
        window_->visit(fur_);
        window_->viewport().visitor().jumpTo(museum_->bestView(fur_, window_->history().sceneState().values[fur_]));
        drawAnother();
        type("ringModel", path("noise.glb"));
        drawAnother();
        QVERIFY2(said().size() == 1 && said().front().startsWith("Ring model of Fur with Physics: "),
                 qPrintable(said().join(" | ")));
    }

    void longAPhotographIsNoSkyAndAPrintOpensItsDialog()
    {
        openWindow();
        QImage photo(400, 300, QImage::Format_RGB32);
        photo.fill(Qt::darkCyan);
        photo.save(path("photo.jpg"));
        const SceneState before = window_->history().sceneState();
        drop(path("photo.jpg"));
        QTRY_COMPARE(said().filter("photo.jpg").size(), 1);
        const QString notice = said().filter("photo.jpg").front();
        QVERIFY2(notice.contains("400 × 300") && notice.contains("“Environment” in the parameters of the hall"),
                 qPrintable(notice));
        QVERIFY(window_->history().sceneState().values == before.values);
        QImage panorama(400, 200, QImage::Format_RGB32);
        panorama.fill(Qt::darkCyan);
        panorama.save(path("sky.png"));
        drop(path("sky.png"));
        QTRY_COMPARE(value(0, "environment"), path("sky.png").toStdString());

        window_->dialogs().openPrint();
        auto* dialog = window_->findChild<PrintDialog*>();
        panorama.save(path("view1.png"));
        panorama.save(path("view2.png"));
        dialog->openFiles({path("view1.png"), path("view2.png")});
        const auto set = [&](const char* row, double value) {
            ParameterValues values = dialog->values();
            values.setParameter(*values.table().find(row), value);
            dialog->setValues(values);
        };
        set("width", 0.02);
        set("height", 0.01);
        dialog->setPath(path("card.tif"));
        QTRY_VERIFY(dialog->settled());
        const ParameterValues printed = dialog->values();
        dialog->startExport();
        QTRY_VERIFY(!dialog->exporting());
        for (const char* file : {"card.tif", "card.tif.json"}) {
            set("width", 0.03);
            dialog->close();
            QTRY_VERIFY(!window_->findChild<PrintDialog*>());
            drop(path(file));
            dialog = window_->findChild<PrintDialog*>();
            QVERIFY2(dialog, file);
            QVERIFY(dialog->values() == printed);
            QCOMPARE(value(0, "environment"), path("sky.png").toStdString());
        }
    }

    void longClosingDuringAnExportAsksAndCanWaitForIt()
    {
        openWindow();
        const auto start = [&](const char* name, int samples) {
            ExportRequest exportRequest;
            exportRequest.path = path(name).toStdString();
            exportRequest.size = {64, 36};
            exportRequest.samples = samples;
            (new PictureExport(*window_, exportRequest, window_.get()))->start();
        };
        const auto answer = [&](const char* button) {
            window_->close();
            QVERIFY(window_->isVisible());
            auto* box = window_->findChild<QMessageBox*>();
            QVERIFY(box);
            QVERIFY2(box->text().contains(".png"), qPrintable(box->text()));
            box->findChild<QPushButton*>(button)->click();
        };
        start("long.png", 4096);
        window_->close();
        QVERIFY(window_->isVisible());
        window_->findChild<QMessageBox*>()->reject();
        QTRY_VERIFY(!window_->findChild<QMessageBox*>());
        for (PictureExport* work : window_->findChildren<PictureExport*>()) {
            QVERIFY(work->running());
            work->cancel();
        }
        start("short.png", 2);
        answer("closeWhenDone");
        QTRY_VERIFY(!window_->isVisible());
        QVERIFY(QFile::exists(path("short.png")));
        window_.reset();
        openWindow();
        start("given-up.png", 4096);
        answer("closeAnyway");
        QTRY_VERIFY(!window_->isVisible());
        window_.reset();
        QVERIFY(!QFile::exists(path("given-up.png")));
    }

    void longExportPictureTakesANewNameAfterEachExportAndEscapeCancelsFirst()
    {
        openWindow();
        const jobs::Job& job = *jobs::findJob("render");
        window_->dialogs().openJob(job);
        auto* all = window_->findChild<ExportDialog*>();
        auto* dialog = all->findChild<JobDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        const auto set = [&](int samples) {
            ParameterValues values = dialog->setup().values();
            values.set(jobs::pictureTable().width, 64);
            values.set(jobs::pictureTable().height, 36);
            values.set(jobs::pictureTable().samples, samples);
            dialog->setup().change("Change", values);
            QTRY_VERIFY_WITH_TIMEOUT(dialog->settled(), test::patience);
        };
        const auto button = [&](const char* text) {
            for (QPushButton* each : dialog->findChildren<QPushButton*>())
                if (each->text() == text) return each;
            return static_cast<QPushButton*>(nullptr);
        };
        set(1);
        const auto* preview = static_cast<const PicturePreview*>(dialog->preview());
        QCOMPARE(preview->picture().size(), QSize(64, 36));
        dialog->setPath(path("look.png"));
        button("Export")->click();
        QTRY_VERIFY(QFile::exists(path("look.png")));
        QTRY_COMPARE(dialog->path(), path("look-2.png"));
        QVERIFY(!QFile::exists(path("look.png.vitrine-job.json")));  // The settings are in the picture.
        const QByteArray first = contentOf(path("look.png"));
        dialog->setPath(path("look.png"));
        button("Export")->click();
        auto* question = dialog->findChild<QMessageBox*>();
        QVERIFY(question);
        question->findChild<QPushButton*>("keepBoth")->click();
        QTRY_VERIFY(QFile::exists(path("look-2.png")));
        QCOMPARE(contentOf(path("look.png")), first);
        QTRY_COMPARE(dialog->path(), path("look-3.png"));
        // Twice more without the dialog, with the same settings: the second one waits.
        window_->again().run();
        window_->again().run();
        QCOMPARE(window_->again().unfinished(), QStringList({"look-3.png", "look-4.png"}));
        QTRY_VERIFY(
            window_->centralWidget()->findChild<MessageStrip*>()->texts().join(' ').contains(path("look-4.png")));
        QCOMPARE(QImage(path("look-3.png")).size(), QSize(64, 36));
        dialog->setPath(path("look-5.jpg"));
        QTest::keyClick(dialog, Qt::Key_Return, Qt::ControlModifier);
        QTRY_COMPARE(dialog->path(), path("look-6.jpg"));
        QCOMPARE(QImageReader(path("look-5.jpg")).format(), QByteArray("jpeg"));
        qputenv("DBUS_SESSION_BUS_ADDRESS",
                "unix:path=/nonexistent");  // There is no file manager, so the folder is opened.
        QDesktopServices::setUrlHandler("file", this, "noteOpened");
        QToolButton* folder = nullptr;
        for (QToolButton* each : dialog->findChild<MessageStrip*>()->findChildren<QToolButton*>())
            if (each->text() == "Show in folder") folder = each;
        QVERIFY(folder);
        folder->click();
        QTRY_COMPARE(opened_, QList<QUrl>{QUrl::fromLocalFile(QFileInfo(path("look-5.jpg")).absolutePath())});
        QDesktopServices::unsetUrlHandler("file");
        dialog->setPath(path("look-7.gif"));
        button("Export")->click();
        QTRY_VERIFY(dialog->findChild<MessageStrip*>()->texts().join(' ').contains(".png"));
        dialog->setPath(path("look-7.png"));
        // Esc first cancels the export, then closes the dialog.
        set(4096);
        button("Export")->click();
        QTRY_VERIFY(dialog->exporting());
        QTest::keyClick(dialog, Qt::Key_Escape);
        QVERIFY(dialog->isVisible() && !dialog->exporting());
        QTest::keyClick(dialog, Qt::Key_Escape);
        QTRY_VERIFY(!window_->findChild<JobDialog*>());
        QVERIFY(!all->isVisible());
        QVERIFY(!QFile::exists(path("look-7.png")));
    }

    void longAnExportGoesOnWhileAnotherKindIsShownAndTheDialogIsHidden()
    {
        openWindow();
        window_->dialogs().openJob(*jobs::findJob("render"));
        auto* all = window_->findChild<ExportDialog*>();
        auto* picture = all->findChild<JobDialog*>();
        ParameterValues values = picture->setup().values();
        values.set(jobs::pictureTable().width, 64);
        values.set(jobs::pictureTable().height, 36);
        values.set(jobs::pictureTable().samples, 200);
        picture->setup().change("Change", values);
        QTRY_VERIFY_WITH_TIMEOUT(picture->settled(), test::patience);
        picture->setPath(path("slow.png"));
        picture->startExport();
        QTRY_VERIFY(picture->exporting());
        window_->dialogs().openPrint();
        QCOMPARE(window_->findChildren<ExportDialog*>().size(), 1);
        QCOMPARE(all->shownKind(), QString("print"));
        QVERIFY(all->findChild<PrintDialog*>()->isVisible());
        QVERIFY(picture->exporting());
        all->close();
        QTRY_VERIFY(!all->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("slow.png")), test::patience);
        QTRY_VERIFY(!picture->exporting());
        window_->dialogs().openJob(*jobs::findJob("sprite"));
        QVERIFY(all->isVisible());
        QCOMPARE(all->shownKind(), QString("sprite"));
        all->close();
        QTRY_VERIFY(!window_->findChild<JobDialog*>());
        // It can be opened again at once.
        window_->dialogs().openPrint();
        QVERIFY(all->isVisible() && all->findChild<PrintDialog*>()->isVisible());
        all->close();
    }

    /// Also of an exhibit that is not visited, and in the hall.
    void everyKindOfExportHasItsPage()
    {
        openBlankWindow();
        QListWidget& kinds = exportKinds();
        const auto* dialog = window_->findChild<ExportDialog*>();
        QStringList titles;
        for (const std::size_t visited : {std::size_t(hallIndex), fur_}) {
            window_->visit(visited);
            for (int i = 0; i < kinds.count(); ++i) {
                kinds.setCurrentRow(i);
                QCOMPARE(dialog->shownKind(), kinds.item(i)->data(Qt::UserRole).toString());
                QVERIFY(settingsOf(*dialog).rows().size() > 0);
                if (visited == fur_) titles << kinds.item(i)->text();
            }
        }
        for (const char* title :
             {"Picture", "Recording", "Lenticular print", "Sprites", "Mesh", "Quilt", "Shader", "Table", "Comparison"})
            QVERIFY2(titles.contains(title), qPrintable(titles.join(", ")));
    }

    void longAMeshIsThatOfTheSceneOnShowWithItsValues()
    {
        write("ball.json", json("{'format':'vitrine-scene','version':1,'parameters':{'size':{'value':0.2,'unit':'m',"
                                "'range':[0.1,0.4],'help':'Radius.'}},'root':{'kind':'sphere','radius':'size'}}"));
        openBlankWindow();
        const std::size_t scenes = museum_->find("sdf_scenes").value();
        window_->visit(scenes);
        drop(path("ball.json"));
        const auto values = [&]() -> const ParameterValues& { return window_->history().sceneState().values[scenes]; };
        QTRY_VERIFY(values().table().find("size").has_value());
        window_->history().set(scenes, *values().table().find("size"), 0.3, newGesture());
        QListWidget& kinds = exportKinds();
        kinds.setCurrentItem(kinds.findItems("Mesh", Qt::MatchExactly).front());
        const auto* dialog = window_->findChild<ExportDialog*>();
        JobDialog* page = pageOf(*dialog, "mesh");
        ParameterValues settings = page->setup().values();
        settings.setParameter(settings.table().find("cell").value(), 0.05);
        page->setup().change("Change", settings);
        QTRY_VERIFY_WITH_TIMEOUT(page->settled() && buttonOf(*page, "Export")->isEnabled(), test::patience);
        page->setPath(path("window.stl"));
        buttonOf(*page, "Export")->click();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("window.stl")) && !page->exporting(), test::patience);
        QProcess program;
        program.start(QStringLiteral(VITRINE_PROGRAM),
                      {"mesh", path("ball.json"), "--cell", "5cm", "--set", "size=0.3", "--out", path("program.stl")});
        QVERIFY(program.waitForFinished(vitrine::test::patience));
        QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
        QVERIFY(contentOf(path("window.stl")).size() > 1000);
        QCOMPARE(contentOf(path("window.stl")), contentOf(path("program.stl")));
        QVERIFY2(page->commandLine().contains(path("ball.json")), qPrintable(page->commandLine()));
        // Edits that are not saved are in no file.
        const auto document = values().table().find("document").value();
        window_->history().set(scenes, document,
                               json("{'format':'vitrine-scene','version':1,'root':{'kind':'sphere'}}").toStdString(),
                               newGesture());
        QTRY_VERIFY_WITH_TIMEOUT(page->settled() && !buttonOf(*page, "Export")->isEnabled(), test::patience);
        bool found = false;
        for (const QLabel* label : page->findChildren<QLabel*>())
            found = found || label->text().contains("save it first");
        QVERIFY(found);
    }

    void longAComparisonWithTheSettingsBIsAFolderWithAPage()
    {
        openWindow();
        window_->visit(fur_);
        QListWidget& kinds = exportKinds();
        const auto* dialog = window_->findChild<ExportDialog*>();
        const QRect place = kinds.visualItemRect(kinds.findItems("Comparison", Qt::MatchExactly).front());
        QTest::mouseClick(kinds.viewport(), Qt::LeftButton, {}, place.center());
        QTRY_COMPARE(dialog->shownKind(), QString("comparison"));
        JobDialog* page = pageOf(*dialog, "comparison");
        const auto facts = [&] { return page->findChild<QLabel*>("facts")->text(); };
        QTRY_VERIFY2(facts().contains("Choose B in the menu Compare"), qPrintable(facts()));
        QVERIFY(!buttonOf(*page, "Export")->isEnabled());
        for (QAction* action : window_->findChildren<QAction*>())
            if (action->text().remove('&') == "Hold the current settings as B") action->trigger();
        QVERIFY(window_->comparison().other().isSet());
        const auto length = museum_->subject(fur_).parameters().find("shellCount").value();
        window_->history().set(fur_, length, 20.0, newGesture());
        ParameterValues values = page->setup().values();
        for (const auto& [name, value] :
             std::map<const char*, double>{{"width", 64}, {"height", 36}, {"samples", 1}, {"runs", 1}})
            values.setParameter(*values.table().find(name), value);
        page->setup().change("Change", values);
        QTRY_VERIFY_WITH_TIMEOUT(page->settled() && facts().contains("Parameters that differ 1"), test::patience);
        const QImage& preview = static_cast<const PicturePreview*>(page->preview())->picture();
        QCOMPARE(preview.size(), QSize(2 * 64 + 2, 36));
        page->setPath(path("both"));
        QTest::mouseClick(buttonOf(*page, "Export"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("both/index.html")) && !page->exporting(), test::patience);
        const QByteArray numbers = contentOf(path("both/comparison.json"));
        QVERIFY2(numbers.contains("\"shellCount\""), numbers.left(2000));
        QVERIFY2(numbers.contains("\"renderer\""), "it says what drew");
        QVERIFY(contentOf(path("both/index.html")).contains("1 parameter differs"));
        QCOMPARE(QImage(path("both/pictures/b.png")).size(), QSize(64, 36));
        QVERIFY(QFile::exists(path("both.vitrine-job.json")));
        QCOMPARE(page->path(), path("both-2"));
        // A folder of something else is left alone, which is said before anything is drawn.
        QDir(home_->path()).mkdir("own");
        write("own/notes.txt", "mine");
        page->setPath(path("own"));
        QTest::mouseClick(buttonOf(*page, "Export"), Qt::LeftButton);
        page->findChild<QMessageBox*>()->findChild<QPushButton*>("replace")->click();
        QTRY_VERIFY(page->findChild<MessageStrip*>()->texts().join(' ').contains("something else than a comparison"));
        QCOMPARE(QDir(path("own")).entryList(QDir::Files), QStringList("notes.txt"));
    }

    void longOnlyTheShownPageOfExportsDrawsAndAnotherCatchesUp()
    {
        openWindow();
        window_->visit(fur_);
        QListWidget& kinds = exportKinds();
        auto* dialog = window_->findChild<ExportDialog*>();
        JobDialog* picture = pageOf(*dialog, "render");
        QTRY_VERIFY_WITH_TIMEOUT(picture->settled(), test::patience);
        kinds.setCurrentItem(kinds.findItems("Quilt", Qt::MatchExactly).front());
        JobDialog* quilt = pageOf(*dialog, "quilt");
        ParameterValues values = quilt->setup().values();
        for (const char* name : {"columns", "rows"}) values.setParameter(*values.table().find(name), 2.0);
        quilt->setup().change("Change", values);
        QTRY_VERIFY_WITH_TIMEOUT(quilt->settled() && picture->settled(), test::patience);
        QSignalSpy pictures(picture->findChild<JobDraft*>(), &JobDraft::shown);
        QSignalSpy quilts(quilt->findChild<JobDraft*>(), &JobDraft::shown);
        const auto count = museum_->subject(fur_).parameters().find("shellCount").value();
        window_->history().set(fur_, count, 20.0, newGesture());
        QTRY_COMPARE_WITH_TIMEOUT(quilts.count(), 1, test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(picture->settled(), test::patience);
        QCOMPARE(pictures.count(), 0);
        kinds.setCurrentItem(kinds.findItems("Picture", Qt::MatchExactly).front());
        QTRY_COMPARE_WITH_TIMEOUT(pictures.count(), 1, test::patience);
        QTRY_VERIFY_WITH_TIMEOUT(picture->settled(), test::patience);
        // Nothing has changed since.
        kinds.setCurrentItem(kinds.findItems("Quilt", Qt::MatchExactly).front());
        QTRY_VERIFY_WITH_TIMEOUT(quilt->settled(), test::patience);
        QCOMPARE(quilts.count(), 1);
        QCOMPARE(pictures.count(), 1);
    }

    void longSettingsOfEveryKindOfExportAreSavedUnderANameAndChosen()
    {
        openBlankWindow();
        QListWidget& kinds = exportKinds();
        auto* dialog = window_->findChild<ExportDialog*>();
        auto* presets = dialog->findChild<ExportPresetList*>();
        auto* list = presets->findChild<QListWidget*>();
        const auto choose = [&](int row) {
            list->setCurrentRow(row);
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
        };
        for (int i = 0; i < kinds.count(); ++i) {
            kinds.setCurrentRow(i);
            const QByteArray kind = dialog->shownKind().toUtf8();
            QVERIFY2(presets->names().isEmpty(), kind);
            buttonOf(*presets, "Reset")->click();
            const ParameterValues initial = settingsOf(*dialog), other = withAnotherNumber(initial);
            QVERIFY2(!(initial == other), kind);
            changeSettings(*dialog, other);
            buttonOf(*presets, "Save…")->click();
            auto* asks = presets->findChild<NameDialog*>();
            QVERIFY(asks);
            asks->findChild<QLineEdit*>()->setText("My 1/2 %");
            buttonOf(*asks, "Save")->click();
            QTRY_VERIFY(!presets->findChild<NameDialog*>());
            QCOMPARE(presets->names(), QStringList("My 1/2 %"));
            buttonOf(*presets, "Reset")->click();
            QVERIFY2(settingsOf(*dialog) == initial, kind);
            choose(0);
            QVERIFY2(settingsOf(*dialog) == other, kind);
            buttonOf(*presets, "Delete")->click();
            buttonOf(*presets->findChild<InlineDialog*>(), "Delete")->click();
            QTRY_VERIFY(!presets->findChild<InlineDialog*>());
            QVERIFY2(presets->names().isEmpty(), kind);
        }
    }

    void aBrokenPresetOfAnExportIsNamedWithItsKeyAndChangesNothing()
    {
        openBlankWindow();
        const jobs::Job& job = *jobs::findJob("record");
        const ExportPresets files(job);
        ParameterValues values = job.parameters().initial();
        values.setParameter(values.table().find("seconds").value(), 2.0);
        for (const char* name : {"Cut", "Unknown", "Whole"}) files.save(name, values);
        const auto fileOf = [&](const char* name) { return QString::fromStdString(files.file(name).string()); };
        const QByteArray whole = contentOf(fileOf("Whole"));
        const auto replace = [&](const char* name, const QByteArray& text) {
            QFile file(fileOf(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        replace("Cut", whole.left(whole.size() / 2));
        replace("Unknown", QByteArray(whole).replace("\"seconds\"", "\"secnds\""));
        window_->dialogs().openJob(job);
        auto* dialog = window_->findChild<ExportDialog*>();
        auto* presets = dialog->findChild<ExportPresetList*>();
        auto* list = presets->findChild<QListWidget*>();
        const auto problems = [&] {
            QStringList all;
            for (const MessageStrip* strip : dialog->findChildren<MessageStrip*>()) all += strip->texts();
            return all;
        };
        const auto choose = [&](int row) {
            list->setCurrentRow(row);
            QTest::keyClick(list, Qt::Key_Return);
        };
        QCOMPARE(presets->names(), QStringList({"Cut", "Unknown", "Whole"}));
        choose(0);
        QCOMPARE(problems().size(), 1);
        QVERIFY2(problems().front().contains("Cut.vitrine-job.json"), qPrintable(problems().front()));
        choose(1);
        QCOMPARE(problems().size(), 1);
        QVERIFY2(problems().front().contains("Unknown.vitrine-job.json") && problems().front().contains("secnds"),
                 qPrintable(problems().front()));
        QVERIFY(settingsOf(*dialog) == job.parameters().initial());
        choose(2);
        QVERIFY(problems().isEmpty());
        QVERIFY(settingsOf(*dialog) == values);
    }

public slots:
    void noteOpened(const QUrl& url) { opened_ << url; }

private:
    QList<QUrl> opened_;
};

VITRINE_WINDOW_TEST(MissingFilesTest)

#include "missing_files_test.moc"
