// Random mouse and keyboard events on the real window: it stays open, goes on answering, and gives its memory back.
//   VITRINE_INPUT_SECONDS=600   how long, in seconds; 60 without it
//   VITRINE_INPUT_SEED=1        seed of the events; a failure names it
#include "tests/ui/ui_main.h"

#include "exhibits/exhibits.h"
#include "exhibits/museum/museum.h"
#include "render/measure/memory.h"
#include "tests/support/environment_number.h"
#include "tests/ui/test_home.h"
#include "ui/compare/compare_controller.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/theme.h"
#include "ui/viewport/gl_probe.h"
#include "ui/viewport/museum_renderers.h"
#include "ui/viewport/viewport.h"
#include "ui/window/application.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_dialogs.h"
#include "ui/window/window_docks.h"

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <future>
#include <memory>
#include <random>

using namespace vitrine;
using namespace vitrine::ui;

namespace {

/// Sends random events, also into dialogs that wait for an answer: it is called by a timer, which runs within them.
class RandomInput final : public QObject {
public:
    RandomInput(MainWindow& window, unsigned seed) : window_(window), random_(seed) {}

    void start() { stepLater(); }
    void stop() { stopped_ = true; }
    [[nodiscard]] int steps() const { return steps_; }
    /// Returns the longest time between two steps in milliseconds: the window did not answer for that long.
    [[nodiscard]] qint64 longestPause() const { return longestPause_; }

private:
    [[nodiscard]] int limit(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
    template <typename Values> [[nodiscard]] auto oneOf(const Values& values)
    {
        return *(std::begin(values) + limit(static_cast<int>(std::size(values)) - 1));
    }

    /// Returns the window that takes input now: the open menu, the dialog that waits, another dialog or the main
    /// window.
    [[nodiscard]] QWidget* target()
    {
        if (QWidget* popup = QApplication::activePopupWidget()) return popup;
        if (QWidget* modal = QApplication::activeModalWidget()) return modal;
        QWidgetList open{&window_};
        for (QWidget* top : QApplication::topLevelWidgets())
            if (top->isVisible() && top != &window_ && top->isWindow() && !top->isHidden()) open << top;
        return oneOf(open);
    }

    /// A new timer for each step, because Qt's timers do not run again within their own slot, where a menu may wait.
    void stepLater() { QTimer::singleShot(30, this, &RandomInput::step); }

    void step()
    {
        if (stopped_) return;
        stepLater();
        if (since_.isValid()) longestPause_ = std::max(longestPause_, since_.elapsed());
        ++steps_;
        QWidget* top = target();
        // A dialog for files could reach files of the system; one for colors takes the pointer from the whole screen.
        if (qobject_cast<QFileDialog*>(top) || steps_ % 50 == 0) {
            QTest::keyClick(top, Qt::Key_Escape);
        } else if (const int kind = limit(9); kind < 5) {
            click(*top);
        } else if (kind < 8) {
            type(*top);
        } else {
            drag(*top);
        }
        since_.start();
    }

    [[nodiscard]] QWidget* widgetAt(QWidget& top, QPoint* at)
    {
        *at = {limit(std::max(0, top.width() - 1)), limit(std::max(0, top.height() - 1))};
        QWidget* child = top.childAt(*at);
        if (!child) return &top;
        *at = child->mapFrom(&top, *at);
        return child;
    }
    void click(QWidget& top)
    {
        QPoint at;
        const QPointer<QWidget> widget = widgetAt(top, &at);
        QTest::mouseMove(widget, at);
        const Qt::MouseButton button = limit(9) == 0 ? Qt::RightButton : Qt::LeftButton;
        if (widget && limit(14) == 0) QTest::mouseDClick(widget, button, {}, at);
        if (widget) QTest::mouseClick(widget, button, {}, at);
    }
    void drag(QWidget& top)
    {
        QPoint at;
        const QPointer<QWidget> widget = widgetAt(top, &at);
        QTest::mousePress(widget, Qt::LeftButton, {}, at);
        for (int i = 0; i < 5 && widget; ++i) {
            at += QPoint(limit(60) - 30, limit(60) - 30);
            QTest::mouseMove(widget, at);
        }
        if (widget) QTest::mouseRelease(widget, Qt::LeftButton, {}, at);
    }
    void type(QWidget& top)
    {
        static constexpr std::array keys{
            Qt::Key_Tab,  Qt::Key_Backtab, Qt::Key_Up,     Qt::Key_Down,     Qt::Key_Left,        Qt::Key_Right,
            Qt::Key_Home, Qt::Key_End,     Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Space,       Qt::Key_Return,
            Qt::Key_W,    Qt::Key_A,       Qt::Key_S,      Qt::Key_D,        Qt::Key_E,           Qt::Key_B,
            Qt::Key_1,    Qt::Key_7,       Qt::Key_Minus,  Qt::Key_Comma,    Qt::Key_BracketLeft, Qt::Key_BracketRight,
            Qt::Key_F4,   Qt::Key_F11,     Qt::Key_Delete, Qt::Key_Backspace};
        static constexpr std::array controls{Qt::Key_Z, Qt::Key_Y, Qt::Key_F, Qt::Key_W,
                                             Qt::Key_C, Qt::Key_V, Qt::Key_B};
        QWidget* focus = QApplication::focusWidget();
        if (!focus || !top.isAncestorOf(focus)) focus = &top;
        if (limit(4) == 0)
            QTest::keyClick(focus, oneOf(controls), Qt::ControlModifier);
        else
            QTest::keyClick(focus, oneOf(keys));
    }

    MainWindow& window_;
    std::mt19937 random_;
    bool stopped_ = false;
    QElapsedTimer since_;
    int steps_ = 0;
    qint64 longestPause_ = 0;
};

}  // namespace

class RandomInputTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> home_;
    std::unique_ptr<Museum> museum_;
    std::unique_ptr<MuseumRenderers> renderers_;
    std::unique_ptr<MainWindow> window_;

    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(window_->viewport().pictures().schedule().still(), vitrine::test::patience);
    }
    [[nodiscard]] static double ownMegabytes()
    {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        render::trimHeap();
        return double(render::processMemory().own) / 1e6;
    }
    [[nodiscard]] QAction& quitAction()
    {
        for (QAction* action : window_->findChildren<QAction*>())
            if (action->shortcut() == QKeySequence(Qt::CTRL | Qt::Key_Q)) return *action;
        throw std::logic_error("the window has no command that quits");
    }
    /// Visits every exhibit, so that what each of them needs is there.
    void visitAll()
    {
        for (std::size_t i = 0; i < museum_->subjects().size(); ++i) {
            window_->visit(i);
            settle();
        }
        window_->visit(0);
        settle();
    }
    /// Returns what the renderers keep, as a line of names, counts and sizes.
    [[nodiscard]] QString kept()
    {
        std::promise<std::vector<render::gl::Stored>> stored;
        window_->viewport().renderThread().post([&] {
            stored.set_value(renderers_->stored());
            return std::function<void()>();
        });
        QStringList parts;
        for (const render::gl::Stored& s : stored.get_future().get())
            parts << QStringLiteral("%1 %2 (%3 MB)")
                         .arg(QString::fromStdString(s.what))
                         .arg(s.count)
                         .arg(double(s.bytes) / 1e6, 0, 'f', 1);
        return parts.join(QStringLiteral(", "));
    }
    /// Closes everything and goes back to the initial values at the entrance.
    void tidy()
    {
        while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
        window_->lessons().leave();
        window_->dialogs().closeAll();
        for (QWidget* top : QApplication::topLevelWidgets())
            if (top != window_.get() && top->isVisible()) top->close();
        window_->docks().study().stop();
        window_->comparison().letGo();
        window_->showNormal();
        window_->resize(1000, 640);
        window_->hidePanels(false);
        window_->history().change(QStringLiteral("Reset"), museum_->initialSceneState());
        window_->viewport().clock().setPaused(false);
        window_->history().stack().clear();
        window_->visit(0);
    }

private slots:
    void initTestCase()
    {
        render::returnFreedMemory();
        std::setlocale(LC_NUMERIC, "C");
        applyTheme(*qApp, darkTheme());
        QVERIFY2(whyNoOpenGl().isEmpty(), qPrintable(whyNoOpenGl()));
        home_ = vitrine::test::newHome(vitrine::test::ProgramCaches::shared);
        museum_ = std::make_unique<Museum>(allExhibits());
        renderers_ = std::make_unique<MuseumRenderers>(*museum_);
        window_ = std::make_unique<MainWindow>(*museum_, *renderers_, makeWindowActions);
        window_->viewport().pictures().setLimits(2, 0);
        window_->resize(1000, 640);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get(), vitrine::test::patience));
    }

    void theWindowAnswersAndStaysOpen()
    {
        visitAll();
        const double before = ownMegabytes();
        const QString keptBefore = kept();
        const auto seed = static_cast<unsigned>(vitrine::test::environmentNumber("VITRINE_INPUT_SEED", 1));
        quitAction().setEnabled(false);  // The driver would end the test with it.
        RandomInput input(*window_, seed);
        input.start();
        QElapsedTimer time;
        time.start();
        const auto seconds = static_cast<qint64>(vitrine::test::environmentNumber("VITRINE_INPUT_SECONDS", 60));
        double most = before;
        while (time.elapsed() < seconds * 1000) {
            QTest::qWait(500);
            most = std::max(most, double(render::processMemory().own) / 1e6);
            QVERIFY2(window_->isVisible(), qPrintable(QStringLiteral("closed by seed %1").arg(seed)));
        }
        input.stop();
        tidy();
        visitAll();           // The same walk as before, so that both measure the same pictures.
        QTest::qWait(40000);  // After half a minute without a picture, what is unused is freed.
        const double after = ownMegabytes();
        qInfo(
            "seed %u: %d events in %lld s, own memory %.0f MB before, %.0f at most, %.0f after; longest pause %lld ms",
            seed, input.steps(), static_cast<long long>(seconds), before, most, after,
            static_cast<long long>(input.longestPause()));
        qInfo("kept before: %s\nkept after: %s", qPrintable(keptBefore), qPrintable(kept()));
        QVERIFY(input.steps() > seconds);
        QVERIFY2(input.longestPause() < 10000, qPrintable(QStringLiteral("%1 ms").arg(input.longestPause())));
        // Caches of what was opened may stay, but memory comes back after its peaks.
        QVERIFY2(after <= 1.3 * before,
                 qPrintable(QStringLiteral("seed %1: %2 MB after %3 MB, which is %4 times as much")
                                .arg(seed)
                                .arg(after, 0, 'f', 0)
                                .arg(before, 0, 'f', 0)
                                .arg(after / before, 0, 'f', 2)));
    }

    void cleanupTestCase()
    {
        window_->close();
        window_.reset();
    }
};

VITRINE_WINDOW_TEST(RandomInputTest)

#include "random_input_test.moc"
