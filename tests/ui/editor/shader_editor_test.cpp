// The text of a visitor's shader in the window: typed, checked, shown, saved, and changed by other programs.
#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "exhibits/your_shader/guest_work.h"
#include "exhibits/your_shader/your_shader.h"
#include "render/files/read_file.h"
#include "ui/editor/code_colors.h"
#include "ui/editor/document_file.h"
#include "ui/editor/find_bar.h"
#include "ui/editor/live_text.h"
#include "ui/editor/shader_panel.h"
#include "ui/viewport/file_watch.h"
#include "ui/window/file_opener.h"
#include "ui/window/search_dialog.h"
#include "ui/window/shortcut_sheet.h"
#include "ui/window/window_docks.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>
#include <QUrl>

#include <filesystem>
#include <fstream>
#include <set>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::patience;

namespace {

const std::string ownShader = "// A shader of the test.\n"
                              "uniform float gain; // 0 .. 10, default 2\n"
                              "void main()\n"
                              "{\n"
                              "    gl_FragColor = vec4(gain / 10.0, 0.25, 0.0, 1.0);\n"
                              "}\n";

}  // namespace

class ShaderEditorTest : public test::OpenWindow {
    Q_OBJECT

    static constexpr std::size_t shader = 2;

    std::unique_ptr<Exhibit> anotherExhibit() override { return std::make_unique<guest::YourShader>(); }
    [[nodiscard]] QString path() const { return home_->filePath("own.frag"); }
    [[nodiscard]] std::string onDisk() const { return render::readFile(path().toStdString(), 1 << 20); }
    void write(const std::string& text) const { std::ofstream(path().toStdString()) << text; }
    [[nodiscard]] const ParameterValues& values() { return window_->history().sceneState().values[shader]; }
    [[nodiscard]] const guest::YourShaderTable& table()
    {
        return static_cast<const guest::YourShaderTable&>(values().table());
    }
    [[nodiscard]] std::string written(const char* row)
    {
        return std::get<std::string>(values().row(values().table().find(row).value()));
    }
    [[nodiscard]] double number(const char* row)
    {
        return std::get<double>(values().row(values().table().find(row).value()));
    }
    [[nodiscard]] ShaderPanel& panel() { return window_->docks().shader(); }
    [[nodiscard]] LiveText& live() { return panel().live(); }
    [[nodiscard]] CodeView& view() { return *panel().view(); }
    [[nodiscard]] QWidget* text() { return &view().widget(); }
    [[nodiscard]] QMessageBox* question() { return window_->findChild<QMessageBox*>(); }
    void checked() { QTRY_VERIFY(!live().isChecking()); }
    /// Opens the shader of the test and its text.
    void openShader()
    {
        write(ownShader);
        window_->files().open(path());
        QTRY_VERIFY(values().table().find("gain"));
        window_->docks().showShader();
        QTRY_VERIFY(panel().view() && text()->isVisible());
        text()->setFocus();
        QTRY_COMPARE(view().text(), QString::fromStdString(ownShader));
        checked();
    }
    /// Types in place of the first occurrence of some words after the beginning.
    void typeOver(const char* words, const char* typed)
    {
        view().goTo(1);
        QVERIFY2(view().find(words, true), words);
        QTest::keyClicks(text(), typed);
    }

private slots:
    void initTestCase() { prepare(); }
    void init()
    {
        start();
        QApplication::setActiveWindow(window_.get());  // Under Xvfb there is no window manager.
    }
    void cleanup()
    {
        if (window_) {
            SceneState state = window_->history().sceneState();
            dynamic_cast<const HasDocument&>(gallery_->museum().subject(shader)).dropUnsaved(state.values[shader]);
            window_->history().stack().clear();
            window_->history().settle(state);
        }
        finish();
    }

    void longTheFirstShaderHasItsInputsAtTheFirstVisit()
    {
        window_->visit(shader);
        QCOMPARE(written("file"), std::string("gyroid.frag"));
        for (const char* row : {"uCells", "uWall", "uTurning", "uDust", "steps"})
            QVERIFY2(values().table().find(row), row);
        QVERIFY(window_->panel().row("uCells"));
    }

    void theEditorIsLoadedWhenItIsFirstShown()
    {
        const auto isLoaded = [] {
            QFile maps("/proc/self/maps");
            return maps.open(QIODevice::ReadOnly) && maps.readAll().contains("qscintilla");
        };
        // Other tests of this process may have shown it.
        static bool wasShown = false;
        QVERIFY(!panel().view());
        if (!wasShown) QVERIFY(!isLoaded());
        wasShown = true;
        openShader();
        QVERIFY(isLoaded());
    }

    void anErrorIsShownAtItsLineAndTheLastGoodShaderStays()
    {
        openShader();
        window_->history().set(shader, *values().table().find("gain"), 7.0, 0);
        const auto before = table().work;
        QVERIFY(before);
        typeOver("vec4", "vec5");
        QTRY_VERIFY(!live().findings().empty());
        checked();
        QVERIFY2(view().noteAt(5).contains("vec5"), qPrintable(view().noteAt(5)));
        for (const int line : {1, 2, 3, 4, 6}) QVERIFY2(view().noteAt(line).isEmpty(), qPrintable(view().noteAt(line)));
        QVERIFY2(panel().stateText().startsWith("Line 5: "), qPrintable(panel().stateText()));
        QCOMPARE(table().work, before);
        QCOMPARE(written("document"), std::string());
        QVERIFY(written("draft").find("vec5") != std::string::npos);
        QCOMPARE(number("gain"), 7.0);

        // A corrected text is shown; if it equals the file, it is no edit.
        typeOver("vec5", "vec4");
        QTRY_VERIFY(live().findings().empty() && !live().isChecking());
        QVERIFY(view().noteAt(5).isEmpty());
        QTRY_COMPARE(written("document") + written("draft"), std::string());
        QVERIFY(window_->docks().documentFile().unsaved().isEmpty());

        typeOver("0.25", "0.75");
        QTRY_VERIFY(written("document").find("0.75") != std::string::npos);
        QVERIFY(table().work && table().work->id != before->id);
        QCOMPARE(number("gain"), 7.0);
        QCOMPARE(window_->docks().documentFile().unsaved(), QStringList("own.frag"));
    }

    void undoOfTheWindowLeadsThroughGoodTextsOnly()
    {
        openShader();
        typeOver("0.25", "0.5");
        QTRY_VERIFY(written("document").find("0.5,") != std::string::npos);
        typeOver("0.5,", "0.5");  // A comma is missing.
        QTRY_VERIFY(!written("draft").empty());
        checked();
        typeOver("0.5 ", "0.9, ");
        QTRY_VERIFY(written("document").find("0.9,") != std::string::npos);
        QCOMPARE(written("draft"), std::string());
        window_->history().stack().undo();
        QTRY_VERIFY(view().text().contains("0.5,"));
        window_->history().stack().undo();
        QTRY_COMPARE(view().text(), QString::fromStdString(ownShader));
        checked();
        QVERIFY(live().findings().empty());
        window_->history().stack().redo();
        QTRY_VERIFY(view().text().contains("0.5,"));
        // The text has an undo of its own.
        text()->setFocus();
        const int steps = window_->history().stack().index();
        typeOver("0.5,", "0.125,");
        QTest::keyClick(text(), Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!view().text().contains("0.125,"));
        QCOMPARE(window_->history().stack().index(), steps);
    }

    void ctrlSWritesWhatWasTypedAMomentAgo()
    {
        openShader();
        typeOver("0.25", "0.625");
        QTest::keyClick(text(), Qt::Key_S, Qt::ControlModifier);
        QVERIFY(onDisk().find("0.625") != std::string::npos);
        QTRY_VERIFY(window_->docks().documentFile().unsaved().isEmpty());
        QTRY_VERIFY(table().work && table().work->shader->files.front().text.find("0.625") != std::string::npos);
        // A text with errors can be saved, too.
        typeOver("vec4", "vec5");
        QTest::keyClick(text(), Qt::Key_S, Qt::ControlModifier);
        QVERIFY(onDisk().find("vec5") != std::string::npos);
        QTRY_VERIFY(view().noteAt(5).contains("vec5"));
    }

    void aTextWithErrorsIsKeptWhenTheWindowCloses()
    {
        openShader();
        typeOver("vec4", "vec5");
        QCOMPARE(window_->docks().documentFile().unsaved(), QStringList("own.frag"));
        window_->close();
        QTRY_VERIFY(question());
        question()->findChild<QPushButton*>("closeUnsaved")->click();
        QTRY_VERIFY(!window_->isVisible());
        window_.reset();
        openWindow();
        window_->visit(shader);
        QTRY_VERIFY(written("draft").find("vec5") != std::string::npos);
        window_->docks().showShader();
        QTRY_VERIFY(panel().view() && view().text().contains("vec5"));
        QTRY_VERIFY(view().noteAt(5).contains("vec5"));
        QCOMPARE(onDisk(), ownShader);
    }

    void whatAnotherProgramSavesIsShown()
    {
        openShader();
        std::string changed = ownShader;
        changed.replace(changed.find("0.25"), 4, "0.875");
        write(changed);
        QTRY_COMPARE(view().text(), QString::fromStdString(changed));
        QTRY_VERIFY(table().work && table().work->shader->files.front().text == changed);
        QVERIFY(!question());
        // With changes here that are not saved, the visitor decides.
        typeOver("0.875", "0.5");
        QTRY_VERIFY(written("document").find("0.5,") != std::string::npos);
        write(ownShader);
        QTRY_VERIFY(question());
        QVERIFY(view().text().contains("0.5,"));
        question()->findChild<QPushButton*>("takeTheirs")->click();
        QTRY_COMPARE(view().text(), QString::fromStdString(ownShader));
        window_->history().stack().undo();
        QTRY_VERIFY(view().text().contains("0.5,"));
    }

    void longTheSystemNotifiesOfFilesThatAreSavedOrReplaced()
    {
        openShader();
        static_assert(FileWatch::pause <= 100, "a notification is followed at once");
        static_assert(FileWatch::usualInterval <= 1000, "without notifications, files are read within a second");
        // This watch would look by itself after an hour only.
        FileWatch watch(gallery_->museum(), window_->history(), 3'600'000);
        watch.renew();
        QSignalSpy changed(&watch, &FileWatch::changed);
        write(ownShader + "// saved\n");
        QTRY_COMPARE(changed.count(), 1);
        // Many programs write another file and give it the name.
        for (const char* line : {"// replaced\n", "// replaced again\n"}) {
            const auto before = changed.count();
            const QString beside = home_->filePath("own.frag~");
            std::ofstream(beside.toStdString()) << ownShader << line;
            std::filesystem::rename(beside.toStdString(), path().toStdString());
            QTRY_VERIFY(changed.count() > before);
        }
        // Other files in the folder are no reason to read anything at once.
        QTest::qWait(10 * FileWatch::pause);
        const auto before = changed.count();
        std::ofstream(home_->filePath("other.txt").toStdString()) << "other";
        QTest::qWait(10 * FileWatch::pause);
        QCOMPARE(changed.count(), before);
    }

    void keysBelongToTheTextWhileItHasTheFocus()
    {
        openShader();
        view().goTo(1);
        QTest::keyClicks(text(), "// ?[1 w");
        QVERIFY(view().text().startsWith("// ?[1 w"));
        QVERIFY(!window_->findChild<ShortcutSheet*>());
        QTest::keyClick(text(), Qt::Key_F, Qt::ControlModifier);
        auto* bar = panel().findChild<FindBar*>();
        QTRY_VERIFY(bar->isVisible() && bar->words().hasFocus());
        QVERIFY(!window_->findChild<SearchDialog*>());
        bar->words().clear();
        QTest::keyClicks(&bar->words(), "GAIN");
        QTest::keyClick(&bar->words(), Qt::Key_Return);
        QCOMPARE(view().selected(), QString("gain"));
        QCOMPARE(view().line(), 2);
        QTest::keyClick(&bar->words(), Qt::Key_Return);
        QCOMPARE(view().line(), 5);
        QTest::keyClick(&bar->words(), Qt::Key_Return, Qt::ShiftModifier);
        QCOMPARE(view().line(), 2);
        QTest::keyClick(&bar->words(), Qt::Key_Escape);
        QTRY_VERIFY(!bar->isVisible() && text()->hasFocus());
        // Everywhere else, the same keys open the search of the window.
        window_->viewport().setFocus();
        QTest::keyClick(&window_->viewport(), Qt::Key_F, Qt::ControlModifier);
        QTRY_VERIFY(window_->findChild<SearchDialog*>());
        window_->findChild<SearchDialog*>()->close();
    }

    void templatesOfEveryFormAreGoodShaders()
    {
        openShader();
        typeOver("0.25", "0.5");
        QTRY_VERIFY(!written("document").empty());
        QToolButton* button = nullptr;
        for (QToolButton* each : panel().findChildren<QToolButton*>())
            if (each->text() == "New") button = each;
        QVERIFY(button && button->menu());
        QCOMPARE(button->menu()->actions().size(), 3);
        std::set<guest::Form> forms;
        for (QAction* each : button->menu()->actions()) {
            each->trigger();
            QTRY_VERIFY(table().work && table().work->path.parent_path().filename() == "templates" &&
                        view().text() == QString::fromStdString(table().work->shader->files.front().text));
            forms.insert(table().work->shader->form);
            checked();
            QVERIFY(live().findings().empty());
            QVERIFY(view().text().contains("rings"));
        }
        QCOMPARE(forms.size(), std::size_t{3});
        for (int i = 0; i < 3; ++i) window_->history().stack().undo();
        QTRY_VERIFY(view().text().contains("0.5,"));
    }

    void theShadersOfAllPassesAreShownAndCannotBeEdited()
    {
        openShader();
        QComboBox& choice = panel().choice();
        QTRY_VERIFY(choice.findText("screen, fragment shader") > 0);
        choice.setCurrentIndex(choice.findText("screen, fragment shader"));
        emit choice.activated(choice.currentIndex());
        QVERIFY(view().text().startsWith("#version 450"));
        const QString before = view().text();
        QTest::keyClicks(text(), "x");
        QCOMPARE(view().text(), before);
        QCOMPARE(written("document") + written("draft"), std::string());
        // The program that is made of the visitor's text is listed, too.
        bool isGenerated = false;
        for (int i = 1; i < choice.count(); ++i) {
            choice.setCurrentIndex(i);
            emit choice.activated(i);
            isGenerated = isGenerated || view().text().contains("GUEST_ROUNDS");
        }
        QVERIFY(isGenerated);
        choice.setCurrentIndex(0);
        emit choice.activated(0);
        QCOMPARE(view().text(), QString::fromStdString(ownShader));
    }

    void theFileIsOpenedInTheEditorOfTheDesktop()
    {
        openShader();
        QDesktopServices::setUrlHandler("file", this, "noteUrl");
        typeOver("0.25", "0.5");
        for (QToolButton* each : panel().findChildren<QToolButton*>())
            if (each->text() == "Open in my editor") each->click();
        QDesktopServices::unsetUrlHandler("file");
        QCOMPARE(opened_.toLocalFile(), path());
        QVERIFY(onDisk().find("0.5,") != std::string::npos);
    }

    void colorsAreReadableInEveryTheme()
    {
        for (const Theme& each : {darkTheme(), lightTheme(), highContrastTheme(true), highContrastTheme(false)}) {
            const CodeColors colors = codeColors(each);
            const double least = each.highContrast ? 7 : 4.5;  // WCAG 2.2, 1.4.6 and 1.4.3.
            for (const QColor& ground : {colors.background, colors.currentLine})
                for (const QColor& color : {colors.text, colors.keyword, colors.type, colors.function, colors.number,
                                            colors.comment, colors.directive})
                    QVERIFY2(contrastOf(color, ground) >= least, qPrintable(QStringLiteral("%1 on %2: %3")
                                                                                .arg(color.name(), ground.name())
                                                                                .arg(contrastOf(color, ground))));
            for (const QColor& color : {colors.marginText, colors.error, colors.remark})
                QVERIFY2(contrastOf(color, colors.margin) >= least, qPrintable(color.name()));
        }
    }

public slots:
    void noteUrl(const QUrl& url) { opened_ = url; }

private:
    QUrl opened_;
};

VITRINE_WINDOW_TEST(ShaderEditorTest)

#include "shader_editor_test.moc"
