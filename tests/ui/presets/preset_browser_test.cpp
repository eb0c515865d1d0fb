#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/message_strip.h"
#include "ui/presets/preset_controller.h"
#include "ui/presets/preset_preview.h"
#include "ui/presets/tag_chips.h"
#include "ui/presets/tags_dialog.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>

using namespace vitrine;
using namespace vitrine::ui;

/// Presets in use: tagging, searching by tags, and the large preview.
class PresetBrowserTest : public test::OpenWindow {
    Q_OBJECT

    [[nodiscard]] QStringList found()
    {
        QStringList names;
        for (int i = 0; i < presets()->count(); ++i)
            if (!presets()->item(i)->isHidden()) names << presets()->item(i)->text();
        return names;
    }
    [[nodiscard]] QLineEdit* words()
    {
        for (QLineEdit* line : window_->findChildren<QLineEdit*>())
            if (line->accessibleName() == "Find a preset") return line;
        return nullptr;
    }
    [[nodiscard]] TagChips* chips() { return window_->findChild<PresetList*>()->findChild<TagChips*>(); }
    [[nodiscard]] QToolButton* chip(const QString& tag)
    {
        for (QToolButton* each : chips()->findChildren<QToolButton*>())
            if (each->text() == tag && each->isVisible()) return each;
        return nullptr;
    }
    [[nodiscard]] PresetPreview* preview() { return window_->findChild<PresetList*>()->findChild<PresetPreview*>(); }
    [[nodiscard]] QString previewed()
    {
        QStringList texts;
        for (const QLabel* label : preview()->findChildren<QLabel*>()) texts << label->text();
        return texts.join('\n');
    }
    void select(const char* name) { presets()->setCurrentItem(rowsNamed(name).front()); }
    /// Enters the tags of the selected preset in the dialog of the menu.
    void tag(const char* name, const QString& tags)
    {
        select(name);
        action("Tags of preset…")->trigger();
        auto* ask = window_->findChild<TagsDialog*>();
        QVERIFY(ask);
        auto* line = ask->findChild<QLineEdit*>();
        line->selectAll();
        QTest::keyClicks(line, tags);
        ask->accept();
        QTRY_VERIFY(!window_->findChild<TagsDialog*>());
    }
    [[nodiscard]] QStringList tagsInFile(const char* file)
    {
        QFile stored(home_->filePath(QStringLiteral("vitrine/presets/sdf_morph/") + file));
        if (!stored.open(QIODevice::ReadOnly)) return {"no file"};
        QStringList tags;
        for (const auto& each : QJsonDocument::fromJson(stored.readAll()).object()["tags"].toArray())
            tags << each.toString();
        return tags;
    }
    void saveThree()
    {
        window_->choose(1);
        for (const char* name : {"Dull", "Rough", "Smooth"}) {
            dragRoughness(20 + 10 * presets()->count());
            window_->presetController().saveUnder(name);
        }
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void aShippedPresetSaysWhyItKeepsItsName()
    {
        QTest::failOnWarning(QRegularExpression("edit"));
        window_->choose(1);
        QVERIFY(presets()->count() > 0);
        presets()->setCurrentRow(0);
        const QString name = presets()->currentItem()->text();
        QApplication::setActiveWindow(window_.get());
        presets()->setFocus();
        QTest::keyClick(presets(), Qt::Key_F2);
        QVERIFY(!presets()->findChild<QLineEdit*>());
        QCOMPARE(window_->findChild<MessageStrip*>()->texts(),
                 QStringList{
                     name + " is supplied with the exhibit and cannot be renamed. Duplicate it, and rename the copy."});
        // Control: the visitor's own preset is renamed in its line.
        window_->presetController().saveUnder("Mine");
        select("Mine");
        QTest::keyClick(presets(), Qt::Key_F2);
        QVERIFY(presets()->findChild<QLineEdit*>());
    }

    void tagsAreGivenInADialogKeptInTheFileAndUndone()
    {
        saveThree();
        tag("Dull", " stone, night ,,Stone");
        QCOMPARE(tagsInFile("dull.json"), (QStringList{"stone", "night"}));
        window_->history().stack().undo();
        QCOMPARE(tagsInFile("dull.json"), QStringList());
        window_->history().stack().redo();
        QCOMPARE(tagsInFile("dull.json"), (QStringList{"stone", "night"}));
        // The preset in use is saved with its tags, and no message blames a change of the file.
        tag("Smooth", "silk");
        dragRoughness(90);
        window_->presetController().save();
        QCOMPARE(tagsInFile("smooth.json"), QStringList{"silk"});
        select("Smooth");
        const double saved = roughness();
        window_->history().stack().undo();
        window_->presetController().load(presets()->currentItem()->data(Qt::UserRole).toString());
        QCOMPARE(roughness(), saved);
    }

    void whatIsNoTagIsSaidWhileItIsTyped()
    {
        saveThree();
        select("Dull");
        action("Tags of preset…")->trigger();
        auto* ask = window_->findChild<TagsDialog*>();
        QVERIFY(ask);
        auto* line = ask->findChild<QLineEdit*>();
        line->setText(QString(60, 'x'));
        QStringList said;
        for (const QLabel* label : ask->findChildren<QLabel*>())
            if (label->isVisible()) said << label->text();
        QVERIFY2(said.join(' ').contains("at most 40 bytes"), qPrintable(said.join('\n')));
        QPushButton* save = nullptr;
        for (QPushButton* each : ask->findChildren<QPushButton*>())
            if (each->text() == "Save") save = each;
        QVERIFY(save && !save->isEnabled());
        line->setText("good");
        QVERIFY(save->isEnabled());
        ask->reject();
        QCOMPARE(tagsInFile("dull.json"), QStringList());
    }

    void tagsOfOthersCanBePicked()
    {
        saveThree();
        tag("Dull", "stone");
        select("Rough");
        action("Tags of preset…")->trigger();
        auto* ask = window_->findChild<TagsDialog*>();
        QVERIFY(ask);
        QToolButton* stone = nullptr;
        for (QToolButton* each : ask->findChildren<QToolButton*>())
            if (each->text() == "stone") stone = each;
        QVERIFY(stone);
        QTest::mouseClick(stone, Qt::LeftButton);
        QCOMPARE(ask->findChild<QLineEdit*>()->text(), QString("stone"));
        ask->accept();
        QTRY_COMPARE(tagsInFile("rough.json"), QStringList{"stone"});
    }

    void aShippedPresetIsTaggedInACopy()
    {
        window_->choose(1);
        select("Glass");
        action("Tags of preset…")->trigger();
        QVERIFY(!window_->findChild<TagsDialog*>());
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("Duplicate it"));
    }

    void chipsAndWordsFindTogether()
    {
        saveThree();
        tag("Dull", "stone, night");
        tag("Rough", "stone");
        const qsizetype all = found().size();
        QTRY_VERIFY(chip("stone"));
        QVERIFY(chip("material"));  // A tag of a preset that comes with the exhibit.
        chip("stone")->setFocus();
        QTest::keyClick(chip("stone"), Qt::Key_Space);
        QCOMPARE(found(), (QStringList{"Dull", "Rough"}));
        QTest::mouseClick(chip("night"), Qt::LeftButton);
        QCOMPARE(found(), QStringList{"Dull"});
        QTest::mouseClick(chip("night"), Qt::LeftButton);
        QTest::keyClicks(words(), "rou");
        QCOMPARE(found(), QStringList{"Rough"});
        // Pressed tags stay pressed when presets are added and removed.
        words()->clear();
        tag("Smooth", "stone");
        QVERIFY(chip("stone")->isChecked());
        QCOMPARE(found(), (QStringList{"Dull", "Rough", "Smooth"}));
        QTest::mouseClick(chip("stone"), Qt::LeftButton);
        QCOMPARE(found().size(), all);
        // Words also find tags.
        QTest::keyClicks(words(), "night");
        QCOMPARE(found(), QStringList{"Dull"});
        words()->clear();
        QVERIFY(rowsNamed("Dull").front()->data(Qt::AccessibleTextRole).toString().contains("Tags: stone, night"));
    }

    void spaceOpensALargePreviewThatFollowsTheSelection()
    {
        saveThree();
        tag("Dull", "stone");
        select("Dull");
        presets()->setFocus();
        QTest::keyClick(presets(), Qt::Key_Space);
        QTRY_VERIFY(preview()->isVisible());
        const QString first = previewed();
        QVERIFY2(first.contains("Dull") && first.contains("Tags: stone") && first.contains("Yours, saved on") &&
                     first.contains("Roughness: "),
                 qPrintable(first));
        QVERIFY(preview()->width() >= 384);
        QTest::keyClick(presets(), Qt::Key_Down);
        QVERIFY(preview()->isVisible());
        QVERIFY(previewed().contains(presets()->currentItem()->text()));
        QVERIFY(previewed() != first);
        QTest::keyClick(presets(), Qt::Key_Escape);
        QVERIFY(!preview()->isVisible());
        QCOMPARE(window_->focusWidget(), presets());
        QTest::keyClick(presets(), Qt::Key_Space);
        QVERIFY(preview()->isVisible());
        QTest::keyClick(presets(), Qt::Key_Space);
        QVERIFY(!preview()->isVisible());
    }

    void thePointerAtRestOpensThePreview()
    {
        window_->choose(1);
        QListWidgetItem* glass = rowsNamed("Glass").front();
        presets()->scrollToItem(glass);
        const QPoint at = presets()->visualItemRect(glass).center();
        const double before = roughness();
        QTest::mouseMove(presets()->viewport(), at - QPoint(4, 0));
        QTest::mouseMove(presets()->viewport(), at);
        QTRY_VERIFY(preview()->isVisible());
        QVERIFY(previewed().contains("Glass"));
        QVERIFY(previewed().contains("Supplied with the exhibit"));
        QCOMPARE(roughness(), before);
        QTest::mouseClick(presets()->viewport(), Qt::LeftButton, {}, at);
        QVERIFY(!preview()->isVisible());
    }

    void theThumbnailOfASavedPresetIsLargeEnoughForThePreview()
    {
        saveThree();
        QCOMPARE(QImage(home_->filePath("vitrine/presets/sdf_morph/dull.png")).size(), QSize(384, 216));
    }
};

VITRINE_UI_TEST(PresetBrowserTest)

#include "preset_browser_test.moc"
