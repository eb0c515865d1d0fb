#pragma once

#include "ui/kit/appearance.h"
#include "ui/kit/desktop_preferences.h"
#include "ui/kit/preferences.h"
#include "ui/preferences/key_bindings.h"

#include <QObject>

#include <memory>

namespace vitrine::ui {

class MainWindow;
struct WindowCommands;

/// Applies the preferences of the visitor and the desktop to the window.
class WindowPreferences final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object.
    explicit WindowPreferences(MainWindow&);

    [[nodiscard]] Preferences& values() { return preferences_; }
    /// Applies the preferences and follows their changes. Call once the window's parts exist.
    void follow(const WindowCommands&);
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
    bool held_ = false;  // The clock was stopped because of reduced motion, and not changed since.
};

}  // namespace vitrine::ui
