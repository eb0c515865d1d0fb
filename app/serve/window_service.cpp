#include "app/serve/window_service.h"

#include "app/serve/server.h"
#include "app/serve/service.h"
#include "ui/window/main_window.h"
#include "ui/window/serving_bar.h"

#include <QStatusBar>

#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>

namespace vitrine::app {
namespace {

/// Seconds without a request after which a connection is closed for a new one if all places are taken.
constexpr std::chrono::duration<double> mayIdle{60};

}  // namespace

/// Request of the window that the server ends.
class StopEvent {
public:
    StopEvent() : event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
    void ask()
    {
        asked_ = true;
        const std::uint64_t one = 1;
        (void)!::write(event_.get(), &one, sizeof one);
    }
    [[nodiscard]] ServerStop stop() const
    {
        return {[this] { return asked_.load(); }, event_.get()};
    }

private:
    render::Descriptor event_;
    std::atomic<bool> asked_ = false;
};

WindowService::WindowService(std::string path)
    : listener_(std::make_unique<Listener>(std::move(path))), stop_(std::make_unique<StopEvent>())
{
}

WindowService::~WindowService()
{
    stop();
    if (thread_.joinable()) thread_.join();
}

void WindowService::serve(ui::MainWindow& window)
{
    const QString path = QString::fromStdString(listener_->path());
    state_ = std::make_unique<WindowState>(window.history(), [&window](std::size_t subject) { window.visit(subject); });
    bar_ = new ui::ServingBar(path);
    window.statusBar()->addPermanentWidget(bar_);
    QObject::connect(bar_, &ui::ServingBar::stopAsked, &window, [this, &window] {
        stop();
        window.say(ui::MessageStrip::Mood::notice, QObject::tr("The service of this window has ended."));
    });
    window.say(ui::MessageStrip::Mood::notice,
               QObject::tr("Other programs can read and change the values of this window, until you choose “Stop "
                           "serving” in the status line."));
    thread_ = std::thread([this, &window] { run(window); });
}

void WindowService::run(ui::MainWindow& window)
{
    const std::unique_ptr<Listener> listener = std::move(listener_);
    const auto tell = [&window](const std::string& why) {
        QMetaObject::invokeMethod(
            &window, [&window, why] { window.say(ui::MessageStrip::Mood::problem, QString::fromStdString(why)); });
    };
    try {
        ServedGraphics graphics;
        Service service(window.museum(), *state_, graphics);
        Server(*listener, service, mayIdle, stop_->stop()).run();
    } catch (const RpcFailure&) {
        return;  // The window ended it.
    } catch (const std::exception& error) {
        tell(error.what());
    }
}

void WindowService::stop()
{
    stop_->ask();
    if (state_) state_->end();
    if (bar_) bar_->deleteLater();
}

}  // namespace vitrine::app
