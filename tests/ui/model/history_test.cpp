#include "exhibits/framework/files/table_change.h"
#include "tests/support/balls.h"
#include "tests/support/blocks.h"
#include "tests/ui/sample_tables.h"
#include "tests/ui/ui_main.h"

#include "ui/model/history.h"
#include "ui/model/outside_changes.h"

#include <QSignalSpy>
#include <QTest>

#include <memory>
#include <optional>
#include <random>
#include <set>
#include <vector>

using namespace vitrine;
using namespace vitrine::ui;
using vitrine::test::parameterOf;

class HistoryTest : public QObject {
    Q_OBJECT

    const test::SampleTable table_{};
    struct BlockRows {
        std::size_t file, document;
    };
    [[nodiscard]] SceneState start() const { return {{table_.initial()}, {}}; }
    [[nodiscard]] static SceneState with(SceneState sceneState, Real parameter, double value)
    {
        sceneState.values[0].set(parameter, value);
        return sceneState;
    }

private slots:
    void anotherFileTakesItsDocumentWithItInOneStep()
    {
        const test::BlocksExhibit blocks;
        const BlockRows rows{blocks.parameters().pile.row, blocks.parameters().document.row};
        SceneState look{{blocks.parameters().initial()}, {}};
        look.values[0].setParameter(rows.file, std::string("a.json"));
        look.values[0].setParameter(rows.document, std::string("edited"));
        History history(look);
        history.set(0, rows.file, std::string("b.json"), 0);
        QCOMPARE(history.stack().count(), 1);
        QCOMPARE(history.sceneState().values[0].row(rows.document), Value(std::string()));
        history.stack().undo();
        QVERIFY(history.sceneState() == look);
        // Writing a document to its file is no step, and undo restores the earlier picture.
        history.set(0, rows.document, std::string("edited twice"), 0);
        SceneState saved = history.sceneState();
        saved.values[0].setParameter(rows.document, std::string());
        history.settle(saved);
        QCOMPARE(history.stack().count(), 1);
        QVERIFY(history.sceneState() == saved);
        history.stack().undo();
        QCOMPARE(history.sceneState().values[0].row(rows.document), Value(std::string("edited")));
        history.stack().redo();
        QCOMPARE(history.sceneState().values[0].row(rows.document), Value(std::string("edited twice")));
    }

    void oneGestureIsOneStep()
    {
        History history(start());
        const Gesture drag = newGesture();
        for (int i = 1; i <= 20; ++i)
            history.change("Change roughness", with(history.sceneState(), table_.roughness, i / 20.0), drag);
        history.change("Change roughness", with(history.sceneState(), table_.roughness, 0.3), newGesture());
        QCOMPARE(history.stack().count(), 2);
        history.stack().undo();
        QCOMPARE(history.sceneState().values[0][table_.roughness], 1.0);
        history.stack().undo();
        QVERIFY(history.sceneState() == start());
        QCOMPARE(history.stack().redoText(), QString("Change roughness"));
        history.stack().redo();
        QCOMPARE(history.sceneState().values[0][table_.roughness], 1.0);
    }

    void aChangeFromOutsideKeepsWhatWasSetMeanwhile()
    {
        History history(start());
        OutsideChanges outside(history);
        const SceneState before = history.sceneState();
        history.set(0, table_.roughness.row, 0.75, 0);
        outside.make(before, with(before, table_.morph, 0.25));
        QCOMPARE(history.sceneState().values[0][table_.morph], 0.25);
        QCOMPARE(history.sceneState().values[0][table_.roughness], 0.75);
        QCOMPARE(history.stack().count(), 2);
        QCOMPARE(history.stack().undoText(), QStringLiteral("Change morph by the service"));
        history.stack().undo();
        QCOMPARE(history.sceneState().values[0][table_.morph], 0.5);
        QCOMPARE(history.sceneState().values[0][table_.roughness], 0.75);
        outside.make(before, before);
        QCOMPARE(history.stack().index(), 1);
    }

    void changesFromOutsideThatFollowSoonAreOneStep()
    {
        History history(start());
        OutsideChanges outside(history);
        const auto make = [&](Real parameter, double value) {
            const SceneState now = history.sceneState();
            outside.make(now, with(now, parameter, value));
        };
        for (const double value : {0.1, 0.2, 0.3}) make(table_.morph, value);
        QCOMPARE(history.stack().count(), 1);
        make(table_.roughness, 0.5);
        QCOMPARE(history.stack().count(), 2);
        // An edit in the window is a step of its own, and so is what follows it.
        history.set(0, table_.roughness.row, 0.6, newGesture());
        make(table_.roughness, 0.7);
        QCOMPARE(history.stack().count(), 4);
        QTest::qWait(OutsideChanges::sameStep + 100);
        make(table_.roughness, 0.8);
        QCOMPARE(history.stack().count(), 5);
    }

    void oneValueThatChangesIsNamedAndOnlyThat()
    {
        History history(start());
        const std::size_t row = *table_.find("roughness");
        QSignalSpy changed(&history, &History::changed);
        QSignalSpy replaced(&history, &History::replaced);
        const Gesture drag = newGesture();
        for (const double value : {0.3, 0.4, 0.4, 7.0}) history.set(0, row, value, drag);
        QCOMPARE(changed.count(), 3);
        QCOMPARE(history.sceneState().values[0][table_.roughness], 1.0);  // The nearest legal value.
        QCOMPARE(history.stack().count(), 1);
        QCOMPARE(history.stack().undoText(), QString("Change roughness"));
        history.stack().undo();
        QVERIFY(history.sceneState() == start());
        QCOMPARE(changed.count(), 4);
        for (const QList<QVariant>& signal : changed) {
            QCOMPARE(signal[0].value<std::size_t>(), std::size_t{0});
            QCOMPARE(signal[1].value<std::size_t>(), row);
        }
        history.set(0, row, std::string("a path"), newGesture());
        QVERIFY(history.sceneState() == start());
        QCOMPARE(replaced.count(), 0);
        history.change("Load", with(with(start(), table_.roughness, 0.1), table_.morph, 0.9));
        history.stack().undo();
        QCOMPARE(replaced.count(), 2);
        QCOMPARE(changed.count(), 4);
    }

    void aWatcherHearsOfItsExhibitAloneUntilItsOwnerIsDestroyed()
    {
        const SceneState two{{table_.initial(), table_.initial()}, {}};
        History history(two);
        const std::size_t row = *table_.find("roughness");
        std::vector<std::optional<std::size_t>> heard;
        auto owner = std::make_unique<QObject>();
        const auto note = [&heard](std::optional<std::size_t> changed) { heard.push_back(changed); };
        history.watch(1, owner.get(), note);
        history.set(0, row, 0.4, newGesture());
        QVERIFY2(heard.empty(), "another exhibit changed");
        history.set(1, row, 0.4, newGesture());
        SceneState both = history.sceneState();
        for (ParameterValues& values : both.values) values.set(table_.morph, 0.9);
        history.change("Both", both);
        history.stack().undo();
        SceneState first = history.sceneState();
        first.values[0].set(table_.morph, 0.8);
        first.camera.eye = {1, 2, 3};
        history.change("The first, and the camera", first, 0, History::Camera::moves);
        using Heard = std::vector<std::optional<std::size_t>>;
        QVERIFY(heard == (Heard{row, std::nullopt, std::nullopt}));
        history.restart(two);
        QCOMPARE(heard.size(), std::size_t{4});
        owner.reset();
        history.set(1, row, 0.5, newGesture());
        QCOMPARE(heard.size(), std::size_t{4});
    }

    void aConnectionOfAWatcherCanBeEnded()
    {
        History history(start());
        int heard = 0;
        QMetaObject::Connection watched = history.watch(0, &history, [&heard](auto) { ++heard; });
        history.set(0, *table_.find("roughness"), 0.4, newGesture());
        QObject::disconnect(watched);
        history.set(0, *table_.find("roughness"), 0.5, newGesture());
        QCOMPARE(heard, 1);
    }

    void manyChangesSettleOnceInTheNextTurnOfTheEventLoop()
    {
        History history({{table_.initial(), table_.initial(), table_.initial()}, {}});
        const std::size_t row = *table_.find("roughness");
        QSignalSpy changed(&history, &History::changed), settled(&history, &History::changesSettled);
        const Gesture drag = newGesture();
        for (int i = 1; i <= 60; ++i) history.set(2, row, i / 100.0, drag);
        history.set(0, row, 0.5, newGesture());
        QCOMPARE(changed.count(), 61);
        QCOMPARE(settled.count(), 0);
        QCoreApplication::processEvents();
        QCOMPARE(settled.count(), 1);
        QVERIFY(settled[0][0].value<std::set<std::size_t>>() == (std::set<std::size_t>{0, 2}));
        QCoreApplication::processEvents();
        QCOMPARE(settled.count(), 1);
        history.record(
            "Delete preset", [] {}, [] {});
        history.stack().undo();
        QCoreApplication::processEvents();
        QCOMPARE(settled.count(), 2);
        QVERIFY(settled[1][0].value<std::set<std::size_t>>().empty());
    }

    void aChangeMadeWhileChangesSettleIsReportedInTheTurnAfter()
    {
        History history(start());
        QSignalSpy settled(&history, &History::changesSettled);
        const auto answer = [&] {
            if (settled.count() < 2) history.set(0, *table_.find("morph"), 0.75, newGesture());
        };
        connect(&history, &History::changesSettled, &history, answer);
        history.set(0, *table_.find("roughness"), 0.4, newGesture());
        QTRY_COMPARE(settled.count(), 2);
        QTest::qWait(20);
        QCOMPARE(settled.count(), 2);
    }

    void editsWithoutAGestureNeverMerge()
    {
        History history(start());
        history.change("Load a", with(history.sceneState(), table_.roughness, 0.1));
        history.change("Load b", with(history.sceneState(), table_.roughness, 0.2));
        QCOMPARE(history.stack().count(), 2);
    }

    void theValuesOfAnyStepCanBeAskedForWithoutGoingThere()
    {
        History history(start());
        history.change("a", with(history.sceneState(), table_.roughness, 0.1));
        history.change("b", with(history.sceneState(), table_.morph, 0.9));
        const SceneState both = history.sceneState();
        history.stack().undo();
        QSignalSpy changed(&history, &History::changed), replaced(&history, &History::replaced);
        QVERIFY(history.valuesAt(0).values == start().values);
        QVERIFY(history.valuesAt(1).values == history.sceneState().values);
        QVERIFY2(history.valuesAt(2).values == both.values, "a step that is undone");
        QVERIFY(!(history.valuesAt(2).values == history.sceneState().values));
        QCOMPARE(changed.count() + replaced.count(), 0);
        QCOMPARE(history.stack().index(), 1);
    }

    void aDragThatComesBackIsNoStep()
    {
        History history(start());
        const Gesture drag = newGesture();
        history.change("Change morph", with(history.sceneState(), table_.morph, 0.9), drag);
        history.change("Change morph", start(), drag);
        QCOMPARE(history.stack().count(), 0);
        history.change("Nothing", start());
        QCOMPARE(history.stack().count(), 0);
    }

    void walkingIsNoStepAndUndoLeavesTheVisitorWhereHeIs()
    {
        History history(start());
        history.change("Change morph", with(history.sceneState(), table_.morph, 0.9));
        render::Camera elsewhere;
        elsewhere.eye = {3, 1.65, 2};
        history.setCamera(elsewhere);
        QSignalSpy moved(&history, &History::cameraMoved);
        history.stack().undo();
        QVERIFY(history.sceneState().camera == elsewhere);
        QCOMPARE(moved.count(), 0);
    }

    void aPresetThatMovesTheCameraTakesItBack()
    {
        History history(start());
        SceneState preset = with(start(), table_.morph, 0.9);
        preset.camera.eye = {1, 2, 3};
        history.change("Load", preset, 0, History::Camera::moves);
        QVERIFY(history.sceneState().camera == preset.camera);
        QSignalSpy moved(&history, &History::cameraMoved);
        history.stack().undo();
        QVERIFY(history.sceneState() == start());
        QCOMPARE(moved.count(), 1);
    }

    void otherStepsRunAtOnceAndBothWays()
    {
        History history(start());
        int there = 1;
        history.record(
            "Delete preset", [&] { there = 0; }, [&] { there = 1; });
        QCOMPARE(there, 0);
        history.stack().undo();
        QCOMPARE(there, 1);
        history.stack().redo();
        QCOMPARE(there, 0);
    }

    void tenThousandRandomStepsAgreeWithAPlainList()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> value(0, 1);
        History history(start());
        std::vector<SceneState> all{start()};
        std::size_t at = 0;
        for (int i = 0; i < 10000; ++i) {
            switch (random() % 4) {
            case 0:
                if (at > 0) --at;
                history.stack().undo();
                break;
            case 1:
                if (at + 1 < all.size()) ++at;
                history.stack().redo();
                break;
            default: {
                const SceneState next =
                    with(history.sceneState(), random() % 2 ? table_.morph : table_.roughness, value(random));
                history.change("Change", next, newGesture());
                all.resize(at + 1);
                all.push_back(next);
                ++at;
            }
            }
            QVERIFY(history.sceneState() == all[at]);
        }
        while (history.stack().canUndo()) history.stack().undo();
        QVERIFY(history.sceneState() == start());
    }

    // Tables given by a file:

    void tablesThatAreReadBelongToTheStepThatNamedTheirFile()
    {
        const test::BallTable none({});
        const auto two = std::make_shared<const test::BallTable>(std::vector<test::Ball>{{"red", 0.5}, {"blue", 2}});
        const auto other = std::make_shared<const test::BallTable>(std::vector<test::Ball>{{"blue", 1}});
        History history({{none.initial()}, {}});
        const std::size_t scene = *none.find("scene");
        const auto named = [&](const char* file, const std::shared_ptr<const test::BallTable>& table) {
            history.set(0, scene, std::string(file), newGesture());
            SceneState tabled = history.sceneState();
            std::vector<std::string> notes;
            tabled.values[0] = underTable(tabled.values[0], table, notes);
            history.exchangeTables(tabled);
        };
        named("two.json", two);
        QCOMPARE(history.stack().count(), 1);
        history.set(0, *two->find("redRadius"), 3.0, newGesture());
        history.set(0, *two->find("blueRadius"), 4.0, newGesture());
        named("other.json", other);
        QCOMPARE(history.stack().count(), 4);
        QVERIFY(!parameterOf(history.sceneState().values[0], "redRadius"));
        QCOMPARE(parameterOf(history.sceneState().values[0], "blueRadius").value(), Value(4.0));

        history.stack().undo();
        QCOMPARE(parameterOf(history.sceneState().values[0], "redRadius").value(), Value(3.0));
        QCOMPARE(parameterOf(history.sceneState().values[0], "scene").value(), Value(std::string("two.json")));
        history.stack().undo();
        QCOMPARE(parameterOf(history.sceneState().values[0], "blueRadius").value(), Value(2.0));
        history.stack().undo();
        QCOMPARE(parameterOf(history.sceneState().values[0], "redRadius").value(), Value(0.5));
        history.stack().undo();
        QVERIFY(!parameterOf(history.sceneState().values[0], "redRadius"));
        QVERIFY(history.sceneState().values[0] == none.initial());
        for (int i = 0; i < 4; ++i) history.stack().redo();
        QCOMPARE(&history.sceneState().values[0].table(), static_cast<const Parameters*>(other.get()));
        QCOMPARE(parameterOf(history.sceneState().values[0], "blueRadius").value(), Value(4.0));
    }

    void aFileReadAgainLeavesOlderAndNewerStepsTheirRows()
    {
        const test::BallTable none({});
        const auto before = std::make_shared<const test::BallTable>(std::vector<test::Ball>{{"red", 0.5}, {"blue", 2}});
        const auto after = std::make_shared<const test::BallTable>(std::vector<test::Ball>{{"blue", 1}});
        SceneState start{{ParameterValues(before)}, {}};
        History history(start);
        history.set(0, *before->find("blueRadius"), 4.0, newGesture());
        history.set(0, *before->find("blueRings"), 16.0, newGesture());
        history.stack().undo();
        SceneState tabled = history.sceneState();
        tabled.values[0] = ParameterValues(after);
        history.exchangeTables(tabled);
        QCOMPARE(parameterOf(history.sceneState().values[0], "blueRadius").value(), Value(4.0));
        // The parameter of the newer step has another index now.
        QSignalSpy changed(&history, &History::changed);
        QSignalSpy replaced(&history, &History::replaced);
        history.stack().redo();
        QCOMPARE(replaced.count(), 1);  // More than one parameter changed.
        QCOMPARE(changed.count(), 0);
        QCOMPARE(parameterOf(history.sceneState().values[0], "blueRings").value(), Value(16.0));
        QCOMPARE(parameterOf(history.sceneState().values[0], "blueRadius").value(), Value(4.0));
        history.stack().undo();
        history.stack().undo();
        QVERIFY(history.sceneState() == start);
    }

    void withoutAStepTablesAreExchangedWithNothingToUndo()
    {
        const test::BallTable none({});
        const auto one = std::make_shared<const test::BallTable>(std::vector<test::Ball>{{"red", 0.5}});
        History history({{none.initial()}, {}});
        QSignalSpy replaced(&history, &History::replaced);
        history.exchangeTables({{ParameterValues(one)}, {}});
        QCOMPARE(replaced.count(), 1);
        QVERIFY(!history.stack().canUndo());
        QVERIFY(parameterOf(history.sceneState().values[0], "redRadius").has_value());
        history.exchangeTables({{ParameterValues(one)}, {}});
        QCOMPARE(replaced.count(), 1);
    }
};

VITRINE_UI_TEST(HistoryTest)

#include "history_test.moc"
