#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/message_strip.h"
#include "ui/kit/name_dialog.h"
#include "ui/kit/tile_delegate.h"
#include "ui/presets/preset_controller.h"
#include "ui/window/exhibit_list.h"

#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTabBar>

using namespace vitrine;
using namespace vitrine::ui;

/// Presets in use: saving, loading, naming and recognizing them.
class PresetControllerTest : public test::OpenWindow {
    Q_OBJECT

    void load(const char* name)
    {
        window_->presetController().load(rowsNamed(name).front()->data(Qt::UserRole).toString());
    }
    [[nodiscard]] QString marked() { return presets()->currentItem() ? presets()->currentItem()->text() : QString(); }
    [[nodiscard]] QString lineOfMarked() { return presets()->currentItem()->data(TileDelegate::secondLine).toString(); }
    void showTab(int tab)
    {
        for (QTabBar* bar : window_->findChildren<QTabBar*>())
            if (bar->accessibleName() == "Parameters of") bar->setCurrentIndex(tab);
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longWhatThePanelShowsIsSavedAndTheDialogSaysWhoseItIs()
    {
        window_->choose(1);
        showTab(1);
        const auto exposure = [this] {
            const ParameterValues& hall = window_->history().sceneState().hall();
            return std::get<double>(hall.row(*hall.table().find("exposure")));
        };
        drag("exposure", 90);
        QVERIFY(exposure() != 0);
        QCOMPARE(roughness(1), 0.25);
        action("Save preset as…")->trigger();
        auto* ask = window_->findChild<NameDialog*>();
        QVERIFY(ask);
        // The heading is complete inside of the dialog, which does not cover the middle of the picture.
        auto* heading = ask->findChild<QLabel*>();
        QCOMPARE(heading->text(), QString("Save preset of The hall as"));
        QVERIFY(heading->height() >= heading->heightForWidth(heading->width()));
        const QRect picture(window_->viewport().mapToGlobal(QPoint(0, 0)), window_->viewport().size());
        QVERIFY(!ask->geometry().intersects(picture.adjusted(picture.width() / 8, 0, -picture.width() / 8, 0)));
        QCOMPARE(ask->name(), QString("The hall"));
        ask->accept();
        QTRY_COMPARE(rowsNamed("The hall").size(), 1);
        QVERIFY(QFile::exists(home_->filePath("vitrine/presets/hall/the-hall.json")));
        showTab(0);
        QCOMPARE(rowsNamed("The hall").size(), 0);
        showTab(1);
        const double saved = exposure();
        action("Reset all parameters")->trigger();
        load("The hall");
        QCOMPARE(exposure(), saved);
        QCOMPARE(roughness(1), 0.25);
    }

    void noTwoPresetsHaveOneName()
    {
        window_->choose(1);
        window_->presetController().saveUnder("Dull");
        window_->presetController().saveUnder("Dull");
        QCOMPARE(rowsNamed("Dull").size(), 1);
        QCOMPARE(rowsNamed("Dull 2").size(), 1);
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("Dull 2"));
        window_->presetController().duplicate();
        window_->presetController().duplicate();
        QCOMPARE(rowsNamed("Dull 2 copy").size(), 1);
        presets()->item(presets()->row(rowsNamed("Dull 2").front()))->setText("dull");
        QTRY_COMPARE(rowsNamed("dull 2").size(), 1);
    }

    void undoTakesTheMarkBackToo()
    {
        window_->choose(1);
        window_->presetController().saveUnder("Smooth");
        dragRoughness(60);
        QCOMPARE(marked(), QString("Smooth"));
        QTRY_COMPARE(lineOfMarked(), QString("Changed since"));
        window_->presetController().saveUnder("Dull");
        QCOMPARE(marked(), QString("Dull"));
        QCOMPARE(lineOfMarked(), QString("Yours"));
        load("Smooth");
        QCOMPARE(marked(), QString("Smooth"));
        window_->history().stack().undo();
        QTRY_COMPARE(marked(), QString("Dull"));
        QCOMPARE(lineOfMarked(), QString("Yours"));
        window_->history().stack().undo();
        QTRY_COMPARE(marked(), QString("Smooth"));
        QCOMPARE(lineOfMarked(), QString("Yours"));
        window_->history().stack().redo();
        QTRY_COMPARE(marked(), QString("Dull"));
        window_->history().stack().redo();
        QTRY_COMPARE(marked(), QString("Smooth"));
        // A new step after an undo does not restore the mark.
        window_->history().stack().undo();
        dragRoughness(30);
        QTRY_COMPARE(marked(), QString("Dull"));
        QTRY_COMPARE(lineOfMarked(), QString("Changed since"));
    }

    void savingWritesToThePresetThatIsMarked()
    {
        window_->choose(1);
        window_->presetController().saveUnder("Smooth");
        dragRoughness(60);
        window_->presetController().saveUnder("Dull");
        const double dull = roughness();
        load("Smooth");
        window_->history().stack().undo();  // Back to "Dull".
        dragRoughness(90);
        window_->presetController().save();
        const double saved = roughness();
        QVERIFY(saved != dull);
        load("Smooth");
        QCOMPARE(roughness(), 0.25);
        load("Dull");
        QCOMPARE(roughness(), saved);
    }

    void theEditorOfANameCoversTheOldOne()
    {
        window_->choose(1);
        window_->presetController().saveUnder("Dull");
        window_->presetController().rename();
        auto* editor = presets()->findChild<QLineEdit*>();
        QVERIFY(editor && editor->isVisible());
        QVERIFY(editor->autoFillBackground());
        const QRect row = presets()->visualItemRect(rowsNamed("Dull").front());
        QVERIFY(editor->geometry().left() >= row.left() + 12 + TileDelegate::picture.width());
        QVERIFY(editor->height() >= row.height() - 8);
        QCOMPARE(editor->palette().color(QPalette::Base).alpha(), 255);
    }

    void wordsFindSomeOfManyPresets()
    {
        window_->choose(1);
        QLineEdit* words = nullptr;
        for (QLineEdit* line : window_->findChildren<QLineEdit*>())
            if (line->accessibleName() == "Find a preset") words = line;
        QVERIFY(words);
        const int shipped = presets()->count();
        for (int i = 0; i < 8; ++i) {
            dragRoughness(10 + 10 * i);
            window_->presetController().saveUnder(i == 6 ? QString("Velvet rope") : QStringLiteral("Stone %1").arg(i));
        }
        QTRY_COMPARE(presets()->count(), shipped + 8);
        QTRY_VERIFY(words->isVisible());
        const auto found = [this] {
            QStringList names;
            for (int i = 0; i < presets()->count(); ++i)
                if (!presets()->item(i)->isHidden()) names << presets()->item(i)->text();
            return names;
        };
        QCOMPARE(found().size(), shipped + 8);
        words->setFocus();
        QTest::keyClicks(words, "ROPE vel");
        QCOMPARE(found(), QStringList{"Velvet rope"});
        const double last = roughness();
        QTest::keyClick(words, Qt::Key_Return);
        QTRY_VERIFY(roughness() != last);
        QCOMPARE(marked(), QString("Velvet rope"));
        QTest::keyClicks(words, "xyz");
        QVERIFY(found().isEmpty());
        QTest::keyClick(words, Qt::Key_Escape);
        QCOMPARE(found().size(), shipped + 8);
        QTest::keyClicks(words, "yours");
        QCOMPARE(found().size(), 8);
    }

    void longAnImportedPresetGetsAPicture()
    {
        window_->choose(1);
        window_->presetController().saveUnder("Dull");
        const QString exported = home_->filePath("friend.json");
        QVERIFY(QFile::copy(home_->filePath("vitrine/presets/sdf_morph/dull.json"), exported));
        window_->visit(1);
        QTRY_COMPARE(window_->viewport().visitor().mode(), CameraControl::Mode::orbit);
        window_->presetController().importFile();
        auto* dialog = window_->findChild<QFileDialog*>();
        QVERIFY(dialog);
        emit dialog->fileSelected(exported);
        delete dialog;
        QTRY_COMPARE(rowsNamed("Dull 2").size(), 1);
        QTRY_VERIFY(!rowsNamed("Dull 2").front()->icon().isNull());
    }
};

VITRINE_UI_TEST(PresetControllerTest)

#include "preset_controller_test.moc"
