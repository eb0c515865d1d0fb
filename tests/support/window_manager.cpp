#include "tests/support/window_manager.h"

#include <X11/Xatom.h>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vitrine::test {
namespace {

XErrorHandler usualHandler = nullptr;

/// Ignores requests about windows that are gone: other programs close theirs at any time.
int ignoreGoneWindows(Display* display, XErrorEvent* error)
{
    return error->error_code == BadWindow ? 0 : usualHandler(display, error);
}

}  // namespace

WindowManager::WindowManager(Display& display) : display_(display)
{
    usualHandler = XSetErrorHandler(ignoreGoneWindows);
    // Names and meanings are those of the Extended Window Manager Hints (freedesktop.org).
    const auto runs = [this] { return !listed("_NET_SUPPORTING_WM_CHECK", XA_WINDOW).empty(); };
    if (runs()) return;
    started_ = ::fork();
    if (started_ == 0) {
        ::dup2(STDERR_FILENO, STDOUT_FILENO);  // Its messages are not the program's output.
        ::execlp("openbox", "openbox", nullptr);
        ::_exit(127);
    }
    constexpr int attempts = 100;
    constexpr useconds_t betweenThem = 100000;
    for (int i = 0; i < attempts && started_ > 0; ++i, ::usleep(betweenThem)) {
        if (runs()) return;
        if (::waitpid(started_, nullptr, WNOHANG) == started_) started_ = 0;
    }
    problem_ = "the display has no window manager, and openbox could not be started; install it (Debian: openbox), or "
               "start another one.";
}

WindowManager::~WindowManager()
{
    XSetErrorHandler(usualHandler);
    if (started_ <= 0) return;
    ::kill(started_, SIGTERM);
    ::waitpid(started_, nullptr, 0);
}

std::vector<Window> WindowManager::listed(const char* property, Atom type) const
{
    constexpr long most = 1024;
    Atom actual = None;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* data = nullptr;
    XGetWindowProperty(&display_, DefaultRootWindow(&display_), XInternAtom(&display_, property, False), 0, most, False,
                       type, &actual, &format, &count, &left, &data);
    std::vector<Window> windows;
    if (data && format == 32) {
        const auto* first = reinterpret_cast<const Window*>(data);  // Xlib gives items of 32 bits as longs.
        windows.assign(first, first + count);
    }
    if (data) XFree(data);
    return windows;
}

std::vector<Window> WindowManager::windows() const
{
    return listed("_NET_CLIENT_LIST", XA_WINDOW);
}

void WindowManager::send(Window window, const char* message, long first, long second) const
{
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(&display_, message, False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = first;
    event.xclient.data.l[1] = second;
    XSendEvent(&display_, DefaultRootWindow(&display_), False, SubstructureNotifyMask | SubstructureRedirectMask,
               &event);
    XSync(&display_, False);
}

void WindowManager::fill(Window window) const
{
    constexpr long add = 1;
    send(window, "_NET_WM_STATE", add, static_cast<long>(XInternAtom(&display_, "_NET_WM_STATE_FULLSCREEN", False)));
}

void WindowManager::activate(Window window) const
{
    constexpr long byPager = 2;  // A window manager may refuse it to a program, but not to the user.
    send(window, "_NET_ACTIVE_WINDOW", byPager, CurrentTime);
}

}  // namespace vitrine::test
