#include "app/kit/progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace vitrine::app {
namespace {

/// Returns the remaining time, ", 2:05 left", after `seconds` of work; empty if it is not known yet.
std::string timeLeft(double part, double seconds)
{
    if (!(part > 0)) return {};
    const int left = static_cast<int>(std::ceil(std::min(seconds / part * (1 - part), 359999.0)));
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), ", %d:%02d left", left / 60, left % 60);
    return text.data();
}

}  // namespace

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
