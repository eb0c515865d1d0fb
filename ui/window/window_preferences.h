#pragma once

#include "ui/kit/appearance.h"
#include "ui/kit/desktop_wishes.h"
#include "ui/kit/preferences.h"
#include "ui/preferences/key_bindings.h"

#include <QObject>

#include <memory>

namespace vitrine::ui {

class MainWindow;
struct WindowActions;

/// What the visitor and his desktop prefer, and what the window makes of it.
class WindowPreferences final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive it.
    explicit WindowPreferences(MainWindow&);

    [[nodiscard]] Preferences& values() { return preferences_; }
    /// Once its parts are there: the window follows from now on.
    void follow(const WindowActions&);
    /// Opens the dialog, or brings it to the front.
    void openDialog();

private:
    void apply();
    void applyMotion();
    void holdClock(bool);

    MainWindow& window_;
    Preferences preferences_;
    DesktopPortal portal_;
    Appearance appearance_;
    std::unique_ptr<KeyBindings> keys_;
    QAction* pause_ = nullptr;
    bool reduced_ = false;
    bool held_ = false;  // The clock stands because of reduced motion, and nobody has touched it since.
};

}  // namespace vitrine::ui
