#pragma once

#include "app/serve/listener.h"
#include "app/serve/window_state.h"

#include <QPointer>

#include <memory>
#include <string>
#include <thread>

namespace vitrine::ui {
class MainWindow;
class ServingBar;
}  // namespace vitrine::ui

namespace vitrine::app {

class StopEvent;

/// Service of an open window: answers the methods of `vitrine serve` with the window's values, on a thread of its own.
/// Values are set as undo steps of the window. Pictures are drawn in an OpenGL context of its own, which is made for
/// the first one. The status line says that it is on, with a button that ends it.
class WindowService {
public:
    /// Listens at `path`. Throws Failure as Listener.
    explicit WindowService(std::string path);
    /// Ends the service, after the present step of a request.
    ~WindowService();

    /// Begins to serve the window, which must outlive this object.
    void serve(ui::MainWindow&);

private:
    void run(ui::MainWindow&);
    void stop();

    std::unique_ptr<Listener> listener_;  ///< Removed by the service's thread, when the last answer is sent.
    std::unique_ptr<StopEvent> stop_;
    std::unique_ptr<WindowState> state_;
    QPointer<ui::ServingBar> bar_;
    std::thread thread_;
};

}  // namespace vitrine::app
