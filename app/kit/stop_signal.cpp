#include "app/kit/stop_signal.h"

#include "render/files/unfinished.h"

#include <pthread.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <thread>

namespace vitrine::app {
namespace {

std::mutex stopMutex;  ///< Guards the two following variables.
int orderly = 0;       ///< Number of StopSignals that exist.
int stopEvent = -1;    ///< Descriptor that wakes waiting threads.
std::atomic<bool> stopAsked = false;

/// Requests an orderly stop. Returns false if there is no StopSignal, or the stop was requested before.
bool askToStop()
{
    const std::lock_guard lock(stopMutex);
    if (orderly == 0 || stopAsked.exchange(true)) return false;
    const std::uint64_t one = 1;
    if (::write(stopEvent, &one, sizeof one) < 0) ::perror("vitrine");
    return true;
}

[[noreturn]] void waitForStop(const sigset_t& awaited)
{
    for (;;) {
        int signal = 0;
        if (::sigwait(&awaited, &signal) != 0 || askToStop()) continue;
        render::removeUnfinished();
        std::fputs(isatty(STDERR_FILENO) == 1 ? "\r\033[Kvitrine: Stopped.\n" : "vitrine: Stopped.\n", stderr);
        ::_exit(StopSignal::exitCode);
    }
}

}  // namespace

void endOnStopSignals()
{
    static std::once_flag once;
    std::call_once(once, [] {
        sigset_t awaited;
        sigemptyset(&awaited);
        sigaddset(&awaited, SIGINT);
        sigaddset(&awaited, SIGTERM);
        // Shells start background programs with SIGINT ignored. If it is sent all the same, it must work.
        ::signal(SIGINT, SIG_DFL);
        ::pthread_sigmask(SIG_BLOCK, &awaited, nullptr);
        std::thread([awaited] { waitForStop(awaited); }).detach();
    });
}

StopSignal::StopSignal()
{
    const std::lock_guard lock(stopMutex);
    if (orderly++ > 0) return;
    stopAsked = false;
    stopEvent = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
}

StopSignal::~StopSignal()
{
    const std::lock_guard lock(stopMutex);
    if (--orderly > 0) return;
    if (stopEvent >= 0) ::close(stopEvent);
    stopEvent = -1;
}

int StopSignal::descriptor()
{
    return stopEvent;
}

bool StopSignal::stopped()
{
    return stopAsked;
}

}  // namespace vitrine::app
