#include "tests/ui/parameters/open_panel.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/hyphens.h"
#include "ui/kit/text.h"
#include "ui/parameters/panel_choices.h"
#include "ui/parameters/parameter_menus.h"
#include "ui/parameters/parameter_section.h"
#include "ui/parameters/screen_color.h"
#include "ui/parameters/shown_text.h"

#include <QClipboard>
#include <QComboBox>
#include <QHash>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QSignalSpy>
#include <QToolButton>
#include <QToolTip>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

/// Counts how often each row of a panel, including its children, is painted.
class PaintCounter final : public QObject {
public:
    explicit PaintCounter(ParameterPanel& panel)
    {
        for (ParameterRow* row : panel.findChildren<ParameterRow*>())
            for (QWidget* widget : row->findChildren<QWidget*>()) {
                rows_[widget] = row;
                widget->installEventFilter(this);
            }
    }
    bool eventFilter(QObject* object, QEvent* event) override
    {
        if (event->type() == QEvent::Paint) painted << rows_.value(object);
        return false;
    }
    QSet<ParameterRow*> painted;

private:
    QHash<QObject*, ParameterRow*> rows_;
};

}  // namespace

/// The panel as a whole: its content, its layout, and the effect of changes.
class ParameterPanelTest : public test::OpenPanel {
    Q_OBJECT

private:
    [[nodiscard]] SectionHeading* heading(const QString& title) const
    {
        for (auto* each : panel_->findChildren<SectionHeading*>())
            if (each->text() == title && each->isVisible()) return each;
        return nullptr;
    }
    [[nodiscard]] QStringList headings() const
    {
        QStringList titles;
        for (const auto* each : panel_->findChildren<SectionHeading*>())
            if (each->isVisible()) titles << each->text();
        return titles;
    }
    /// Returns the names of the visible parameters, from the top.
    [[nodiscard]] QStringList visibleRows() const
    {
        QStringList names;
        for (const auto* row : panel_->findChildren<ParameterRow*>())
            if (row->isVisible()) names << text(row->info().name);
        return names;
    }
    /// Gives another panel what the visitor chose in this one, as the window does over the settings.
    void keepChoices(ParameterPanel& other) const
    {
        for (const PanelChoice choice : {PanelChoice::toggled, PanelChoice::locked, PanelChoice::pinned})
            other.choices().setList(choice, panel_->choices().list(choice));
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { open(); }

    void everyRowOfTheTableIsShownInOrder()
    {
        const auto rows = panel_->findChildren<ParameterRow*>();
        QCOMPARE(rows.size(), static_cast<qsizetype>(table_.rows().size()));
        for (const ParameterInfo& info : table_.rows()) {
            QVERIFY(panel_->row(info.name));
            QCOMPARE(panel_->row(info.name)->height(), ParameterRow::rowHeight);
        }
    }

    void aMoveOfTheMouseIsOneChangeOfOneValueAndPaintsOneRow()
    {
        ValueSlider* morph = slider("morph");
        const QPoint from(morph->width() / 2, morph->height() / 2);
        drag(morph, from, 5);
        QCoreApplication::processEvents();
        PaintCounter counter(*panel_);
        QSignalSpy changed(history_.get(), &History::changed);
        QSignalSpy replaced(history_.get(), &History::replaced);
        QSignalSpy fieldShown(field("morph"), &QLineEdit::textChanged);
        for (int x = 10; x <= 30; x += 10) {
            QMouseEvent move(QEvent::MouseMove, from + QPoint(x, 0), morph->mapToGlobal(QPointF(from) + QPointF(x, 0)),
                             Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(morph, &move);
            QCoreApplication::processEvents();
        }
        QCOMPARE(changed.count(), 3);
        QCOMPARE(changed[2][0].value<std::size_t>(), std::size_t{0});
        QCOMPARE(changed[2][1].value<std::size_t>(), *table_.find("morph"));
        QCOMPARE(replaced.count(), 0);
        QCOMPARE(fieldShown.count(), 3);
        QCOMPARE(counter.painted, QSet<ParameterRow*>{panel_->row("morph")});
        release(morph, from + QPoint(30, 0));
    }

    void whatComesFromElsewhereIsShown()
    {
        history_->set(0, *table_.find("roughness"), 0.75, newGesture());
        QCOMPARE(field("roughness")->value(), 0.75);
        QVERIFY(dot("roughness")->isEnabled());
        SceneState preset = history_->sceneState();
        preset.values[0].set(table_.roughness, 0.5);
        preset.values[0].set(table_.morph, 0.125);
        history_->change("Load", preset);
        QCOMPARE(field("roughness")->value(), 0.5);
        QCOMPARE(field("morph")->value(), 0.125);
        history_->stack().undo();
        QCOMPARE(field("roughness")->value(), 0.75);
        QCOMPARE(field("morph")->value(), 0.5);
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

    void onlyChangedShowsWhatWasChanged()
    {
        type("roughness", "0.8");
        panel_->findChild<QToolButton*>("", Qt::FindDirectChildrenOnly)->click();
        QVERIFY(panel_->row("roughness")->isVisible());
        QVERIFY(!panel_->row("morph")->isVisible());
    }

    void allParametersAreVariedAtOnceButForLockedOnes()
    {
        choose("roughness", "Exclude from randomizing");
        QCOMPARE(panel_->choices().list(PanelChoice::locked), QStringList{"sample/roughness"});
        const int count = history_->stack().count();
        const ParameterValues before = values();
        panel_->vary();
        QCOMPARE(history_->stack().count(), count + 1);
        QVERIFY(values().row(table_.roughness.row) == before.row(table_.roughness.row));
        QVERIFY(!(values().row(table_.morph.row) == before.row(table_.morph.row)));
        QVERIFY(!(values().row(table_.base.row) == before.row(table_.base.row)));
        QVERIFY2(values().row(table_.tolerance.row) == before.row(table_.tolerance.row), "accuracy is no look");
        const ParameterValues first = values();
        panel_->vary();
        QVERIFY2(!(values() == first), "the next seed");
        history_->stack().undo();
        QVERIFY(values() == first);
        history_->stack().undo();
        QVERIFY(values() == before);

        // Locks a whole group, and unlocks all of it.
        choose("morph", "Lock the group");
        panel_->vary();
        QVERIFY(values().row(table_.tube.row) == before.row(table_.tube.row));
        QVERIFY(!(values().row(table_.base.row) == before.row(table_.base.row)));
        choose("morph", "Unlock the group");
        choose("roughness", "Unlock");
        QVERIFY(panel_->choices().list(PanelChoice::locked).isEmpty());
        panel_->vary();
        QVERIFY(!(values().row(table_.roughness.row) == before.row(table_.roughness.row)));
    }

    void foldedGroupsAreRemembered()
    {
        auto* heading = panel_->findChildren<SectionHeading*>().at(1);
        QTest::mouseClick(heading, Qt::LeftButton);
        QCOMPARE(panel_->choices().list(PanelChoice::toggled), QStringList{"sample/Surface"});
        ParameterPanel other(*history_);
        keepChoices(other);
        other.showExhibit(0, "sample");
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
            for (const QWidget* w = widget; w && w != panel_.get(); w = w->parentWidget())
                tip = tip || !w->toolTip().isEmpty();
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
        panel_->findChild<QToolButton*>("", Qt::FindDirectChildrenOnly)->setFocus();
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
        for (const char* part :
             {"Radius of the torus's tube.", "1 to 200", "mm", "Initial value: 12", "tubeRadius", "Shift"})
            QVERIFY2(tip.contains(QLatin1String(part)), part);
    }

    void valuesAreCopiedAndPasted()
    {
        type("roughness", "0.1234567890123");
        QMetaObject::invokeMethod(panel_->row("roughness"), [&] {
            QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5},
                                    panel_->row("roughness")->mapToGlobal(QPoint(5, 5)));
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
        QVERIFY2(row->toolTip().startsWith(QStringLiteral("Not used now; only used when “Set sun by” is hour.")),
                 qPrintable(row->toolTip()));
        QCOMPARE(row->accessibleDescription(),
                 QStringLiteral("Not used now; only used when “Set sun by” is hour. Its value is kept."));
        QVERIFY(ink(row) < 0.7 * ink(panel_->row("sunHeight")));
        type("hourOfDay", "9.5");
        QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("hourOfDay"))), 9.5);
        auto* choice = in<QComboBox>("sunBy");
        choice->setFocus();
        QTest::keyClick(choice, Qt::Key_Down);
        QVERIFY(!row->idle());
        QVERIFY(panel_->row("sunHeight")->idle());
        QCOMPARE(std::get<double>(panel_->values().row(*idle_.find("hourOfDay"))), 9.5);
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
        QVERIFY(panel_->row("sunHeight")->toolTip().contains(QStringLiteral("Range: 0 to 1")));
    }

    void aLongLabelTakesSeveralLines()
    {
        ParameterRow* row = panel_->row("roughness");
        auto* label = row->findChild<RowLabel*>();
        const int before = row->height();
        QVERIFY(label->isWhole());
        label->setText("The name of a parameter that is too long for a line");
        QVERIFY(!label->isWhole());
        panel_->resize(panel_->width() + 1, panel_->height());  // The row adapts when it is laid out.
        QTRY_VERIFY(label->isWhole());
        QVERIFY(row->height() > before);
        QTRY_COMPARE(panel_->row("material")->y(), row->y() + row->height());
        label->setText("Short");
        panel_->resize(panel_->width() + 1, panel_->height());
        QTRY_COMPARE(row->height(), before);
    }

    void aWordThatIsTooLongForALineIsBrokenBetweenSyllables()
    {
        for (const char* parts : {"Schat|ten|ver|fah|ren", "Volu|men|schritte", "Dreh|ge|schwin|dig|keit",
                                  "Rück|kopp|lung", "Bild|raum", "Occ|lu|sion", "Hash", "Strahl|stärke"}) {
            const QString word = QString::fromUtf8(parts);
            QCOMPARE(withSoftHyphens(QString(word).remove('|')).replace(softHyphen, '|'), word);
        }
        auto* label = panel_->row("roughness")->findChild<RowLabel*>();
        label->setText("Geschwindigkeitsverteilung");
        panel_->resize(panel_->width() + 1, panel_->height());
        QTRY_VERIFY(label->isWhole());
    }

    void anEmptyFileSaysWhatIsUsedInstead()
    {
        struct Table final : Parameters {
            File own = file("own", "A scene.", inAssetFolder("scenes"));
            File shown = file("shown", "A scene.", mustBeGiven());
            File other = file("other", "A picture.");
        };
        const Table table;
        QStringList words;
        for (const ParameterInfo& parameter : table.rows()) words << shownText(parameter, std::string());
        QCOMPARE(words, (QStringList{"the exhibit's own", "as shown", "none"}));
        QCOMPARE(in<QLineEdit>("environment")->placeholderText(), QString("none"));
    }

    void essentialsComeFirstAndTheOthersAreFoldedByGroup()
    {
        showEssentialTable();
        // The group "Color" is left out: its only parameter is essential.
        QCOMPARE(headings(), QStringList({"Essentials", "Display", "Screen space", "Air"}));
        QCOMPARE(visibleRows(), QStringList({"technique", "airDensity", "tint"}));
        const auto label = [&](const char* row) { return panel_->row(row)->findChild<RowLabel*>()->text(); };
        QCOMPARE(label("airDensity"), QStringLiteral("Air density"));
        QCOMPARE(label("airFalloff"), QStringLiteral("Falloff"));
        QVERIFY(panel_->choices().list(PanelChoice::toggled).isEmpty());

        QTest::mouseClick(heading("Air"), Qt::LeftButton);
        QVERIFY(panel_->row("airFalloff")->isVisible());
        ParameterPanel other(*history_);
        keepChoices(other);
        other.showExhibit(0, "sample");
        other.show();
        QVERIFY2(other.row("airFalloff")->isVisible() && !other.row("angle")->isVisible(), "remembered");
    }

    void aGroupWithoutEffectSaysSoOnceAndItsButtonGivesItOne()
    {
        showEssentialTable();
        const auto said = [&] {
            QStringList words;
            for (const QLabel* line : panel_->findChildren<QLabel*>())
                if (line->isVisible() && line->text().contains(QStringLiteral("only used when"))) words << line->text();
            return words;
        };
        QCOMPARE(said(), QStringList{"No effect now; only used when “Technique” is screen space."});
        QVERIFY(heading("Screen space")->accessibleDescription().startsWith(QStringLiteral("No effect now")));
        QPushButton* act = nullptr;
        for (auto* button : panel_->findChildren<QPushButton*>())
            if (button->isVisible()) act = button;
        QVERIFY(act);
        QCOMPARE(act->text(), QStringLiteral("Set “Technique” to screen space"));
        act->setFocus();
        QTest::keyClick(act, Qt::Key_Space);
        QVERIFY(said().isEmpty());
        QCOMPARE(history_->stack().count(), 1);
        QVERIFY(!panel_->row("decay")->idle());
        history_->stack().undo();
        QCOMPARE(said().size(), 1);
    }

    void pinnedRowsAreShownUnderTheEssentialsAndAreRemembered()
    {
        showEssentialTable();
        QVERIFY(panel_->reveal("airFalloff"));
        QVERIFY(panel_->row("airFalloff")->isAncestorOf(QApplication::focusWidget()));
        panel_->pinFocused();
        QCOMPARE(headings(), QStringList({"Essentials", "Pinned", "Display", "Screen space"}));
        QCOMPARE(visibleRows(), QStringList({"technique", "airDensity", "tint", "airFalloff"}));
        QVERIFY2(panel_->row("airFalloff")->isAncestorOf(QApplication::focusWidget()), "the focus stays");
        type("airFalloff", "0.75");
        QCOMPARE(std::get<double>(panel_->values().row(*essentials_.find("airFalloff"))), 0.75);

        ParameterPanel other(*history_);
        keepChoices(other);
        other.showExhibit(0, "sample");
        other.show();
        QVERIFY(other.row("airFalloff")->isVisible());
        // An essential parameter needs no pin, and a table without essentials has none.
        QVERIFY(!panel_->mayPin(*essentials_.find("tint")));
        choose("airFalloff", "Unpin");
        QCOMPARE(headings(), QStringList({"Essentials", "Display", "Screen space", "Air"}));
        open();
        QVERIFY(!panel_->mayPin(0));
    }

    void aParameterIsShownWhereverItIs()
    {
        showEssentialTable();
        panel_->findChild<QToolButton*>("", Qt::FindDirectChildrenOnly)->click();  // Only changed ones.
        QVERIFY(visibleRows().isEmpty());
        QVERIFY(panel_->reveal("weight"));
        QVERIFY(panel_->row("weight")->isVisible());
        QVERIFY(panel_->row("weight")->isAncestorOf(QApplication::focusWidget()));
        QVERIFY(!panel_->reveal("noSuchParameter"));
    }

    void allGroupsAreFoldedAndUnfoldedAtOnce()
    {
        showEssentialTable();
        emit panel_->menus().foldingAsked(false);
        QCOMPARE(visibleRows().size(), static_cast<qsizetype>(essentials_.rows().size()));
        emit panel_->menus().foldingAsked(true);
        QCOMPARE(visibleRows(), QStringList({"technique", "airDensity", "tint"}));
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
        QCOMPARE(values()[table_.stepLimit], 96);  // Values that are not in the text become initial, as for presets.
        QCOMPARE(history_->stack().count(), before + 1);
        const ParameterValues kept = values();
        QApplication::clipboard()->setText("a poem");
        choose("roughness", "Paste");
        QVERIFY2(QToolTip::text().contains(QStringLiteral("\"a poem\" is not a value of “Roughness”")),
                 qPrintable(QToolTip::text()));
        choose("roughness", "Paste all");
        QVERIFY2(QToolTip::text().contains(QStringLiteral("the clipboard")), qPrintable(QToolTip::text()));
        QVERIFY(values() == kept);
    }

    void slidersHaveRoomAtTheDefaultWidth()
    {
        QVERIFY2(slider("roughness")->width() >= 100, qPrintable(QString::number(slider("roughness")->width())));
        QVERIFY(field("stepLimit")->width() >= 64);
        const int start = slider("roughness")->mapTo(panel_.get(), QPoint()).x();
        for (const char* row : {"speed", "stepLimit", "exposure"})
            QCOMPARE(slider(row)->mapTo(panel_.get(), QPoint()).x(), start);
        panel_->resize(600, 400);
        QCoreApplication::processEvents();
        QVERIFY(panel_->row("roughness")->findChild<RowLabel*>()->width() > 160);
        QCOMPARE(slider("speed")->mapTo(panel_.get(), QPoint()).x(),
                 slider("roughness")->mapTo(panel_.get(), QPoint()).x());
    }

    void fieldsStandOutInBothThemes()
    {
        // WCAG 2.2, 1.4.11: 3:1 for edges of controls; contrast by the formula of 1.4.3.
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
            QVERIFY2(contrast(seen.pixelColor(seen.width() / 2, 0), each.window) > 2,
                     "the edge of a number is drawn");  // It is antialiased.
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

VITRINE_UI_TEST(ParameterPanelTest)

#include "parameter_panel_test.moc"
