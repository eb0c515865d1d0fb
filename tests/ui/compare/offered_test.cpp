// Comparisons that the visited exhibit offers, in the real window.

#include "tests/ui/compare/open_comparison.h"
#include "tests/ui/ui_main.h"

#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_bar.h"

#include <QMenu>

using namespace vitrine;
using namespace vitrine::ui;

class OfferedTest : public test::OpenComparison {
    Q_OBJECT

    [[nodiscard]] QAction* offer()
    {
        for (QAction* each : controller().actions().all())
            if (each && each->text() == QLatin1String("Compare with: Chalk && dust")) return each;
        return nullptr;
    }
    [[nodiscard]] QImage grabbed() { return view().grab().toImage(); }
    /// Returns whether two pictures of equal size are equal in their lower half, between two columns given as shares
    /// of the width.
    [[nodiscard]] static bool sameWithin(const QImage& a, const QImage& b, double from, double to)
    {
        if (a.size() != b.size()) return false;
        for (int y = a.height() / 2; y < a.height(); ++y)
            for (int x = static_cast<int>(from * a.width()); x < static_cast<int>(to * a.width()); ++x)
                if (a.pixel(x, y) != b.pixel(x, y)) return false;
        return true;
    }

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void theMenuListsWhatTheVisitedExhibitOffers()
    {
        QVERIFY(offer());
        QVERIFY2(!offer()->isVisible() && !offer()->isEnabled(), "nothing is visited yet");
        window_->visit(1);
        QVERIFY(offer()->isVisible() && offer()->isEnabled());
        QVERIFY(!offer()->toolTip().isEmpty());
        emit controller().actions().sources().aboutToShow();
        QVERIFY(controller().actions().sources().actions().contains(offer()));
        window_->visit(0);
        QVERIFY(!offer()->isVisible() && !offer()->isEnabled());
        emit controller().actions().sources().aboutToShow();
        QVERIFY(!controller().actions().sources().actions().contains(offer()));
    }

    void oneCommandSetsBAndAWipeOfWhichEachSideIsItsPictureToTheBit()
    {
        window_->choose(1);
        setRoughness(0.2);
        rest();
        const int steps = window_->history().stack().count();
        offer()->trigger();
        rest();
        QCOMPARE(otherRoughness(), 0.8);
        QCOMPARE(controller().other().name(), QString("Chalk & dust"));
        QVERIFY(action("Wipe")->isChecked());
        QVERIFY(controller().bar().isVisible());
        QCOMPARE(window_->history().stack().count(), steps);
        const QImage both = grabbed();
        action("Show B alone")->trigger();
        rest();
        const QImage b = grabbed();
        action("Show B alone")->trigger();
        action("A/B flicker")->trigger();  // A alone, in a picture of the same size, because the bar stays.
        rest();
        const QImage a = grabbed();
        QVERIFY(sameWithin(both, a, 0, 0.48));
        QVERIFY(sameWithin(both, b, 0.52, 1));
        QVERIFY2(!sameWithin(a, b, 0, 0.48), "a control: A and B differ");
    }

    void theLineIsDraggedInThePicture()
    {
        window_->choose(1);
        setRoughness(0.2);
        offer()->trigger();
        rest();
        dragInPicture(0.5, 0.25);
        QVERIFY(std::abs(controller().overlay().wipe() - 0.25) < 0.01);
        QVERIFY(std::abs(shownAt(0.2).red() - 51) <= 1);
        QVERIFY(std::abs(shownAt(0.3).red() - 204) <= 1);
    }

    void bFollowsWhatIsOnShowUntilItIsEditedItself()
    {
        window_->choose(1);
        setRoughness(0.2);
        offer()->trigger();
        const auto& table = gallery_->table();
        const auto otherMorph = [&] { return controller().other().sceneState().values[1][table.morph]; };
        const auto setMorph = [&](double to) { window_->history().set(1, table.morph.row, to, newGesture()); };
        setMorph(0.9);
        QCOMPARE(otherMorph(), 0.9);
        QCOMPARE(otherRoughness(), 0.8);
        QCOMPARE(controller().bar().differenceText(), QString("1 parameter differs"));
        window_->history().stack().undo();
        QCOMPARE(otherMorph(), 0.5);
        setRoughness(0.3);
        QCOMPARE(otherRoughness(), 0.8);
        // An edit of B ends following; undoing it resumes.
        setMorph(0.7);
        controller().other().give(1, "roughness");
        QCOMPARE(otherRoughness(), 0.3);
        setMorph(0.6);
        QCOMPARE(otherMorph(), 0.7);
        window_->history().stack().undo();
        window_->history().stack().undo();
        QCOMPARE(otherRoughness(), 0.8);
        setMorph(0.1);
        QCOMPARE(otherMorph(), 0.1);
        // Another B does not follow.
        action("Hold the current settings as B")->trigger();
        setMorph(0.4);
        QCOMPARE(otherMorph(), 0.1);
    }

    void whoHasItOnShowAlreadyIsTold()
    {
        window_->choose(1);
        setRoughness(0.8);
        offer()->trigger();
        QVERIFY(window_->findChild<MessageStrip*>()->texts().join(' ').contains("“Chalk & dust” is already shown"));
        QCOMPARE(controller().bar().differenceText(), QString("A and B are identical"));
    }

    void itIsInThePaletteAndCanBeSwapped()
    {
        QVERIFY(window_->findChildren<QAction*>().contains(offer()));
        window_->choose(1);
        setRoughness(0.2);
        offer()->trigger();
        rest();
        action("Swap A and B")->trigger();
        QCOMPARE(roughness(), 0.8);
        QCOMPARE(otherRoughness(), 0.2);
        window_->history().stack().undo();
        QCOMPARE(roughness(), 0.2);
        QCOMPARE(otherRoughness(), 0.8);
    }
};

VITRINE_UI_TEST(OfferedTest)

#include "offered_test.moc"
