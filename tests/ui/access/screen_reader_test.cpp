// The window as a screen reader gets it: its AT-SPI tree on a session bus of its own, queried by a script.
#include "tests/ui/access/every_part.h"
#include "tests/ui/ui_main.h"

#include "ui/compare/compare_controller.h"
#include "ui/lessons/lesson_controller.h"

#include <QAccessible>
#include <QCheckBox>
#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QToolButton>

using namespace vitrine;
using namespace vitrine::ui;

class ScreenReaderTest : public test::EveryPart {
    Q_OBJECT

    QProcess reader_;

    /// Returns the next line of the script. The window's event loop keeps running, because the script queries it.
    QJsonObject line()
    {
        QElapsedTimer time;
        time.start();
        while (!reader_.canReadLine() && reader_.state() != QProcess::NotRunning && time.elapsed() < test::patience)
            QTest::qWait(5);
        return QJsonDocument::fromJson(reader_.readLine()).object();
    }
    QJsonObject ask(QJsonObject request)
    {
        request["pid"] = QCoreApplication::applicationPid();
        reader_.write(QJsonDocument(request).toJson(QJsonDocument::Compact) + '\n');
        return line();
    }
    QJsonObject ask(const char* what, const char* name) { return ask({{"do", what}, {"name", name}}); }
    /// Asks about one panel. The whole window has thousands of parts, each of which takes a query over the bus.
    QJsonObject askIn(const char* panel, QJsonObject request)
    {
        request["within"] = panel;
        return ask(std::move(request));
    }
    bool press(const char* panel, const char* name, const QString& action = "Press")
    {
        return askIn(panel, {{"do", "press"}, {"name", name}, {"action", action}})["done"].toBool();
    }
    static QStringList strings(const QJsonValue& list)
    {
        QStringList all;
        for (const QJsonValue& each : list.toArray()) all << each.toString();
        return all;
    }

private slots:
    void initTestCase()
    {
        prepare();
        reader_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        // The libraries are installed for the system's Python, which may not be the first in PATH.
        const QString system = QStringLiteral("/usr/bin/python3");
        reader_.start(QFile::exists(system) ? system : QStringLiteral("python3"),
                      {QStringLiteral(VITRINE_SCREEN_READER)});
        const QJsonObject first = line();
        if (!first.contains("ready"))
            QSKIP(qPrintable(QString("AT-SPI cannot be asked here: %1").arg(first["missing"].toString())));
    }
    void init()
    {
        start();
        // The bridge to the bus appears shortly after the window.
        QTRY_VERIFY(!ask({{"do", "heard"}}).contains("app"));
    }
    void cleanup() { finish(); }
    void cleanupTestCase()
    {
        reader_.closeWriteChannel();
        reader_.waitForFinished();
    }

    void theWholeTreeOfEveryPanelAndDialogIsNamed()
    {
        window_->say(MessageStrip::Mood::problem, "Something went wrong.");
        window_->comparison().setToCurrent();
        QStringList complaints;
        int parts = 0;
        const auto look = [&](const QString& name, QJsonObject request) {
            request["do"] = "tree";
            const QJsonObject told = ask(request);
            if (!told.contains("roles")) complaints << name + ": is not there";
            for (const QString& each : strings(told["complaints"])) complaints << name + ": " + each;
            for (const QJsonValue& count : told["roles"].toObject()) parts += count.toInt();
        };
        const auto within = [](QWidget& part) {
            return QJsonObject{{"within", QAccessible::queryAccessibleInterface(&part)->text(QAccessible::Name)}};
        };
        look("window", {});
        forEveryDock([&](QDockWidget& dock) { look(dock.objectName(), within(dock)); });
        forEveryDialog([&](const QString& name, QWidget& dialog) {
            if (dialog.windowType() != Qt::Popup) look(name, within(dialog));  // Popups are no windows for the desktop.
        });
        complaints.removeDuplicates();
        QVERIFY2(complaints.isEmpty(), qPrintable('\n' + complaints.join('\n')));
        QVERIFY2(parts > 800, qPrintable(QString::number(parts)));
    }

    void numbersAreReadAndSetAsOneStep()
    {
        window_->choose(1);
        for (const char* name : {"Roughness", "Roughness, slider"}) {
            const QJsonObject before = askIn("Parameters", {{"do", "number"}, {"name", name}});
            QCOMPARE(before["value"].toDouble(), 0.25);
            QVERIFY(before["least"].toDouble() < 0.25 && before["most"].toDouble() >= 1);
            QVERIFY(before["step"].toDouble() > 0);
            const int steps = window_->history().stack().index();
            QVERIFY(askIn("Parameters", {{"do", "set"}, {"name", name}, {"value", 0.5}})["done"].toBool());
            QCOMPARE(roughness(), 0.5);
            QTRY_COMPARE(gallery_->drawn().values[1][gallery_->table().roughness], 0.5);
            QCOMPARE(window_->history().stack().index(), steps + 1);
            window_->history().stack().undo();
            QCOMPARE(askIn("Parameters", {{"do", "number"}, {"name", name}})["value"].toDouble(), 0.25);
        }
    }

    void buttonsSwitchesAndChoicesDoWhatTheyAreFor()
    {
        window_->choose(1);
        auto* dock = window_->findChild<QDockWidget*>("presets");
        QVERIFY(press("Presets", "Close Presets"));
        QTRY_VERIFY(!dock->isVisible());
        dragRoughness(60);
        QVERIFY(press("Parameters", "Reset Roughness"));
        QTRY_COMPARE(roughness(), 0.25);
        const auto toggled = [this] {
            return window_->history().sceneState().values[1].row(
                window_->history().sceneState().values[1].table().find("animated").value());
        };
        const Value was = toggled();
        const QJsonObject box = askIn("Parameters", {{"do", "describe"}, {"name", "Animated"}});
        QCOMPARE(box["role"].toString(), QString("check box"));
        QVERIFY(press("Parameters", "Animated", strings(box["actions"]).value(0)));
        QTRY_VERIFY(toggled() != was);
        QVERIFY(ask({{"do", "press"}, {"name", "Stop or start the clock"}, {"action", "Press"}})["done"].toBool());
        QTRY_VERIFY(window_->viewport().clock().paused());
    }

    void listsNameTheirEntriesAndPicturesSayWhatTheyShow()
    {
        const QStringList exhibits = strings(ask("entries", "Exhibits")["entries"]);
        QVERIFY2(exhibits.contains("Torus to mug") && exhibits.contains("The hall"), qPrintable(exhibits.join('|')));
        window_->choose(1);
        QVERIFY(strings(ask({{"do", "entries"}, {"name", "Presets"}, {"role", "list"}})["entries"]).size() > 1);
        QVERIFY2(ask("describe", "Museum")["description"].toString().contains("look at Torus to mug"),
                 qPrintable(ask("describe", "Museum")["description"].toString()));
    }

    void messagesAreAnnounced()
    {
        (void)ask({{"do", "heard"}});
        window_->say(MessageStrip::Mood::notice, "A picture was saved.");
        window_->say(MessageStrip::Mood::problem, "Something went wrong.");
        QStringList heard;
        QTRY_VERIFY((heard += strings(ask({{"do", "heard"}})["heard"])).contains("Something went wrong."));
        QVERIFY2(heard.contains("A picture was saved."), qPrintable(heard.join('|')));
    }

    void stepsOfALessonAreAnnounced()
    {
        QFile file(home_->filePath("lesson.md"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            "# Two settings\n\n```json\n{\"format\": \"vitrine-lesson\", \"version\": 1, \"exhibit\": "
            "\"sdf_morph\"}\n```\nWhat is **rough**?\n\n## Rough\nSee [row:roughness].\n```json\n{\"values\": "
            "{\"roughness\": 0.9}, \"read\": \"row:roughness\"}\n```\n## Smooth\nAnd now?\n```json\n{\"values\": "
            "{\"roughness\": 0.1}, \"read\": \"row:roughness\"}\n```\n");
        file.close();
        (void)ask({{"do", "heard"}});
        QStringList heard;
        const auto hear = [&] { return heard += strings(ask({{"do", "heard"}})["heard"]); };
        window_->lessons().open(file.fileName());
        QTRY_VERIFY(hear().contains("2 steps\nTwo settings\nWhat is rough?"));
        window_->lessons().nextAction().trigger();
        QTRY_VERIFY(hear().contains("Step 1 of 2\nTwo settings: Rough\nSee Roughness."));
    }
};

VITRINE_UI_TEST(ScreenReaderTest)

#include "screen_reader_test.moc"
