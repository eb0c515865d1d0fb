#include "tests/ui/open_window.h"
#include "tests/ui/ui_main.h"

#include "ui/kit/message_strip.h"
#include "ui/kit/theme.h"
#include "ui/presets/preset_controller.h"
#include "ui/report/frame_graph.h"
#include "ui/report/log_view.h"
#include "ui/window/file_opener.h"

#include <QClipboard>
#include <QToolButton>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

using namespace vitrine;
using namespace vitrine::ui;

/// Messages of the window: message strip, log, problems over the picture.
class WindowMessagesTest : public test::OpenWindow {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { start(); }
    void cleanup() { finish(); }

    void longAShaderProblemIsShownOverThePicture()
    {
        gallery_->shaderProblems = {{"sdf_morph/march.frag", 42, "'hitDistance' : undeclared identifier"}};
        window_->viewport().shaders().reload();
        const auto shown = [&] {
            const auto labels = window_->viewport().findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
                return label->isVisible() && label->text().contains("sdf_morph/march.frag:42");
            });
        };
        QTRY_VERIFY(shown());
    }

    void messagesStayUntilDismissedAndAreListedOnce()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        window_->say(MessageStrip::Mood::problem, "<b>not bold</b>");
        window_->say(MessageStrip::Mood::problem, "<b>not bold</b>");
        QCOMPARE(strip->texts(), QStringList{"<b>not bold</b>"});
        for (QLabel* label : strip->findChildren<QLabel*>()) QCOMPARE(label->textFormat(), Qt::PlainText);
        strip->dismissAll();
        QTRY_VERIFY(!strip->isVisible());
    }

    void messagesLieOverThePictureAndNoticesOfOneKindBecomeOne()
    {
        settle();
        auto* strip = window_->findChild<MessageStrip*>();
        const QSize before = window_->viewport().size();
        const long long drawn = window_->viewport().pictures().shown().pictures();
        for (int i = 1; i <= 4; ++i)
            window_->say(MessageStrip::Mood::notice, QString("Screenshot saved to %1.png.").arg(i),
                         "%1 screenshots saved, the last one to %2.", QString("%1.png").arg(i));
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        QCOMPARE(strip->texts(), (QStringList{"The disk is full.", "4 screenshots saved, the last one to 4.png."}));
        QTRY_VERIFY(strip->isVisible());
        QTest::qWait(100);
        QCOMPARE(window_->viewport().size(), before);
        QCOMPARE(window_->viewport().pictures().shown().pictures(),
                 drawn);  // The same picture: nothing has to be refined again.
        QCOMPARE(strip->mapToGlobal(QPoint(0, 0)), window_->viewport().mapToGlobal(QPoint(0, 0)));
        QCOMPARE(strip->width(), window_->viewport().width());
    }

    void theNewestMessageIsInSightAndAllCanBeClosedAtOnce()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        const auto lineOf = [&](const QString& text) -> QWidget* {
            for (QLabel* label : strip->findChildren<QLabel*>())
                if (label->text() == text) return label;
            return nullptr;
        };
        for (int i = 1; i <= 7; ++i) {
            const QString text = QString("File %1 is bad.").arg(i);
            window_->say(MessageStrip::Mood::problem, text);
            QCOMPARE(strip->texts().front(), text);
            QTRY_VERIFY(!lineOf(text)->visibleRegion().isEmpty());
        }
        window_->say(MessageStrip::Mood::problem, "File 2 is bad.");  // Once more.
        QCOMPARE(strip->texts().front(), QString("File 2 is bad."));
        QCOMPARE(strip->texts().size(), 7);
        QToolButton* all = nullptr;
        for (QToolButton* button : strip->findChildren<QToolButton*>())
            if (button->text() == "Close all") all = button;
        QVERIFY(all && all->isVisible());
        QTest::mouseClick(all, Qt::LeftButton);
        QTRY_VERIFY(strip->texts().isEmpty() && !strip->isVisible());
    }

    void problemsLeaveWithTheirCause()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        window_->setProblems("a", {"One.", "Two."});
        window_->setProblems("b", {"Three."});
        QCOMPARE(strip->texts(), (QStringList{"Three.", "Two.", "One."}));
        window_->setProblems("a", {"Two.", "Four."});
        QCOMPARE(strip->texts(), (QStringList{"Four.", "Three.", "Two."}));
        window_->setProblems("b", {});
        window_->setProblems("a", {});
        QVERIFY(strip->texts().isEmpty());
        // A bad file that is opened again after it was corrected.
        const QString path = home_->filePath("some.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{") == 1);
        file.close();
        window_->files().open(path);
        QTRY_COMPARE(strip->texts().size(), 1);
        window_->presetController().saveUnder("Mended");
        QVERIFY(QFile::remove(path));
        QVERIFY(QFile::copy(rowsNamed("Mended").front()->data(Qt::UserRole).toString(), path));
        window_->files().open(path);
        QTRY_VERIFY2(strip->texts().isEmpty(), qPrintable(strip->texts().join(' ')));
    }

    void noticesGoByThemselvesAndProblemsStay()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        QCursor::setPos(window_->mapToGlobal(window_->rect().bottomRight() -
                                             QPoint(5, 5)));  // Not on the strip, where notices stay.
        strip->setNoticeTime(50);
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        window_->say(MessageStrip::Mood::notice, "Saved.");
        QTRY_COMPARE(strip->texts(), QStringList{"The disk is full."});
        QTest::qWait(300);
        QCOMPARE(strip->texts(), QStringList{"The disk is full."});
    }

    void onlyAMessageAboutAFileShowsItInItsFolder()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        const auto offered = [&] {
            int count = 0;
            for (const QToolButton* button : strip->findChildren<QToolButton*>())
                count += button->text() == "Show in folder" && button->isVisible();
            return count;
        };
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        QTRY_VERIFY(strip->isVisible());
        QCOMPARE(offered(), 0);
        window_->say(MessageStrip::Mood::notice, "Saved to a.png.", {}, {}, "/tmp/a.png");
        QTRY_COMPARE(offered(), 1);
    }

    void longWhoGoesToAnExhibitReadsItWhileItsPictureIsDrawn()
    {
        std::atomic<bool> may = false;
        gallery_->beforeDrawing = [&may](const FrameRequest&, const auto&) {
            while (!may) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        };
        const auto shown = [this] {
            for (const QLabel* label : window_->viewport().findChildren<QLabel*>())
                if (label->text() == QString::fromUtf8("Going to Torus to mug …")) return label->isVisible();
            return false;
        };
        QVERIFY(!shown());
        window_->visit(1);
        const bool said = shown();
        QTest::qWait(50);
        const bool still = shown();
        may = true;
        settle();
        gallery_->beforeDrawing = nullptr;
        QVERIFY(said && still);
        QTRY_VERIFY(!shown());
    }

    void aClockThatStandsSaysSo()
    {
        QAbstractButton* clock = nullptr;
        for (auto* button : window_->findChildren<QAbstractButton*>())
            if (button->accessibleName() == "Stop or start the clock") clock = button;
        QVERIFY(clock);
        settle();
        QTRY_COMPARE(clock->text(), QString("Waits"));
        QVERIFY(clock->toolTip().contains("nothing shown is moving"));
        gallery_->exhibit().moves = true;
        window_->viewport().scene().change();
        QTRY_COMPARE(clock->text(), QString("Pause"));
        clock->click();
        QCOMPARE(clock->text(), QString("Play"));
        clock->click();
        QTRY_COMPARE(clock->text(), QString("Pause"));
        gallery_->exhibit().moves = false;
        QTRY_COMPARE(clock->text(), QString("Waits"));
    }

    void pathsBelowTheHomeFolderAreShortAndCopiedWhole()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        const QString home = home_->path();
        const QString text = QString("Saved %1/a.png, not /disk%1/a.png or %1nn/a.png.").arg(home);
        window_->say(MessageStrip::Mood::notice, text);
        const QString shortened = QString("Saved ~/a.png, not /disk%1/a.png or %1nn/a.png.").arg(home);
        QLabel* shown = nullptr;
        for (QLabel* label : strip->findChildren<QLabel*>())
            if (label->text() == shortened) shown = label;
        QVERIFY(shown);
        QVERIFY(shown->toolTip().contains(home + "/a.png"));
        for (QToolButton* button : shown->parentWidget()->findChildren<QToolButton*>())
            if (button->text() == "Copy") QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(QApplication::clipboard()->text(), text);
        QCOMPARE(strip->texts(), QStringList{text});
    }

    void theFrameGraphTellsTheShortestTheMedianAndTheLongest()
    {
        FrameGraph graph;
        QCOMPARE(graph.summary(), QString("No frame has been drawn yet."));
        for (const double milliseconds : {12.0, 100.0, 14.0}) graph.add(milliseconds);
        graph.add(std::numeric_limits<double>::quiet_NaN());
        QCOMPARE(graph.summary(), QString("3 frames: 12.0 to 100.0 ms, half of them up to 14.0 ms"));
        const QImage seen = graph.grab().toImage();
        const auto high = [&](int fromRight) {
            int count = 0;
            const int x = seen.width() - 2 * fromRight;
            for (int y = 0; y < seen.height(); ++y) count += seen.pixelColor(x, y) == theme().dim;
            return count;
        };
        QVERIFY(high(2) > 4 * high(1));
        for (int i = 0; i < 80; ++i) graph.add(20);
        QCOMPARE(graph.summary(), QString("60 frames: 20.0 to 20.0 ms, half of them up to 20.0 ms"));
    }

    void theBarePictureHidesMessages()
    {
        auto* strip = window_->findChild<MessageStrip*>();
        window_->say(MessageStrip::Mood::problem, "The disk is full.");
        QTRY_VERIFY(strip->isVisible());
        window_->hidePanels(true);
        QVERIFY(!strip->isVisible());
        window_->say(MessageStrip::Mood::problem, "The other disk, too.");
        QVERIFY(!strip->isVisible());
        window_->hidePanels(false);
        QVERIFY(strip->isVisible());
        QCOMPARE(strip->texts().size(), 2);
    }

    void longBadInputIsOneLineInTheLogHoweverManyFramesItLasts()
    {
        window_->viewport().pictures().setLimits(asTheHallRequests, 0);
        window_->choose(1);
        const auto lines = [&] {
            return window_->findChild<LogView*>()->toPlainText().count(
                QStringLiteral("fur/clock: the time is no number"));
        };
        bool up = true;
        const auto drawFrames = [&](std::vector<render::CulledPass> complaints) {
            gallery_->complaints = std::move(complaints);
            const auto before = gallery_->requests().size();
            dragRoughness(up ? 60 : 20);
            up = !up;
            QTRY_VERIFY(gallery_->requests().size() > before + 2);
            settle();
        };
        const render::CulledPass wrong{.name = "fur/clock",
                                       .reason = "the time is no number",
                                       .work = render::Work::simulation,
                                       .complaint = true};
        drawFrames({});
        QCOMPARE(lines(), 0);
        drawFrames({wrong});
        drawFrames({wrong});
        QCOMPARE(lines(), 1);
        drawFrames({});
        drawFrames({wrong});
        QCOMPARE(lines(), 2);
    }
};

VITRINE_UI_TEST(WindowMessagesTest)

#include "window_messages_test.moc"
