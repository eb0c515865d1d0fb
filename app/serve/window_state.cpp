#include "app/serve/window_state.h"

#include "app/serve/json_rpc.h"
#include "ui/model/history.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <utility>

namespace vitrine::app {
namespace {

/// Least time between two notices of changes by the visitor, in milliseconds.
constexpr int noticePause = 100;

}  // namespace

struct WindowState::Gate {
    std::mutex mutex;
    std::condition_variable turned;
    bool ended = false;
};

WindowState::WindowState(ui::History& history, std::function<void(std::size_t)> visit)
    : history_(history), changes_(history), visit_(std::move(visit)), gate_(std::make_shared<Gate>()),
      changed_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
{
    soon_.setSingleShot(true);
    soon_.setInterval(noticePause);
    QObject::connect(&soon_, &QTimer::timeout, &here_, [this] {
        const std::uint64_t one = 1;
        (void)!::write(changed_.get(), &one, sizeof one);
    });
    QObject::connect(&history_, &ui::History::changesSettled, &here_, [this] {
        if (!soon_.isActive()) soon_.start();
    });
}

WindowState::~WindowState()
{
    end();
}

void WindowState::end()
{
    const std::lock_guard lock(gate_->mutex);
    gate_->ended = true;
    gate_->turned.notify_all();
}

void WindowState::call(const std::function<void()>& function)
{
    struct Made {
        bool done = false;
        std::exception_ptr error;
    };
    const auto made = std::make_shared<Made>();
    // After the end, this function has returned and `function` is gone. Both happen on the window's thread, so that
    // `ended` cannot change during the call.
    const auto carryOut = [gate = gate_, made, &function] {
        {
            const std::lock_guard lock(gate->mutex);
            if (gate->ended) return;
        }
        try {
            function();
        } catch (...) {
            made->error = std::current_exception();
        }
        const std::lock_guard lock(gate->mutex);
        made->done = true;
        gate->turned.notify_all();
    };
    std::unique_lock lock(gate_->mutex);
    if (!gate_->ended) QMetaObject::invokeMethod(&here_, carryOut, Qt::QueuedConnection);
    gate_->turned.wait(lock, [&] { return gate_->ended || made->done; });
    if (!made->done) throw RpcFailure(RpcCode::canceled, "The window has stopped serving.");
    if (made->error) std::rethrow_exception(made->error);
}

SceneState WindowState::current()
{
    SceneState state;
    call([&] { state = history_.sceneState(); });
    return state;
}

void WindowState::change(const SceneState& before, const SceneState& after)
{
    call([&] { changes_.make(before, after); });
}

void WindowState::visit(std::size_t subject, const render::Camera&)
{
    call([&] { visit_(subject); });
}

void WindowState::takeChanged()
{
    std::uint64_t count = 0;
    (void)!::read(changed_.get(), &count, sizeof count);
}

}  // namespace vitrine::app
