// Dialog of a job on real renderers, tested with sprites: it writes the same bytes as the command, and its texts are
// right.

#include "exhibits/exhibits.h"
#include "exhibits/jobs.h"
#include "exhibits/jobs/sprite/sprite_table.h"
#include "render/version.h"
#include "tests/render/scene/gltf_builder.h"
#include "tests/ui/test_home.h"
#include "tests/ui/ui_main.h"
#include "ui/export/export_dialog.h"
#include "ui/jobs/job_dialog.h"
#include "ui/jobs/picture_preview.h"
#include "ui/jobs/sprite_preview.h"
#include "ui/kit/export_bar.h"
#include "ui/kit/theme.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/viewport/museum_renderers.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>

#include <clocale>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <set>
#include <stdexcept>

using namespace vitrine;
using namespace vitrine::ui;

class JobDialogTest : public QObject {
    Q_OBJECT

    std::unique_ptr<Museum> museum_;
    std::unique_ptr<MuseumRenderers> renderers_;
    std::unique_ptr<RenderThread> thread_;
    std::unique_ptr<QTemporaryDir> home_;
    QPointer<JobDialog> dialog_;

    /// `subject`: the exhibit to show, for jobs that can show any.
    void openDialog(std::string_view name = "sprite", std::string_view subject = {})
    {
        const jobs::Job& job = *jobs::findJob(name);
        const std::string_view shown = job.needs().subject.empty() ? subject : job.needs().subject;
        const jobs::JobScene scene{museum_.get(), museum_->initialSceneState(), museum_->find(shown).value(), {}};
        dialog_ = new JobDialog(
            job, [scene] { return scene; }, *renderers_, *thread_, nullptr);
        dialog_->show();
        QVERIFY(QTest::qWaitForWindowExposed(dialog_, vitrine::test::patience));
    }
    void closeDialog()
    {
        if (dialog_ && dialog_->exporting()) dialog_->reject();  // After a failure: closing cancels the export first.
        if (dialog_) dialog_->close();
        QTRY_VERIFY(!dialog_);
    }
    void set(const std::map<std::string, Value>& rows)
    {
        ParameterValues values = dialog_->setup().values();
        for (const auto& [row, value] : rows) values.setParameter(values.table().find(row).value(), value);
        dialog_->setup().change("Change", values);
    }
    [[nodiscard]] SpritePreview& preview() { return *static_cast<SpritePreview*>(dialog_->preview()); }
    [[nodiscard]] QComboBox& animations()
    {
        return *dialog_->findChild<ParameterPanel*>()->row("animation")->findChild<QComboBox*>();
    }
    [[nodiscard]] QStringList offered()
    {
        QStringList all;
        for (int i = 0; i < animations().count(); ++i) all << animations().itemText(i);
        return all;
    }
    /// Returns the lines about the result.
    [[nodiscard]] QString facts()
    {
        auto* label = dialog_->findChild<QLabel*>("facts");
        return label ? label->text() : QString();
    }
    /// Returns the number that follows these words in the facts; -1: there is none.
    [[nodiscard]] double numberAfter(const char* words)
    {
        const QString text = facts();
        const qsizetype at = text.indexOf(QLatin1String(words));
        if (at < 0) return -1;
        return text.mid(at + static_cast<qsizetype>(std::strlen(words)) + 1).section(QLatin1Char(' '), 0, 0).toDouble();
    }
    [[nodiscard]] QStringList said() { return dialog_->findChild<MessageStrip*>()->texts(); }
    [[nodiscard]] QString at(const char* name) const { return home_->filePath(QString::fromUtf8(name)); }
    QPushButton* button(const char* text)
    {
        for (QPushButton* each : dialog_->findChildren<QPushButton*>())
            if (each->text() == QString::fromUtf8(text)) return each;
        return nullptr;
    }
    static QByteArray contentOf(const QString& path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void exportTo(const QString& path)
    {
        QTRY_VERIFY(dialog_->settled());
        QSignalSpy ended(dialog_, &JobDialog::exportEnded);
        dialog_->setPath(path);
        dialog_->startExport();
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY2(ended[0][0].toBool(), qPrintable(said().join('\n')));
    }
    /// Returns the path of a triangle with two animations: one moves it to the side, one up.
    [[nodiscard]] QString movedTriangle() const
    {
        vitrine::test::GltfBuilder b;
        const int node = b.node({{"mesh", b.triangle()}});
        b.json["animations"] = render::Json::array();
        for (const bool up : {false, true}) {
            const float x = up ? 0.0F : 2.0F, y = up ? 3.0F : 0.0F;
            b.json["animations"].push_back(
                {{"name", up ? "jump" : "walk"},
                 {"samplers", render::Json::array({{{"input", b.floats({0, 1}, "SCALAR")},
                                                    {"output", b.floats({0, 0, 0, x, y, 0}, "VEC3")}}})},
                 {"channels", render::Json::array(
                                  {{{"sampler", 0U},
                                    {"target", {{"node", static_cast<unsigned>(node)}, {"path", "translation"}}}}})}});
        }
        const QString path = at("moved.glb");
        std::ofstream(path.toStdString(), std::ios::binary) << b.glb();
        return path;
    }
    /// Runs the program, and compares every file of a sheet with that of the dialog.
    void compareWithProgram(const QStringList& words, const QStringList& endings)
    {
        QDir().mkpath(at("window"));
        QDir().mkpath(at("program"));
        exportTo(at("window/hero.png"));
        QProcess program;
        program.start(QStringLiteral(VITRINE_PROGRAM),
                      QStringList{"sprite"} + words + QStringList{"--out", at("program/hero.png")});
        QVERIFY(program.waitForFinished(vitrine::test::patience));
        QVERIFY2(program.exitCode() == 0, program.readAllStandardError().constData());
        for (const QString& ending : endings) {
            const QByteArray mine = contentOf(at("window/hero") + ending);
            QVERIFY2(!mine.isEmpty(), qPrintable(ending));
            QVERIFY2(mine == contentOf(at("program/hero") + ending), qPrintable(ending));
        }
        QCOMPARE(QDir(at("window")).entryList(QDir::Files).size(), endings.size());
    }
    void recordAndCompareWithForecasts(const std::vector<const char*>& names)
    {
        closeDialog();
        openDialog("record", "sdf_morph");
        set({{"seconds", 2.0}, {"framesPerSecond", 4.0}, {"width", 160.0}, {"height", 90.0}, {"samples", 1.0}});
        QTRY_VERIFY_WITH_TIMEOUT(dialog_->settled(), vitrine::test::patience);
        const QImage picture = static_cast<const PicturePreview*>(dialog_->preview())->picture();
        QCOMPARE(picture.size(), QSize(2 * 160 + 2, 3 * 90 + 4));
        QVERIFY2(picture.copy(0, 0, 160, 90) != picture.copy(162, 92, 160, 90), "the camera turns");
        QVERIFY2(!facts().contains("Uncompressed"), qPrintable(facts()));
        for (const char* name : names) {
            dialog_->setPath(at(name));
            QTRY_VERIFY_WITH_TIMEOUT(dialog_->settled(), vitrine::test::patience);
            const double kilobytes = numberAfter("File about");
            exportTo(at(name));
            const double written = static_cast<double>(QFileInfo(at(name)).size()) / 1000;
            const QString both = QStringLiteral("%1: %2 kB forecast, %3 written").arg(name).arg(kilobytes).arg(written);
            qInfo("%s", qPrintable(both));
            QVERIFY2(kilobytes > written / 2 && kilobytes < written * 2, qPrintable(both));
        }
    }

private slots:
    void initTestCase()
    {
        std::setlocale(LC_NUMERIC, "C");
        // The program writes its commit into its files; the test program does not know the commit.
        QProcess program;
        program.start(QStringLiteral(VITRINE_PROGRAM), {"--version"});
        QVERIFY(program.waitForFinished(vitrine::test::patience));
        const QByteArray version = program.readAllStandardOutput().trimmed();
        render::setProgramCommit(version.contains('+') ? version.mid(version.indexOf('+') + 1).toStdString() : "");
        applyTheme(*qApp, darkTheme());
        museum_ = std::make_unique<Museum>(allExhibits());
        renderers_ = std::make_unique<MuseumRenderers>(*museum_);
        thread_ = std::make_unique<RenderThread>(*renderers_);
    }
    void init()
    {
        home_ = vitrine::test::newHome(vitrine::test::ProgramCaches::shared);
        openDialog();
    }
    void cleanup() { closeDialog(); }
    void cleanupTestCase() { thread_.reset(); }

    void longTheSheetIsThatOfTheCommandLineToTheByte()
    {
        set({{"directions", 3.0},
             {"frames", 2.0},
             {"width", 31.0},
             {"height", 40.0},
             {"palette", 2.0},
             {"dither", 1.0},
             {"trimmed", 1.0},
             {"pivot", 2.0}});
        compareWithProgram({"--directions", "3", "--frames", "2", "--size", "31x40", "--palette", "Game Boy",
                            "--dither", "ordered", "--trim", "--pivot", "bottom"},
                           {".png", "_normal.png", "_depth.png", ".json", ".png.vitrine-job.json"});
        // Control: other settings give other bytes.
        const QByteArray before = contentOf(at("window/hero.png"));
        set({{"dither", 0.0}});
        exportTo(at("window/plain.png"));
        QVERIFY(contentOf(at("window/plain.png")) != before);
    }

    void soItIsForAnAnimationOfAFile()
    {
        const QString file = movedTriangle();
        set({{"model", file.toStdString()},
             {"directions", 2.0},
             {"frames", 3.0},
             {"width", 24.0},
             {"height", 48.0},
             {"dither", 2.0},
             {"colors", 5.0},
             {"depth", 0.0},
             {"normals", 0.0},
             {"framesPerSecond", 0.0}});
        QTRY_COMPARE(offered(), (QStringList{"walk", "jump"}));
        set({{"animation", std::string("jump")}});
        QTRY_VERIFY(dialog_->settled());
        compareWithProgram({file, "--animation", "jump", "--directions", "2", "--frames", "3", "--size", "24x48",
                            "--dither", "error diffusion", "--colors", "5", "--fps", "auto", "--no-normals",
                            "--no-depth"},
                           {".png", ".json", ".png.vitrine-job.json"});
    }

    void theCopiedCommandWritesTheSameFiles()
    {
        set({{"model", movedTriangle().toStdString()},
             {"animation", std::string("jump")},
             {"directions", 2.0},
             {"frames", 3.0},
             {"width", 24.0},
             {"description", 0.0}});
        QTRY_VERIFY(dialog_->settled());
        QDir().mkpath(at("window"));
        exportTo(at("window/hero.png"));
        const QByteArray sheet = contentOf(at("window/hero.png"));
        const QByteArray settings = contentOf(at("window/hero.png.vitrine-job.json"));
        QVERIFY(!sheet.isEmpty() && !settings.isEmpty());
        QDir(at("window")).removeRecursively();
        QDir().mkpath(at("window"));
        dialog_->setPath(at("window/hero.png"));
        QString line = dialog_->commandLine();
        QVERIFY2(line.startsWith("vitrine sprite "), qPrintable(line));
        QProcess shell;
        shell.start("sh", {"-c", QStringLiteral("'" VITRINE_PROGRAM "'") + line.mid(7)});
        QVERIFY(shell.waitForFinished(vitrine::test::patience));
        QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
        QVERIFY(contentOf(at("window/hero.png")) == sheet);
        QVERIFY(contentOf(at("window/hero.png.vitrine-job.json")) == settings);
    }

    void settingsBesideAnExportAreLoadedInOneStep()
    {
        set({{"directions", 3.0}, {"frames", 2.0}, {"width", 16.0}, {"palette", 4.0}});
        QTRY_VERIFY(dialog_->settled());
        const ParameterValues before = dialog_->setup().values();
        exportTo(at("a.png"));
        set({{"directions", 5.0}, {"palette", 0.0}, {"trimmed", 1.0}});
        const ParameterValues after = dialog_->setup().values();
        dialog_->load(at("a.png"));
        QVERIFY(dialog_->setup().values() == before);
        dialog_->setup().history().stack().undo();
        QVERIFY(dialog_->setup().values() == after);
        dialog_->load(at("none.png"));
        QVERIFY2(said().join(' ').contains("none.png.vitrine-job.json"), qPrintable(said().join(' ')));
        QVERIFY(dialog_->setup().values() == after);
    }

    void longAnimationsAreOfferedWhereTheFileHasSome()
    {
        QTRY_VERIFY(dialog_->settled());
        auto* row = dialog_->findChild<ParameterPanel*>()->row("animation");
        QVERIFY(row->idle());
        const auto warned = [this] {
            bool found = false;
            for (const QLabel* label : dialog_->findChildren<QLabel*>())
                found = found || label->text().contains("All frames of each direction are equal");
            return found;
        };
        QVERIFY(!warned());
        vitrine::test::GltfBuilder b;
        b.node({{"mesh", b.triangle()}});
        std::ofstream(at("still.glb").toStdString(), std::ios::binary) << b.glb();
        set({{"model", at("still.glb").toStdString()}, {"directions", 2.0}, {"frames", 3.0}});
        QTRY_VERIFY(dialog_->settled() && warned());
        QVERIFY(!row->idle());
        QVERIFY(offered().isEmpty());
        set({{"model", movedTriangle().toStdString()}});
        QTRY_COMPARE(offered(), (QStringList{"walk", "jump"}));
        // The animations only move the whole object. This motion is removed from the frames, so all frames are equal
        // until it is kept.
        QTRY_VERIFY(dialog_->settled() && warned());
        set({{"motion", static_cast<double>(jobs::SpriteMotion::kept)}});
        QTRY_VERIFY(dialog_->settled() && !warned());
        QCOMPARE(animations().currentText(), QString());
        animations().setCurrentIndex(1);
        emit animations().activated(1);
        QCOMPARE(dialog_->setup().values()[jobs::spriteTable().animation], "jump");
        // Another file has other animations.
        const std::size_t model = jobs::spriteTable().model.row;
        dialog_->setup().history().set(0, model, at("still.glb").toStdString(), newGesture());
        QCOMPARE(dialog_->setup().values()[jobs::spriteTable().animation], "");
    }

    void thePreviewTurns()
    {
        set({{"directions", 3.0}, {"frames", 2.0}, {"width", 20.0}, {"height", 24.0}});
        QTRY_VERIFY(dialog_->settled() && preview().shown()->cells.size() == 6);
        std::set<int> seen;
        QTRY_VERIFY((seen.insert(preview().cell()), seen.size() == 6));
        QCOMPARE(preview().shown()->picture.size(), QSize(40, 72));
        const int before = qGray(preview().shown()->picture.pixel(10, 12));
        set({{"palette", 9.0}});
        QTRY_VERIFY(dialog_->settled());
        std::set<QRgb> colors;
        const QImage& picture = preview().shown()->picture;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (qAlpha(picture.pixel(x, y)) > 0) colors.insert(picture.pixel(x, y));
        QCOMPARE(colors.size(), std::size_t(2));
        QVERIFY(before > 0);
    }

    void longAFileThatCannotBeReadIsSaidOnceAndKeepsTheRest()
    {
        std::ofstream(at("bad.glb").toStdString()) << "no model";
        set({{"model", at("bad.glb").toStdString()}, {"directions", 5.0}});
        QTRY_COMPARE(said().size(), 1);
        QTRY_VERIFY(dialog_->settled());
        QVERIFY2(said().front().contains("bad.glb"), qPrintable(said().front()));
        QVERIFY(!button("Export")->isEnabled());
        QVERIFY(!preview().shown());
        set({{"colors", 7.0}});
        QTRY_VERIFY(dialog_->settled());
        QCOMPARE(said().size(), 1);
        set({{"model", std::string()}});
        QTRY_VERIFY(dialog_->settled() && preview().shown());
        QVERIFY(said().isEmpty());
        QVERIFY(button("Export")->isEnabled());
        QCOMPARE(dialog_->setup().values()[jobs::spriteTable().directions], 5);
    }

    void longCancelLeavesNoFile()
    {
        set({{"directions", 16.0}, {"frames", 64.0}});
        QTRY_VERIFY(dialog_->settled());
        QSignalSpy ended(dialog_, &JobDialog::exportEnded);
        dialog_->setPath(at("many.png"));
        button("Export")->click();
        QVERIFY(dialog_->exporting());
        QTRY_VERIFY(dialog_->findChild<ExportBar*>()->status() != "Starting");  // It is on its way.
        QVERIFY(ended.isEmpty());
        button("Cancel")->click();
        QTRY_COMPARE(ended.count(), 1);
        QVERIFY(!ended[0][0].toBool());
        QVERIFY(QDir(home_->path()).entryList({"many*"}, QDir::Files).isEmpty());
        QVERIFY(dialog_->isVisible());
        QVERIFY(button("Export")->isEnabled());
    }

    void aRecordingIsNamedAfterWhatItShowsAndASheetAfterItsJob()
    {
        QCOMPARE(QFileInfo(dialog_->path()).fileName(), QStringLiteral("sprite.png"));
        closeDialog();
        openDialog("record", "fur");
        QCOMPARE(QFileInfo(dialog_->path()).fileName(), QStringLiteral("fur.mp4"));
    }

    /// Without a preview, the settings use the whole dialog.
    void noPartOfTheDialogIsEmpty()
    {
        closeDialog();
        openDialog("proof", "noise");
        QVERIFY(!dialog_->preview());
        QVERIFY(dialog_->findChild<ParameterPanel*>()->width() > dialog_->width() * 9 / 10);
        QVERIFY(dialog_->findChild<ParameterPanel*>()->height() > dialog_->height() / 2);
    }

    /// A recording as small as its draft has about the forecast size.
    void longARecordingShowsFramesOfItsPathAndForecastsItsFile() { recordAndCompareWithForecasts({"a.gif"}); }
    void longRecordingsOfOtherFormatsAreAsForecast() { recordAndCompareWithForecasts({"a.mp4", "a.apng"}); }

    /// A sphere: a coarse mesh says how many triangles, bytes and seconds a fine one will take.
    void longAMeshIsSeenAndForecastBeforeItIsMade()
    {
        closeDialog();
        openDialog("mesh", "sdf_scenes");
        std::ofstream(at("ball.json").toStdString())
            << R"({"format": "vitrine-scene", "version": 1, "camera": {"position": [0, 0, 4], "target": [0, 0, 0]},
                   "root": {"kind": "sphere", "radius": 0.5}})";
        set({{"scene", at("ball.json").toStdString()}, {"cell", 0.004}});
        QTRY_VERIFY(dialog_->settled());
        QVERIFY2(said().isEmpty(), qPrintable(said().join('\n')));
        // The ball fills the height of its picture, but for a small margin, and is round.
        const QImage picture = static_cast<PicturePreview*>(dialog_->preview())->picture();
        QVERIFY(!picture.isNull());
        double filled = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) filled += qAlpha(picture.pixel(x, y)) == 255 ? 1 : 0;
        const double height = 0.92 * picture.height();
        QVERIFY2(std::abs(filled / (std::numbers::pi / 4 * height * height) - 1) < 0.02, qPrintable(facts()));
        QCOMPARE(qAlpha(picture.pixel(0, 0)), 0);
        const double triangles = numberAfter("Triangles about"), megabytes = numberAfter("File about");
        QVERIFY2(facts().contains("It will take "), qPrintable(facts()));
        exportTo(at("ball.stl"));
        // Binary STL: 84 bytes and 50 for each triangle.
        const double bytes = static_cast<double>(contentOf(at("ball.stl")).size()), made = (bytes - 84) / 50;
        QVERIFY2(made > 100000, qPrintable(QString::number(made)));
        // The bound is the roughness of counting the cells of a surface of 64 cells across.
        QVERIFY2(std::abs(triangles / made - 1) < 0.05, qPrintable(QString("%1 of %2").arg(triangles).arg(made)));
        dialog_->setPath(at("again.stl"));
        QTRY_VERIFY(dialog_->settled() && facts().contains("File about"));
        QVERIFY2(std::abs(numberAfter("File about") * 1e6 / bytes - 1) < 0.05, qPrintable(facts()));
        QVERIFY(numberAfter("File about") != megabytes);  // The first estimate was for another format.
        set({{"triangles", 500.0}});
        QTRY_VERIFY(dialog_->settled());
        QCOMPARE(numberAfter("Triangles about"), 500.0);
    }

    /// The scene that is shown at first stands on a plane without an end.
    void longASceneWithoutAnEndIsCutAroundItsView()
    {
        closeDialog();
        openDialog("mesh", "sdf_scenes");
        QTRY_VERIFY(dialog_->settled());
        QVERIFY2(said().isEmpty(), qPrintable(said().join('\n')));
        QVERIFY2(facts().contains("The scene has no end"), qPrintable(facts()));
        QVERIFY(!static_cast<PicturePreview*>(dialog_->preview())->picture().isNull());
        QVERIFY(button("Export")->isEnabled());
        QVERIFY2(dialog_->commandLine().contains("--low"), qPrintable(dialog_->commandLine()));
    }

    void whatNoSheetCanHoldIsRefusedWithItsReason()
    {
        set({{"width", 9000.0}, {"directions", 2.0}});
        QTRY_VERIFY(dialog_->settled());
        QVERIFY(!button("Export")->isEnabled());
        bool found = false;
        for (const QLabel* label : dialog_->findChildren<QLabel*>()) found = found || label->text().contains("16384");
        QVERIFY(found);
        set({{"width", 16.0}});
        QTRY_VERIFY(button("Export")->isEnabled());
        dialog_->setPath(at("sheet.tif"));
        dialog_->startExport();
        QVERIFY(said().join(' ').contains(".png"));
        QVERIFY(!QFile::exists(at("sheet.tif")));
    }

    void whatIsSetComesBack()
    {
        const QString file = movedTriangle();
        set({{"model", file.toStdString()}, {"directions", 4.0}, {"palette", 3.0}, {"trimmed", 1.0}});
        set({{"animation", std::string("jump")}});
        QTRY_VERIFY(dialog_->settled());
        const ParameterValues before = dialog_->setup().values();
        closeDialog();
        openDialog();
        QTRY_VERIFY(dialog_->settled());
        QVERIFY(dialog_->setup().values() == before);
        QCOMPARE(animations().currentText(), QString("jump"));
        QCOMPARE(dialog_->setup().history().stack().count(), 0);
    }

    void anExportWhosePageCannotBeMadeIsClosed()
    {
        ExportDialog dialog({{"broken", "Broken", [](QWidget*) -> QDialog* { throw std::runtime_error("no page"); },
                              [](const QDialog&) { return false; }}},
                            nullptr);
        bool isThrown = false;
        try {
            dialog.findChild<QListWidget*>()->setCurrentRow(0);
        } catch (const std::runtime_error&) {
            isThrown = true;
        }
        QVERIFY(isThrown);
        dialog.show();
        QCOMPARE(dialog.shownKind(), QString("broken"));
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QVERIFY(!dialog.isVisible());
    }
};

VITRINE_WINDOW_TEST(JobDialogTest)

#include "job_dialog_test.moc"
