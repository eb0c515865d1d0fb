#include "sample_tables.h"

#include "ui/parameters/color_editor.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/parameter_section.h"
#include "ui/parameters/value_slider.h"
#include "ui/window/theme.h"
#include "ui/window/undo.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QSet>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>

#include <clocale>
#include <memory>

using namespace vitrine;
using namespace vitrine::ui;

class PanelTest : public QObject {
    Q_OBJECT

    const test::SampleTable table_{};
    const test::IdleTable idle_{};
    std::unique_ptr<History> history_;
    std::unique_ptr<ParameterPanel> panel_;

    [[nodiscard]] const ParameterValues& values() const { return history_->look().values[0]; }
    template <typename T> T* in(std::string_view row) { return panel_->row(row)->findChild<T*>(); }
    NumberField* field(std::string_view row) { return in<NumberField>(row); }
    ValueSlider* slider(std::string_view row) { return in<ValueSlider>(row); }
    ResetDot* dot(std::string_view row) { return in<ResetDot>(row); }
    static void wheel(QWidget* widget, int delta)
    {
        const QPointF at = QRectF(widget->rect()).center();
        QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &event);
    }
    void type(std::string_view row, const QString& text)
    {
        QTest::mouseClick(field(row), Qt::LeftButton);
        QTest::keyClicks(field(row), text);
        QTest::keyClick(field(row), Qt::Key_Return);
    }
    void drag(QWidget* widget, QPoint from, int pixels, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(widget, Qt::LeftButton, modifiers, from);
        const int sign = pixels < 0 ? -1 : 1;
        for (int x = 0; x != pixels + sign; x += sign) {
            QMouseEvent move(QEvent::MouseMove, from + QPoint(x, 0), widget->mapToGlobal(QPointF(from) + QPointF(x, 0)),
                             Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(widget, &move);
        }
    }
    void showIdleTable() { history_->restart(Look{{idle_.initial()}, {}}); }
    /// How much a row's label stands out: the largest difference from its background, 0 to 255.
    [[nodiscard]] int ink(ParameterRow* row)
    {
        const QImage seen = row->findChild<RowLabel*>()->grab().toImage();
        const int back = qGray(seen.pixel(seen.width() - 1, 0));
        int most = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) most = std::max(most, std::abs(qGray(seen.pixel(x, y)) - back));
        return most;
    }
    /// Chooses an entry of the row's menu.
    void choose(std::string_view row, const char* entry)
    {
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, panel_->row(row)->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(panel_->row(row), &event);
        auto* menu = panel_->findChildren<QMenu*>().constLast();
        for (QAction* action : menu->actions())
            if (action->text() == QLatin1String(entry)) action->trigger();
        menu->close();
    }
    void release(QWidget* widget, QPoint at) { QTest::mouseRelease(widget, Qt::LeftButton, {}, at); }

private slots:
    void initTestCase()
    {
        std::setlocale(LC_NUMERIC, "C");
        applyTheme(*qApp, darkTheme());
    }

    void init()
    {
        history_ = std::make_unique<History>(Look{{table_.initial()}, {}});
        panel_ = std::make_unique<ParameterPanel>();
        connect(panel_.get(), &ParameterPanel::edited, history_.get(),
                [this](const ParameterValues& next, int gesture, const QString& text) {
                    history_->change(text, {{next}, {}}, gesture);
                });
        connect(history_.get(), &History::changed, panel_.get(), [this] { panel_->showValues(values(), "sample"); });
        panel_->showValues(values(), "sample");
        panel_->resize(360, 400);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get(), vitrine::test::patience));
        panel_->activateWindow();
    }

    void everyRowOfTheTableIsShownInOrder()
    {
        const auto rows = panel_->findChildren<ParameterRow*>();
        QCOMPARE(rows.size(), static_cast<qsizetype>(table_.rows().size()));
        for (const ParameterInfo& info : table_.rows()) {
            QVERIFY(panel_->row(info.name));
            QCOMPARE(panel_->row(info.name)->height(), ParameterRow::rowHeight);
        }
    }

    void theWheelOverAControlWithoutFocusChangesNothingAndScrolls()
    {
        for (QWidget* widget : panel_->findChildren<QWidget*>()) {
            if (widget->hasFocus() || !widget->isVisible()) continue;
            wheel(widget, 120);
            wheel(widget, -120);
        }
        QVERIFY(values() == table_.initial());
        QCOMPARE(history_->stack().count(), 0);
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
        QVERIFY(values()[table_.morph] > 0.6);  // The picture follows while dragging.
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
        type("tilt", "45");  // Without a unit: in the one shown.
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
        QVERIFY(field("morph")->editing());  // Still there to be mended.
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

    void theFilterOverridesFolding()
    {
        auto sections = panel_->findChildren<ParameterSection*>();
        for (ParameterSection* section : sections) section->setFolded(true);
        QVERIFY(!panel_->row("roughness")->isVisible());
        auto* filter = panel_->findChild<QLineEdit*>("", Qt::FindDirectChildrenOnly);
        panel_->focusFilter();
        QTest::keyClicks(filter, "rough");
        QVERIFY(panel_->row("roughness")->isVisible());
        QVERIFY(!panel_->row("morph")->isVisible());
        QTest::keyClick(filter, Qt::Key_Escape);
        QVERIFY(filter->text().isEmpty());
        QVERIFY(!panel_->row("roughness")->isVisible());
    }

    void onlyChangedShowsWhatWasChanged()
    {
        type("roughness", "0.8");
        panel_->findChild<QToolButton*>("", Qt::FindDirectChildrenOnly)->click();
        QVERIFY(panel_->row("roughness")->isVisible());
        QVERIFY(!panel_->row("morph")->isVisible());
    }

    void foldedGroupsAreRemembered()
    {
        auto* heading = panel_->findChildren<SectionHeading*>().at(1);
        QTest::mouseClick(heading, Qt::LeftButton);
        QCOMPARE(panel_->foldedGroups(), QStringList{"sample/Surface"});
        ParameterPanel other;
        other.setFoldedGroups(panel_->foldedGroups());
        other.showValues(values(), "sample");
        other.show();
        QVERIFY(!other.row("roughness")->isVisible());
        QVERIFY(other.row("morph")->isVisible());
    }

    void everyControlHasANameOfItsOwnATooltipAndATabPosition()
    {
        QSet<QString> names;
        int controls = 0;
        for (QWidget* widget : panel_->findChildren<QWidget*>()) {
            if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible()) continue;
            const QString name = widget->accessibleName();
            QVERIFY2(!name.isEmpty(), widget->metaObject()->className());
            QVERIFY2(!names.contains(name), qPrintable(name));
            names << name;
            bool tip = false;
            for (const QWidget* w = widget; w && w != panel_.get(); w = w->parentWidget()) tip = tip || !w->toolTip().isEmpty();
            QVERIFY2(tip, qPrintable(name));
            ++controls;
        }
        QVERIFY(controls > 30);
    }

    void everyControlIsReachedByTab()
    {
        QSet<QWidget*> wanted, reached;
        for (QWidget* widget : panel_->findChildren<QWidget*>())
            if ((widget->focusPolicy() & Qt::TabFocus) && widget->isVisible() && widget->isEnabled()) wanted << widget;
        panel_->focusFilter();
        for (int i = 0; i < 200; ++i) {
            if (QWidget* now = QApplication::focusWidget()) {
                reached << now;
                QTest::keyClick(now, Qt::Key_Tab);
            }
        }
        for (QWidget* widget : wanted) QVERIFY2(reached.contains(widget), qPrintable(widget->accessibleName()));
        QVERIFY(values() == table_.initial());  // Passing through changes nothing.
    }

    void tooltipsSayEverything()
    {
        const QString tip = panel_->row("tubeRadius")->toolTip();
        for (const char* part : {"Radius of the torus's tube.", "1 to 200", "mm", "Initial value: 12", "tubeRadius", "Shift"})
            QVERIFY2(tip.contains(QLatin1String(part)), part);
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
        QVERIFY(std::abs(values()[table_.base].value.x - 0.21586) < 1e-4);  // sRGB 128: IEC 61966-2-1.
        QCOMPARE(history_->stack().count(), 3);
    }

    void linearAndEncodedColorsRoundTrip()
    {
        for (int i = 0; i < 256; ++i) QCOMPARE(encoded(linear(QColor(i, 255 - i, 17))).rgb(), QColor(i, 255 - i, 17).rgb());
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

    void valuesAreCopiedAndPasted()
    {
        type("roughness", "0.1234567890123");
        QMetaObject::invokeMethod(panel_->row("roughness"), [&] {
            QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, panel_->row("roughness")->mapToGlobal(QPoint(5, 5)));
            QApplication::sendEvent(panel_->row("roughness"), &event);
        });
        auto* menu = panel_->findChild<QMenu*>();
        QVERIFY(menu);
        for (QAction* action : menu->actions())
            if (action->text() == "Copy value") action->trigger();
        QCOMPARE(QApplication::clipboard()->text(), QString("0.1234567890123"));
        for (QAction* action : menu->actions())
            if (action->text().startsWith("Reset")) action->trigger();
        QCOMPARE(values()[table_.roughness], 0.25);
        for (QAction* action : menu->actions())
            if (action->text() == "Paste") action->trigger();
        QCOMPARE(values()[table_.roughness], 0.1234567890123);
        for (QAction* action : menu->actions())
            if (action->text() == "Copy all as JSON") action->trigger();
        QVERIFY(QApplication::clipboard()->text().contains("\"roughness\": 0.1234567890123"));
        menu->close();
    }

    void aRowThatDoesNotActIsGrayAndSaysWhenItDoesAndKeepsWhatIsTyped()
    {
        showIdleTable();
        ParameterRow* row = panel_->row("hourOfDay");
        QVERIFY(row->idle());
        QVERIFY(!panel_->row("sunHeight")->idle());
        QVERIFY2(row->toolTip().startsWith(QStringLiteral("Does nothing now: acts when “Set sun by” is hour.")), qPrintable(row->toolTip()));
        QCOMPARE(row->accessibleDescription(), QStringLiteral("Does nothing now: acts when “Set sun by” is hour. It keeps its value."));
        QVERIFY(ink(row) < 0.7 * ink(panel_->row("sunHeight")));
        type("hourOfDay", "9.5");
        QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("hourOfDay"))), 9.5);
        auto* choice = in<QComboBox>("sunBy");
        choice->setFocus();
        QTest::keyClick(choice, Qt::Key_Down);
        QVERIFY(!row->idle());
        QVERIFY(panel_->row("sunHeight")->idle());
        QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("hourOfDay"))), 9.5);
        QVERIFY(!row->toolTip().contains(QStringLiteral("Does nothing")));
        QVERIFY(row->toolTip().contains(QStringLiteral("Of the day.")));
    }

    void labelsSayWhatTheirHeadingDoesNotAndTooltipsSayAll()
    {
        showIdleTable();
        const auto label = [&](const char* row) { return panel_->row(row)->findChild<RowLabel*>()->text(); };
        QCOMPARE(label("sunBy"), QStringLiteral("Set sun by"));
        QCOMPARE(label("sunHeight"), QStringLiteral("Height"));
        QVERIFY(panel_->row("sunHeight")->toolTip().contains(QStringLiteral("Sun height")));
        QVERIFY(panel_->row("sunHeight")->toolTip().contains(QStringLiteral("Allowed: 0 to 1")));
    }

    void aNumberThatMeansAWordReadsAndIsTypedAsIt()
    {
        showIdleTable();
        QCOMPARE(field("convergence")->text(), QStringLiteral("auto"));
        type("convergence", "2.5");
        QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("convergence"))), 2.5);
        type("convergence", "Auto");
        QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("convergence"))), 0.0);
        QCOMPARE(field("convergence")->text(), QStringLiteral("auto"));
    }

    void aTimeOfDayIsTypedAndShownAsOne()
    {
        showIdleTable();
        QCOMPARE(field("hourOfDay")->text(), QStringLiteral("16:06"));
        type("hourOfDay", "17:30");
        QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("hourOfDay"))), 17.5);
        type("hourOfDay", "8 h");
        QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("hourOfDay"))), 8.0);
        for (const char* wrong : {"17:60", "17:3x", "25:00", ":30", "-1:30"}) {
            type("hourOfDay", wrong);
            QVERIFY2(field("hourOfDay")->editing(), wrong);
            QTest::keyClick(field("hourOfDay"), Qt::Key_Escape);
            QCOMPARE(std::get<double>(panel_->values()->row(*idle_.find("hourOfDay"))), 8.0);
        }
    }

    void aDecimalCommaIsTakenWhereItIsTheLanguages()
    {
        type("roughness", "0,05");
        QCOMPARE(values()[table_.roughness], 0.25);  // In English, it is none.
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

    void groupsThatStartFoldedAreRememberedWhenOpened()
    {
        showIdleTable();
        QVERIFY(!panel_->row("steps")->isVisible());
        QVERIFY(panel_->foldedGroups().isEmpty());
        QTest::mouseClick(panel_->findChildren<SectionHeading*>().at(1), Qt::LeftButton);
        QVERIFY(panel_->row("steps")->isVisible());
        ParameterPanel other;
        other.setFoldedGroups(panel_->foldedGroups());
        other.showValues(*panel_->values(), "sample");
        other.show();
        QVERIFY(other.row("steps")->isVisible());
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
        QCOMPARE(code->text(), QStringLiteral("reddish"));  // Still there to be mended.
        QVERIFY(QToolTip::text().contains(QStringLiteral("\"reddish\" is no value for “Base color”")));
        QCOMPARE(code->palette().color(QPalette::Text), theme().error);
        enter("#00ff00");
        QCOMPARE(code->palette().color(QPalette::Text), theme().text);
    }

    void pastingNonsenseSaysSoAndPasteAllIsTheCounterpartOfCopyAll()
    {
        type("roughness", "0.7");
        type("morph", "0.125");
        choose("roughness", "Copy all as JSON");
        const QString all = QApplication::clipboard()->text();
        type("roughness", "0.3");
        type("stepLimit", "5");
        const int before = history_->stack().count();
        QApplication::clipboard()->setText(all);
        choose("speed", "Paste all");
        QCOMPARE(values()[table_.roughness], 0.7);
        QCOMPARE(values()[table_.morph], 0.125);
        QCOMPARE(values()[table_.stepLimit], 96);  // What is not in it is initial, as with a preset.
        QCOMPARE(history_->stack().count(), before + 1);
        const ParameterValues kept = values();
        QApplication::clipboard()->setText("a poem");
        choose("roughness", "Paste");
        QVERIFY2(QToolTip::text().contains(QStringLiteral("\"a poem\" is no value for “Roughness”")), qPrintable(QToolTip::text()));
        choose("roughness", "Paste all");
        QVERIFY2(QToolTip::text().contains(QStringLiteral("the clipboard")), qPrintable(QToolTip::text()));
        QVERIFY(values() == kept);
    }

    void slidersHaveRoomAtTheDefaultWidth()
    {
        QVERIFY2(slider("roughness")->width() >= 100, qPrintable(QString::number(slider("roughness")->width())));
        QVERIFY(field("stepLimit")->width() >= 64);
        const int start = slider("roughness")->mapTo(panel_.get(), QPoint()).x();
        for (const char* row : {"speed", "stepLimit", "exposure"}) QCOMPARE(slider(row)->mapTo(panel_.get(), QPoint()).x(), start);
        panel_->resize(600, 400);
        QCoreApplication::processEvents();
        QVERIFY(panel_->row("roughness")->findChild<RowLabel*>()->width() > 160);
        QCOMPARE(slider("speed")->mapTo(panel_.get(), QPoint()).x(), slider("roughness")->mapTo(panel_.get(), QPoint()).x());
    }

    void fieldsStandOutInBothThemes()
    {
        // WCAG 2.2, 1.4.11: 3:1 for what tells a control from its surroundings; contrast by 1.4.3's formula.
        const auto luminance = [](const QColor& c) { return glm::dot(linear(c), glm::dvec3(0.2126, 0.7152, 0.0722)); };
        const auto contrast = [&](const QColor& a, const QColor& b) {
            const double x = luminance(a) + 0.05;
            const double y = luminance(b) + 0.05;
            return std::max(x / y, y / x);
        };
        for (const Theme& each : {darkTheme(), lightTheme()}) {
            QVERIFY(contrast(each.outline, each.window) >= 3);
            QVERIFY(contrast(each.outline, each.base) >= 3);
            applyTheme(*qApp, each);
            QWidget* number = field("roughness");
            const QImage seen = number->grab().toImage();
            QVERIFY2(contrast(seen.pixelColor(seen.width() / 2, 0), each.window) > 2, "the edge of a number is drawn");  // It is antialiased.
        }
        applyTheme(*qApp, darkTheme());
    }

    void gaugesAreHiddenUntilSomethingAnswersThem()
    {
        QVERIFY(!in<GaugeMark>("stepLimit")->isVisible());
        QVERIFY(!in<GaugeMark>("roughness"));
        QSignalSpy asked(panel_.get(), &ParameterPanel::accuracyAsked);
        panel_->setGaugesShown(true);
        QVERIFY(in<GaugeMark>("stepLimit")->isVisible());
        QTest::mouseClick(in<GaugeMark>("stepLimit"), Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked[0][0].value<std::size_t>(), table_.find("stepLimit").value());
    }
};

QTEST_MAIN(PanelTest)

#include "panel_test.moc"
