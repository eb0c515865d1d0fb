#include "tests/ui/painted_gallery.h"
#include "tests/ui/ui_main.h"

#include "render/failure.h"
#include "render/files/strict_json.h"
#include "tests/ui/test_home.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/theme.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/file_opener.h"
#include "ui/window/main_window.h"
#include "ui/window/session_keeper.h"
#include "ui/window/window_actions.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QMenuBar>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>

#include <clocale>
#include <memory>
#include <new>
#include <stdexcept>

using namespace vitrine;
using namespace vitrine::ui;

/// Errors that the window survives, and restored sessions, over a gallery whose picture has one color.
class KeptWorkTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<test::PaintedGallery> gallery_;
    std::unique_ptr<MainWindow> window_;

    void openWindow()
    {
        gallery_ = std::make_unique<test::PaintedGallery>();
        window_ = std::make_unique<MainWindow>(gallery_->museum(), *gallery_, makeWindowActions);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), vitrine::test::patience));
        connect(static_cast<Application*>(qApp), &Application::caught, window_.get(),
                [this](const QString& message) { window_->say(MessageStrip::Mood::problem, message); });
    }
    void closeWindow()
    {
        window_->close();
        window_.reset();
    }
    /// Simulates a crash: the written journal stays like that of a process that has ended.
    void crash(const QString& name)
    {
        const QDir folder = recovery();
        QTRY_VERIFY(!own().isEmpty());
        const QString journal = folder.filePath(own());
        QFile::remove(folder.filePath(name));
        QVERIFY(QFile::copy(journal, folder.filePath(name)));
        QFile layout(state("window.ini")), session(state("session.json"));
        QVERIFY(layout.open(QIODevice::ReadOnly));
        const QByteArray keptLayout = layout.readAll();
        const QByteArray keptSession = session.open(QIODevice::ReadOnly) ? session.readAll() : QByteArray();
        layout.close();
        session.close();
        closeWindow();
        // Restores the layout from before, because a crash does not write it.
        QVERIFY(layout.open(QIODevice::WriteOnly | QIODevice::Truncate));
        layout.write(keptLayout);
        QFile::remove(state("session.json"));
        if (keptSession.isEmpty()) return;
        QVERIFY(session.open(QIODevice::WriteOnly));
        session.write(keptSession);
    }
    static QString state(const char* name)
    {
        return QString::fromLocal8Bit(qgetenv("XDG_STATE_HOME")) + "/vitrine/" + name;
    }
    static QDir recovery() { return QDir(state("recovery")); }
    /// Returns the journal of this process.
    static QString own()
    {
        const QStringList files =
            recovery().entryList({QString::number(QCoreApplication::applicationPid()) + "-*.json"}, QDir::Files);
        return files.isEmpty() ? QString() : files.front();
    }
    static render::Json journal()
    {
        QFile file(recovery().filePath(own()));
        return file.open(QIODevice::ReadOnly) ? render::Json::parse(file.readAll().toStdString()) : render::Json();
    }
    [[nodiscard]] QStringList said() { return window_->findChild<MessageStrip*>()->texts(); }
    [[nodiscard]] double roughness() { return window_->history().sceneState().values[1][gallery_->table().roughness]; }
    void setRoughness(double value)
    {
        SceneState next = window_->history().sceneState();
        next.values[1].set(gallery_->table().roughness, value);
        window_->history().change("Roughness", std::move(next));
    }
    QDockWidget* dock(const char* name) { return window_->findChild<QDockWidget*>(name); }

private slots:
    void initTestCase()
    {
        std::setlocale(LC_NUMERIC, "C");
        applyTheme(*qApp, darkTheme());
    }
    void init()
    {
        home_ = vitrine::test::newHome(vitrine::test::ProgramCaches::none);
        openWindow();
    }
    void cleanup()
    {
        if (window_) closeWindow();
    }

    void longASecondWindowOpensOffsetFromTheFirst()
    {
        window_->setGeometry(60, 60, 800, 500);
        QTRY_COMPARE(window_->geometry(), QRect(60, 60, 800, 500));
        closeWindow();
        openWindow();
        const QPoint alone = window_->pos();
        closeWindow();
        // Another process with its own journal.
        QProcess other;
        other.start("sleep", {"100"});
        QVERIFY(other.waitForStarted());
        QFile stat(QString("/proc/%1/stat").arg(other.processId()));
        QVERIFY(stat.open(QIODevice::ReadOnly));
        const QByteArray fields = stat.readAll();
        const QByteArray started = fields.mid(fields.lastIndexOf(')') + 2).split(' ').at(19);  // Field 22.
        QDir().mkpath(state("recovery"));
        QFile journal(recovery().filePath(QString("%1-%2.json").arg(other.processId()).arg(QString(started))));
        QVERIFY(journal.open(QIODevice::WriteOnly));
        journal.close();
        openWindow();
        QCOMPARE(window_->pos() - alone, QPoint(32, 32));
        other.kill();
        other.waitForFinished();
    }

    void whatATimerOrASlotThrowsIsSaidAndTheProgramGoesOn()
    {
        QTimer::singleShot(0, window_.get(),
                           [] { throw Failure(ErrorKind::file, "Cannot read gone.hdr: there is no such file."); });
        QTRY_VERIFY(said().contains("Cannot read gone.hdr: there is no such file."));
        auto* action = new QAction(window_.get());
        connect(action, &QAction::triggered, window_.get(), [] { throw std::runtime_error("the slot broke"); });
        QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
        QTRY_VERIFY(said().join(' ').contains("the slot broke"));
        QMetaObject::invokeMethod(
            window_.get(), [] { throw std::bad_alloc(); }, Qt::QueuedConnection);
        QTRY_VERIFY(said().join(' ').contains("not enough memory"));
        QMetaObject::invokeMethod(
            window_.get(), [] { throw 7; }, Qt::QueuedConnection);
        QTRY_COMPARE(said().size(), 4);
        QVERIFY(!said().join(' ').contains("std::"));
        // The window continues to work.
        const long long before = window_->viewport().pictures().shown().pictures();
        setRoughness(0.7);
        QTRY_VERIFY(window_->viewport().pictures().shown().pictures() > before);
    }

    void whatDrawingThrowsIsSaidAndTheNextPictureIsDrawn()
    {
        gallery_->thrown = std::make_exception_ptr(std::bad_alloc());
        setRoughness(0.7);
        QTRY_VERIFY(said().join(' ').contains("not enough memory"));
        gallery_->thrown = nullptr;
        const long long before = window_->viewport().pictures().shown().pictures();
        setRoughness(0.3);
        QTRY_VERIFY(window_->viewport().pictures().shown().pictures() > before);
    }

    void theBarePictureIsLeftByTabAfterARestart()
    {
        window_->choose(1);
        window_->hidePanels(true);
        QVERIFY(!dock("parameters")->isVisible());
        QVERIFY(!window_->menuBar()->isVisible());
        closeWindow();
        openWindow();
        QVERIFY(window_->menuBar()->isVisible());
        for (const char* name : {"parameters", "exhibits", "presets"}) QVERIFY2(dock(name)->isVisible(), name);
        QVERIFY(!dock("frame-report")->isVisible());
    }

    void withEveryPanelClosedTabStillTakesTheMenuAwayAndBringsItBack()
    {
        for (QDockWidget* each : window_->findChildren<QDockWidget*>()) each->hide();
        window_->hidePanels(true);
        QVERIFY(!window_->menuBar()->isVisible());
        window_->hidePanels(false);
        QVERIFY(window_->menuBar()->isVisible());
        QVERIFY(!dock("parameters")->isVisible());
    }

    void longASecondCrashRightAfterARecoveryLosesNothing()
    {
        window_->choose(1);
        setRoughness(0.61);
        dock("presets")->hide();
        crash("999999999-1.json");
        openWindow();
        QCOMPARE(roughness(), 0.61);
        QVERIFY(said().contains("Vitrine crashed or was stopped; your last state was restored."));
        QCOMPARE(window_->chosen(), std::size_t{1});
        QVERIFY(!dock("presets")->isVisible());
        // Immediately, without a change or an idle time.
        QVERIFY(!own().isEmpty());
        QVERIFY(!recovery().exists("999999999-1.json"));
        crash("999999998-1.json");
        openWindow();
        QCOMPARE(roughness(), 0.61);
        QVERIFY(said().contains("Vitrine crashed or was stopped; your last state was restored."));
    }

    void longWhereTheVisitorWalkedIsInTheJournal()
    {
        render::Camera there;
        there.eye = {0.625, 1.5, 3.25};
        window_->viewport().visitor().jumpTo(there);
        QTRY_VERIFY(!own().isEmpty());
        QTRY_COMPARE(journal()["camera"]["eye"], (render::Json{0.625, 1.5, 3.25}));
    }

    void longTheJournalWaitsForNoPauseBetweenEdits()
    {
        // Each edit comes before the journal of the one before would be written.
        int edits = 0;
        for (; own().isEmpty() && edits < 8; ++edits) {
            setRoughness(0.3 + 0.01 * edits);
            QTest::qWait(500);
        }
        QVERIFY2(edits < 8, "two seconds after the first one it is due");
    }

    void longASessionThatCannotBeReadIsKept()
    {
        const QByteArray newer = R"({"format": "vitrine-exhibition", "version": 99, "name": "Last session"})";
        for (const QByteArray& text : {newer, QByteArray("{ half a sess")}) {
            closeWindow();
            QFile session(state("session.json"));
            QVERIFY(session.open(QIODevice::WriteOnly | QIODevice::Truncate));
            session.write(text);
            session.close();
            QFile::remove(state("aside-session.json"));
            openWindow();
            QVERIFY2(said().join(' ').contains("aside-session.json"), qPrintable(said().join(' ')));
            closeWindow();
            QFile kept(state("aside-session.json"));
            QVERIFY(kept.open(QIODevice::ReadOnly));
            QCOMPARE(kept.readAll(), text);
            openWindow();  // Restores the session written since then.
            QVERIFY2(!said().join(' ').contains("aside"), qPrintable(said().join(' ')));
        }
    }

    void whatASessionSaysOfUnknownThingsIsNamedAndKept()
    {
        closeWindow();
        QFile session(state("session.json"));
        QVERIFY(session.open(QIODevice::ReadWrite));
        render::Json text = render::Json::parse(session.readAll().toStdString());
        text["values"]["hall.velvetRope"] = 3;
        text["values"]["tapestry.threads"] = 400;
        session.resize(0);
        session.seek(0);
        session.write(QByteArray::fromStdString(render::writeJson(text)));
        session.close();
        openWindow();
        const QString all = said().join(' ');
        for (const char* name : {"hall.velvetRope", "tapestry.threads", "aside-session.json"})
            QVERIFY2(all.contains(name), qPrintable(all));
        QVERIFY(QFile::exists(state("aside-session.json")));
    }

    void longAStateThatCrashesAgainAndAgainIsPutAsideAndNotLost()
    {
        setRoughness(0.61);
        for (int i = 0; i < 3; ++i) {
            crash(QString("99999999%1-1.json").arg(9 - i));
            openWindow();
            QCOMPARE(roughness(), 0.61);
        }
        crash("999999990-1.json");
        openWindow();
        QCOMPARE(roughness(), 0.25);  // The initial value.
        const QStringList aside = recovery().entryList({"aside-*"}, QDir::Files);
        QCOMPARE(aside.size(), 1);
        QVERIFY2(said().join(' ').contains(aside.front()), qPrintable(said().join(' ')));
        window_->files().open(recovery().filePath(aside.front()));
        QCOMPARE(roughness(), 0.61);
    }
};

VITRINE_WINDOW_TEST(KeptWorkTest)

#include "kept_work_test.moc"
