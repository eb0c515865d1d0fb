#pragma once

#include <X11/Xlib.h>

#include <sys/types.h>

#include <string>
#include <vector>

namespace vitrine::test {

/// Window manager of a display, without which windows get no keys: the one that runs there, or an openbox that ends
/// with this object.
class WindowManager {
public:
    /// Starts openbox if the display, which must outlive this object, has no window manager. Waits for it for at most
    /// 10 s.
    explicit WindowManager(Display&);
    ~WindowManager();
    WindowManager(const WindowManager&) = delete;
    WindowManager& operator=(const WindowManager&) = delete;

    /// Returns why there is none, and what to do; empty if there is one.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Returns the windows of programs, the oldest first.
    [[nodiscard]] std::vector<Window> windows() const;
    /// Lets the window cover the screen, without a frame.
    void fill(Window) const;
    /// Raises the window and gives it the keyboard.
    void activate(Window) const;

private:
    [[nodiscard]] std::vector<Window> listed(const char* property, Atom type) const;
    void send(Window, const char* message, long first, long second) const;

    Display& display_;
    pid_t started_ = 0;  ///< The openbox that was started; 0: none.
    std::string problem_;
};

}  // namespace vitrine::test
