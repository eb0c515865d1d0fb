#include "tests/ui/parameters/open_panel.h"
#include "tests/ui/ui_main.h"

#include "ui/parameters/color_picker.h"
#include "ui/parameters/screen_color.h"
#include "ui/parameters/way_to_act.h"

#include "exhibits/exhibits.h"
#include "exhibits/framework/table/acting.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QToolTip>

using namespace vitrine;
using namespace vitrine::ui;

/// Dragging, stepping, typing and choosing of single values.
class ValueEditorsTest : public test::OpenPanel {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { open(); }

    void everyRowThatDoesNothingHasAWayToActUnlessItNeedsAFile()
    {
        int ways = 0;
        for (const auto& exhibit : allExhibits()) {
            const ParameterValues values = exhibit->parameters().initial();
            for (std::size_t row = 0; row < values.rows().size(); ++row) {
                const std::string name = std::string(exhibit->name()) + '.' + std::string(values.rows()[row].name);
                const std::optional<ParameterChanges> changes = changesToAct(values, row);
                if (acts(values, row)) {
                    QVERIFY2(changes && changes->empty(), name.c_str());
                    continue;
                }
                if (!changes) {
                    QVERIFY2(actsWhen(values, row).find("names a file") != std::string::npos, name.c_str());
                    continue;
                }
                ParameterValues changed = values;
                for (const auto& [other, value] : *changes) changed.setParameter(other, value);
                QVERIFY2(acts(changed, row), name.c_str());
                ++ways;
            }
        }
        QVERIFY(ways > 100);
    }

    void theWheelOverAFieldWithFocusSteps()
    {
        slider("morph")->setFocus();
        wheel(slider("morph"), 120);
        QVERIFY(values()[table_.morph] > 0.5);
    }

    void oneDragOfASliderIsOneStep()
    {
        ValueSlider* morph = slider("morph");
        const QPoint from(morph->width() / 2, morph->height() / 2);
        drag(morph, from, 25);
        QVERIFY(values()[table_.morph] > 0.6);  // The picture follows during the drag.
        release(morph, from + QPoint(25, 0));
        QCOMPARE(history_->stack().count(), 1);
        QCOMPARE(history_->stack().undoText(), QString("Change morph"));
        history_->stack().undo();
        QVERIFY(values() == table_.initial());
        QCOMPARE(field("morph")->value(), 0.5);
    }

    void draggingTheFieldAndTheLabelChangesTheNumber()
    {
        NumberField* morph = field("morph");
        drag(morph, {10, 10}, 40);
        release(morph, {50, 10});
        const double dragged = values()[table_.morph];
        QVERIFY(dragged > 0.6 && dragged < 0.8);
        QCOMPARE(history_->stack().count(), 1);
        RowLabel* label = in<RowLabel>("morph");
        drag(label, {10, 10}, -40);
        release(label, {-30, 10});
        QVERIFY(std::abs(values()[table_.morph] - 0.5) < 0.02);
        QCOMPARE(history_->stack().count(), 2);
    }

    void shiftDragsFinerAndCtrlCoarser()
    {
        drag(field("roughness"), {10, 10}, 40, Qt::ShiftModifier);
        release(field("roughness"), {50, 10});
        const double fine = values()[table_.roughness] - 0.25;
        QVERIFY(fine > 0.005 && fine < 0.03);
        drag(field("tilt"), {10, 10}, 8, Qt::ControlModifier);
        release(field("tilt"), {18, 10});
        QVERIFY(values()[table_.tilt] > 1);
    }

    void escDuringADragBringsTheValueBackAndLeavesNoStep()
    {
        NumberField* morph = field("morph");
        drag(morph, {10, 10}, 40);
        QVERIFY(values()[table_.morph] != 0.5);
        QTest::keyClick(morph, Qt::Key_Escape);
        QCOMPARE(values()[table_.morph], 0.5);
        QCOMPARE(history_->stack().count(), 0);
        release(morph, {50, 10});
        drag(slider("morph"), {20, 10}, 20);
        QTest::keyClick(slider("morph"), Qt::Key_Escape);
        QCOMPARE(values()[table_.morph], 0.5);
        release(slider("morph"), {40, 10});
        QCOMPARE(history_->stack().count(), 0);
    }

    void escWhileTypingBringsTheTextBack()
    {
        QTest::mouseClick(field("morph"), Qt::LeftButton);
        QVERIFY(field("morph")->editing());
        QTest::keyClicks(field("morph"), "0.9");
        QTest::keyClick(field("morph"), Qt::Key_Escape);
        QVERIFY(!field("morph")->editing());
        QCOMPARE(field("morph")->text(), QString("0.5"));
        QCOMPARE(history_->stack().count(), 0);
    }

    void arithmeticAndUnitsAreTyped()
    {
        type("morph", "1/3");
        QVERIFY(std::abs(values()[table_.morph] - 1.0 / 3) < 1e-15);
        type("tilt", "30deg");
        QVERIFY(std::abs(values()[table_.tilt] - 0.5235987755982988) < 1e-12);
        type("tilt", "45");  // Without a unit, the displayed one is used.
        QVERIFY(std::abs(values()[table_.tilt] - 0.7853981633974483) < 1e-12);
        type("tubeRadius", "2*10");
        QVERIFY(std::abs(values()[table_.tube] - 0.020) < 1e-12);
        QCOMPARE(history_->stack().count(), 4);
    }

    void typingGoesBeyondTheSliderUpToTheLegalRange()
    {
        type("speed", "3");
        QCOMPARE(values()[table_.speed], 3.0);
        type("speed", "99");
        QCOMPARE(values()[table_.speed], 5.0);
        type("reflectionBounces", "2.6");
        QCOMPARE(values()[table_.bounces], 3);
    }

    void whatIsNoNumberChangesNothing()
    {
        type("morph", "import os");
        QVERIFY(values() == table_.initial());
        QVERIFY(field("morph")->editing());  // The text stays for correction.
        QTest::keyClick(field("morph"), Qt::Key_Escape);
        QCOMPARE(field("morph")->text(), QString("0.5"));
    }

    void arrowsStep()
    {
        field("stepLimit")->setFocus(Qt::OtherFocusReason);
        QTest::keyClick(field("stepLimit"), Qt::Key_Up);
        QCOMPARE(values()[table_.stepLimit], 97);
        QTest::keyClick(field("stepLimit"), Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(values()[table_.stepLimit], 107);
        field("roughness")->setFocus(Qt::OtherFocusReason);
        QTest::keyClick(field("roughness"), Qt::Key_Up);
        QCOMPARE(values()[table_.roughness], 0.27);
        QTest::keyClick(field("roughness"), Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(values()[table_.roughness], 0.268);
        QCOMPARE(history_->stack().count(), 4);
    }

    void aLogarithmicSliderHasTheGeometricMeanInItsMiddle()
    {
        const SliderScale scale(panel_->row("tubeRadius")->info());
        QVERIFY(std::abs(scale.value(0.5) - std::sqrt(0.002 * 0.1)) < 1e-4);
        QCOMPARE(scale.value(0), 0.002);
        QCOMPARE(scale.value(1), 0.1);
        for (double p = 0; p <= 1; p += 0.01) QVERIFY(std::abs(scale.position(scale.value(p)) - p) < 0.01);
    }

    void aSliderWorksByKeyboard()
    {
        slider("haze")->setFocus();
        QTest::keyClick(slider("haze"), Qt::Key_Right);
        QVERIFY(values()[table_.haze] > 0.1);
        QTest::keyClick(slider("haze"), Qt::Key_Home);
        QCOMPARE(values()[table_.haze], 0.0);
        QTest::keyClick(slider("haze"), Qt::Key_End);
        QCOMPARE(values()[table_.haze], 1.0);
    }

    void theResetDotIsThereOnlyWhileTheValueDiffers()
    {
        QVERIFY(!dot("roughness")->isEnabled());
        type("roughness", "0.8");
        QVERIFY(dot("roughness")->isEnabled());
        QTest::mouseClick(dot("roughness"), Qt::LeftButton);
        QCOMPARE(values()[table_.roughness], 0.25);
        QVERIFY(!dot("roughness")->isEnabled());
        QCOMPARE(history_->stack().undoText(), QString("Reset roughness"));
        history_->stack().undo();
        QCOMPARE(values()[table_.roughness], 0.8);
        QVERIFY(dot("roughness")->isEnabled());
    }

    void choosingTogglingAndColors()
    {
        auto* choice = in<QComboBox>("material");
        choice->setFocus();
        QTest::keyClick(choice, Qt::Key_Down);
        QCOMPARE(values()[table_.material], test::Method::tetrahedron);
        QTest::mouseClick(in<QCheckBox>("animated"), Qt::LeftButton, {}, {6, 10});
        QCOMPARE(values()[table_.animated], false);
        auto* code = in<QLineEdit>("baseColor");
        code->selectAll();
        QTest::keyClicks(code, "#808080");
        QTest::keyClick(code, Qt::Key_Return);
        QVERIFY(std::abs(values()[table_.base].value.x - 0.21586) < 1e-4);  // sRGB code 128 (IEC 61966-2-1).
        QCOMPARE(history_->stack().count(), 3);
    }

    void aColorIsPickedInADialogOfOneUndoStepThatCancelTakesBack()
    {
        const glm::dvec3 before = values()[table_.base].value;
        QAbstractButton* swatch = nullptr;
        for (auto* button : panel_->row("baseColor")->findChildren<QAbstractButton*>())
            if (button->accessibleName().contains("choose a color")) swatch = button;
        QVERIFY(swatch);
        swatch->click();
        auto* dialog = panel_->findChild<ColorDialog*>();
        QVERIFY(dialog);
        QCOMPARE(dialog->findChild<QLabel*>()->text(), QString("Base color"));
        auto* field = dialog->findChild<ColorField*>();
        QTest::mouseClick(field, Qt::LeftButton, {}, field->placeOfHue(1 / 3.0).toPoint());
        QTest::mouseClick(field, Qt::LeftButton, {}, field->placeOf(1, 1).toPoint());
        const glm::dvec3 green = values()[table_.base].value;
        QVERIFY(green.y > 0.98 && green.x < 0.02 && green.z < 0.02);
        QTest::keyClick(field, Qt::Key_Left);
        QVERIFY(values()[table_.base].value.x > green.x);
        QCOMPARE(history_->stack().count(), 1);
        dialog->reject();
        QVERIFY(glm::distance(values()[table_.base].value, before) < 1e-12);
        QCOMPARE(history_->stack().count(), 0);
    }

    void linearAndEncodedColorsRoundTrip()
    {
        for (int i = 0; i < 256; ++i)
            QCOMPARE(encoded(linear(QColor(i, 255 - i, 17))).rgb(), QColor(i, 255 - i, 17).rgb());
    }

    void aDirectionKeepsItsAzimuthAtTheZenith()
    {
        auto fields = panel_->row("lightDirection")->findChildren<NumberField*>();
        fields[0]->setFocus(Qt::TabFocusReason);
        QTest::keyClicks(fields[0], "120");
        QTest::keyClick(fields[0], Qt::Key_Return);
        fields[1]->setFocus(Qt::TabFocusReason);
        QTest::keyClicks(fields[1], "90");
        QTest::keyClick(fields[1], Qt::Key_Return);
        QVERIFY(values()[table_.light].value.y > 0.999999);
        QVERIFY(fields[0]->text().startsWith("120"));
    }

    void aNumberThatMeansAWordReadsAndIsTypedAsIt()
    {
        showIdleTable();
        QCOMPARE(field("convergence")->text(), QStringLiteral("auto"));
        type("convergence", "2.5");
        QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("convergence"))), 2.5);
        type("convergence", "Auto");
        QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("convergence"))), 0.0);
        QCOMPARE(field("convergence")->text(), QStringLiteral("auto"));
    }

    void aTimeOfDayIsTypedAndShownAsOne()
    {
        showIdleTable();
        QCOMPARE(field("hourOfDay")->text(), QStringLiteral("16:06"));
        type("hourOfDay", "17:30");
        QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("hourOfDay"))), 17.5);
        type("hourOfDay", "8 h");
        QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("hourOfDay"))), 8.0);
        for (const char* wrong : {"17:60", "17:3x", "25:00", ":30", "-1:30"}) {
            type("hourOfDay", wrong);
            QVERIFY2(field("hourOfDay")->editing(), wrong);
            QTest::keyClick(field("hourOfDay"), Qt::Key_Escape);
            QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("hourOfDay"))), 8.0);
        }
    }

    void aDecimalCommaIsTakenWhereItIsTheLanguages()
    {
        type("roughness", "0,05");
        QCOMPARE(values()[table_.roughness], 0.25);  // Invalid in English.
        QTest::keyClick(field("roughness"), Qt::Key_Escape);
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        type("roughness", "0,05");
        const double typed = values()[table_.roughness];
        type("roughness", "0.75");
        QLocale::setDefault(before);
        QCOMPARE(typed, 0.05);
        QCOMPARE(values()[table_.roughness], 0.75);
    }

    void aColorIsTypedInManyWaysAndWhatIsNoneSaysSo()
    {
        auto* code = in<QLineEdit>("baseColor");
        const auto enter = [&](const char* text) {
            code->setFocus();
            code->selectAll();
            QTest::keyClicks(code, QLatin1String(text));
            QTest::keyClick(code, Qt::Key_Return);
        };
        for (const char* text : {"red", "f00", "#f00", "#ff0000", "FF0000", "1, 0, 0"}) {
            enter("#102030");
            enter(text);
            QVERIFY2(values()[table_.base].value == glm::dvec3(1, 0, 0), text);
            QCOMPARE(code->text(), QStringLiteral("#ff0000"));
        }
        enter("reddish");
        QVERIFY(values()[table_.base].value == glm::dvec3(1, 0, 0));
        QCOMPARE(code->text(), QStringLiteral("reddish"));  // The text stays for correction.
        QVERIFY(QToolTip::text().contains(QStringLiteral("\"reddish\" is not a value of “Base color”")));
        QCOMPARE(code->palette().color(QPalette::Text), theme().error);
        enter("#00ff00");
        QCOMPARE(code->palette().color(QPalette::Text), theme().text);
    }
};

VITRINE_UI_TEST(ValueEditorsTest)

#include "value_editors_test.moc"
