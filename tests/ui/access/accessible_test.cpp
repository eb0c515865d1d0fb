// Accessibility as screen readers get it, queried within the program. New widgets without a name fail here even without
// AT-SPI.
#include "tests/ui/access/accessible_tree.h"
#include "tests/ui/access/every_part.h"
#include "tests/ui/ui_main.h"

#include "ui/compare/compare_controller.h"
#include "ui/compare/compare_overlay.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/parameter_section.h"
#include "ui/presets/preset_controller.h"
#include "ui/window/status_line.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

using namespace vitrine;
using namespace vitrine::ui;

class AccessibleTest : public test::EveryPart {
    Q_OBJECT

    [[nodiscard]] static QAccessibleInterface* of(QObject* object)
    {
        return QAccessible::queryAccessibleInterface(object);
    }
    [[nodiscard]] static QString description(QObject* object) { return of(object)->text(QAccessible::Description); }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longEveryPartOfTheWindowIsNamedAndEveryNumberHasItsEnds()
    {
        window_->say(MessageStrip::Mood::notice, "Something happened.");
        window_->say(MessageStrip::Mood::problem, "Something went wrong.");
        window_->comparison().setToCurrent();
        QStringList complaints = test::complaintsOf(*window_);
        int docks = 0;
        forEveryDock([&](QDockWidget& dock) {
            complaints << test::complaintsOf(dock);
            ++docks;
        });
        QVERIFY(docks >= 7);
        complaints.removeDuplicates();
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
    }

    void longEveryPartOfEveryDialogIsNamedAndEveryNumberHasItsEnds()
    {
        QStringList complaints, seen;
        forEveryDialog([&](const QString& name, QWidget& dialog) {
            seen << name;
            for (const QString& each : test::complaintsOf(dialog)) complaints << name + QLatin1String(": ") + each;
        });
        QVERIFY2(seen.size() >= 9, qPrintable(seen.join(", ")));
        complaints.removeDuplicates();
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
    }

    void longAWidgetWithoutANameOrANumberWithoutEndsIsFound()
    {
        QWidget parent;
        auto* line = new QLineEdit(&parent);
        line->show();
        parent.show();
        QCOMPARE(test::complaintsOf(parent).size(), 1);
        line->setAccessibleName("Named");
        QCOMPARE(test::complaintsOf(parent), QStringList());
    }

    void aSliderSaysItsValueInItsUnitAndIsSetInOneStep()
    {
        window_->choose(1);
        auto* slider = in<ValueSlider>("roughness");
        QAccessibleValueInterface* value = of(slider)->valueInterface();
        QVERIFY(value);
        QCOMPARE(of(slider)->role(), QAccessible::Slider);
        QCOMPARE(value->currentValue().toDouble(), 0.25);
        QCOMPARE(value->minimumValue().toDouble(), 0.0);
        QCOMPARE(value->maximumValue().toDouble(), 1.0);
        value->setCurrentValue(0.5);
        QCOMPARE(roughness(), 0.5);
        QCOMPARE(value->currentValue().toDouble(), 0.5);
        QCOMPARE(window_->history().stack().count(), 1);
        value->setCurrentValue(7);  // Clamped to its range.
        QCOMPARE(roughness(), 1.0);
        window_->history().stack().undo();
        window_->history().stack().undo();
        QCOMPARE(roughness(), 0.25);
        for (const QVariant& nonsense : {QVariant("much"), QVariant(NAN), QVariant()}) value->setCurrentValue(nonsense);
        QCOMPARE(window_->history().stack().index(), 0);
        auto* field = in<NumberField>("roughness");
        QCOMPARE(of(field)->role(), QAccessible::SpinBox);
        of(field)->valueInterface()->setCurrentValue(0.75);
        QCOMPARE(roughness(), 0.75);
        QCOMPARE(of(field)->text(QAccessible::Value), field->text());
    }

    void aSwitchAndAHeadingAreToggledWithoutAClick()
    {
        window_->choose(1);
        const auto animated = [this] {
            const ParameterValues& values = window_->history().sceneState().values[1];
            return std::get<double>(values.row(values.table().find("animated").value())) != 0;
        };
        const auto toggle = [](QWidget* button) {
            of(button)->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
        };
        const bool before = animated();
        auto* box = in<QCheckBox>("animated");
        toggle(box);
        QCOMPARE(animated(), !before);
        QCOMPARE(window_->history().stack().count(), 1);
        window_->history().stack().undo();
        QCOMPARE(animated(), before);
        QCOMPARE(box->isChecked(), before);
        QCOMPARE(window_->history().stack().count(), 1);
        for (QAbstractButton* each : window_->panel().findChildren<QAbstractButton*>()) {
            if (of(each)->role() != QAccessible::Button && each->isCheckable() && each->isVisible() && each != box &&
                each->parentWidget()->inherits("vitrine::ui::ParameterSection")) {
                auto* section = qobject_cast<ParameterSection*>(each->parentWidget());
                const bool folded = section->folded();
                toggle(each);
                QCOMPARE(section->folded(), !folded);
                QVERIFY(section->findChild<ParameterRow*>()->isVisible() == folded);
                return;
            }
        }
        QFAIL("no heading was found");
    }

    void aBoxOfChoicesSaysItsNameAndWhatIsChosen()
    {
        window_->choose(1);
        auto* box = in<QComboBox>("normalMethod");
        QAccessibleInterface* spoken = of(box);
        QCOMPARE(spoken->role(), QAccessible::ComboBox);
        QCOMPARE(spoken->text(QAccessible::Name), QString("Normal method: central"));
        QCOMPARE(spoken->text(QAccessible::Value), QString("central"));
        QCOMPARE(spoken->childCount(), 1);
        QCOMPARE(spoken->indexOfChild(spoken->child(0)), 0);
        QCOMPARE(spoken->child(0)->role(), QAccessible::List);
        spoken->actionInterface()->doAction(QAccessibleActionInterface::showMenuAction());
        QTRY_VERIFY(box->view()->isVisible() && spoken->state().expanded);
        spoken->actionInterface()->doAction(QAccessibleActionInterface::showMenuAction());
        QTRY_VERIFY(!box->view()->isVisible() && spoken->state().collapsed);
    }

    void whatIsHiddenIsNotRead()
    {
        const auto read = [this] {
            int count = 0;
            for (const QLabel* label : window_->findChildren<QLabel*>())
                count += label->text() == "No preset matches these words and tags.";
            return count;
        };
        window_->choose(1);
        for (const char* name : {"A", "B", "C", "D", "E", "F"}) window_->presetController().saveUnder(name);
        QCOMPARE(read(), 0);
        QLineEdit* words = nullptr;
        for (QLineEdit* line : window_->findChildren<QLineEdit*>())
            if (line->accessibleName() == "Find a preset") words = line;
        QVERIFY(words && words->isVisible());
        words->setText("nothing is called so");
        QCOMPARE(read(), 1);
        words->clear();
        QCOMPARE(read(), 0);
    }

    void aFieldThatIsTypedInGivesItsTextAndCaret()
    {
        window_->choose(1);
        activate(window_.get());
        auto* field = in<NumberField>("roughness");
        field->setFocus(Qt::TabFocusReason);
        QAccessibleTextInterface* text = of(field)->textInterface();
        QVERIFY(text && of(field)->editableTextInterface());
        QCOMPARE(text->text(0, text->characterCount()), field->text());
        QCOMPARE(text->selectionCount(), 1);
        of(field)->editableTextInterface()->replaceText(0, text->characterCount(), "3/4");
        QCOMPARE(text->cursorPosition(), 3);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(roughness(), 0.75);
        QVERIFY(field->rect().contains(field->mapFromGlobal(text->characterRect(0).center())));
    }

    void labelsSayWhatTheyAreAndWhatTheyShow()
    {
        auto* line = window_->findChild<StatusLine*>();
        QTRY_VERIFY(line->text().contains("passes ran"));
        QStringList names;
        for (QLabel* label : line->findChildren<QLabel*>())
            names << of(label)->text(QAccessible::Name) + ", " + of(label)->text(QAccessible::Description);
        QVERIFY2(names.join('|').contains("Time of the frame: ") && names.join('|').contains("2 passes ran"),
                 qPrintable(names.join('|')));
        window_->say(MessageStrip::Mood::problem, "Something went wrong.");
        QStringList said;
        auto* strip = window_->findChild<MessageStrip*>();
        for (QWidget* each : strip->findChildren<QWidget*>())
            if (of(each)->role() == QAccessible::AlertMessage) said << of(each)->text(QAccessible::Name);
        QCOMPARE(said, QStringList{"Something went wrong."});
    }

    void thePictureSaysWhereTheVisitorIsAndWhatHeLooksAt()
    {
        Viewport& viewport = window_->viewport();
        QCOMPARE(of(&viewport)->role(), QAccessible::Graphic);
        QVERIFY2(description(&viewport).contains("look at Torus to mug"), qPrintable(description(&viewport)));
        viewport.visitor().jumpTo({{0, 1.65, 10.5}, {0, 1.75, 20}, 0.9});
        QVERIFY2(!description(&viewport).contains("Torus"), qPrintable(description(&viewport)));
        viewport.visitor().jumpTo(test::PaintedGallery::towardsButton(1.2));
        QVERIFY2(description(&viewport).contains("melt it"), qPrintable(description(&viewport)));
        window_->visit(1);
        QVERIFY2(description(&viewport).contains("You look at Torus to mug, from 3."),
                 qPrintable(description(&viewport)));
    }

    void theLineOfTheWipeIsANumber()
    {
        window_->comparison().setToCurrent();
        CompareOverlay& overlay = window_->comparison().overlay();
        QTRY_VERIFY(overlay.isVisible());
        QAccessibleValueInterface* line = of(&overlay)->valueInterface();
        QVERIFY(line);
        QCOMPARE(line->currentValue().toDouble(), 50.0);
        line->setCurrentValue(20);
        QCOMPARE(overlay.wipe(), 0.2);
        QVERIFY2(description(&overlay).contains("20 %"), qPrintable(description(&overlay)));
        overlay.setMode(CompareMode::sideBySide);
        QVERIFY(!of(&overlay)->valueInterface());
    }
};

VITRINE_UI_TEST(AccessibleTest)

#include "accessible_test.moc"
