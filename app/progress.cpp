#include "app/progress.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>

namespace vitrine::app {
namespace {

volatile std::sig_atomic_t stopAsked = 0;
volatile std::sig_atomic_t stopEvent = -1;  ///< The descriptor that wakes who waits.

extern "C" void askToStop(int signal)
{
    const int error = errno;
    stopAsked = 1;
    const std::uint64_t one = 1;
    if (stopEvent >= 0 && ::write(stopEvent, &one, sizeof one) < 0) stopEvent = -1;
    std::signal(signal, SIG_DFL);
    errno = error;
}

/// ", 2:05 left" after so many seconds; empty where that is not known yet.
std::string timeLeft(double part, double seconds)
{
    if (!(part > 0)) return {};
    const int left = static_cast<int>(std::ceil(std::min(seconds / part * (1 - part), 359999.0)));
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), ", %d:%02d left", left / 60, left % 60);
    return text.data();
}

}  // namespace

StopSignal::StopSignal()
{
    stopAsked = 0;
    stopEvent = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    std::signal(SIGINT, askToStop);
    std::signal(SIGTERM, askToStop);
}

StopSignal::~StopSignal()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    if (stopEvent >= 0) ::close(stopEvent);
    stopEvent = -1;
}

int StopSignal::descriptor()
{
    return stopEvent;
}

bool StopSignal::stopped()
{
    return stopAsked != 0;
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), begun_(std::chrono::steady_clock::now()), shown_(begun_),
      terminal_(isatty(STDERR_FILENO) == 1)
{
}

ProgressLine::~ProgressLine()
{
    if (terminal_ && last_ >= 0) std::fputs("\r\033[K", stderr);
}

bool ProgressLine::show(double part)
{
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    const int percent = std::isfinite(part) ? static_cast<int>(100 * std::clamp(part, 0.0, 1.0)) : 0;
    const bool due = now - shown_ >= (last_ < 0 || !terminal_ ? 1000ms : 100ms);
    const bool news = terminal_ ? percent != last_ : last_ < 0 || percent / 10 != last_ / 10;
    if (due && news) {
        const std::string left = estimates_ ? timeLeft(part, std::chrono::duration<double>(now - begun_).count()) : "";
        std::fprintf(stderr, terminal_ ? "\r\033[Kvitrine: %s %d %%%s" : "vitrine: %s %d %%%s\n", what_.c_str(),
                     percent, left.c_str());
        std::fflush(stderr);
        shown_ = now;
        last_ = percent;
    }
    return !StopSignal::stopped();
}

}  // namespace vitrine::app
