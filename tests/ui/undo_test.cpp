#include "sample_tables.h"

#include "ui/window/undo.h"

#include <QSignalSpy>
#include <QTest>

#include <random>

using namespace vitrine;
using namespace vitrine::ui;

class UndoTest : public QObject {
    Q_OBJECT

    const test::SampleTable table_;
    [[nodiscard]] Look start() const { return {{table_.initial()}, {}}; }
    [[nodiscard]] static Look with(Look look, Real parameter, double value)
    {
        look.values[0].set(parameter, value);
        return look;
    }

private slots:
    void oneGestureIsOneStep()
    {
        History history(start());
        const Gesture drag = newGesture();
        for (int i = 1; i <= 20; ++i) history.change("Change roughness", with(history.look(), table_.roughness, i / 20.0), drag);
        history.change("Change roughness", with(history.look(), table_.roughness, 0.3), newGesture());
        QCOMPARE(history.stack().count(), 2);
        history.stack().undo();
        QCOMPARE(history.look().values[0][table_.roughness], 1.0);
        history.stack().undo();
        QVERIFY(history.look() == start());
        QCOMPARE(history.stack().redoText(), QString("Change roughness"));
        history.stack().redo();
        QCOMPARE(history.look().values[0][table_.roughness], 1.0);
    }

    void editsWithoutAGestureNeverMerge()
    {
        History history(start());
        history.change("Load a", with(history.look(), table_.roughness, 0.1));
        history.change("Load b", with(history.look(), table_.roughness, 0.2));
        QCOMPARE(history.stack().count(), 2);
    }

    void aDragThatComesBackIsNoStep()
    {
        History history(start());
        const Gesture drag = newGesture();
        history.change("Change morph", with(history.look(), table_.morph, 0.9), drag);
        history.change("Change morph", start(), drag);
        QCOMPARE(history.stack().count(), 0);
        history.change("Nothing", start());
        QCOMPARE(history.stack().count(), 0);
    }

    void walkingIsNoStepAndUndoLeavesTheVisitorWhereHeIs()
    {
        History history(start());
        history.change("Change morph", with(history.look(), table_.morph, 0.9));
        render::Camera elsewhere;
        elsewhere.eye = {3, 1.65, 2};
        history.setCamera(elsewhere);
        QSignalSpy moved(&history, &History::cameraMoved);
        history.stack().undo();
        QVERIFY(history.look().camera == elsewhere);
        QCOMPARE(moved.count(), 0);
    }

    void aPresetThatMovesTheCameraTakesItBack()
    {
        History history(start());
        Look preset = with(start(), table_.morph, 0.9);
        preset.camera.eye = {1, 2, 3};
        history.change("Load", preset, 0, History::Camera::moves);
        QVERIFY(history.look().camera == preset.camera);
        QSignalSpy moved(&history, &History::cameraMoved);
        history.stack().undo();
        QVERIFY(history.look() == start());
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
        std::vector<Look> all{start()};
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
                const Look next = with(history.look(), random() % 2 ? table_.morph : table_.roughness, value(random));
                history.change("Change", next, newGesture());
                all.resize(at + 1);
                all.push_back(next);
                ++at;
            }
            }
            QVERIFY(history.look() == all[at]);
        }
        while (history.stack().canUndo()) history.stack().undo();
        QVERIFY(history.look() == start());
    }
};

QTEST_APPLESS_MAIN(UndoTest)

#include "undo_test.moc"
