#include "ui/window/window_preferences.h"

#include "ui/preferences/preferences_dialog.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_input.h"
#include "ui/window/main_window.h"
#include "ui/window/recent_files.h"
#include "ui/window/window_commands.h"

#include <QAction>

#include <limits>

namespace vitrine::ui {

WindowPreferences::WindowPreferences(MainWindow& window)
    : QObject(&window), window_(window), appearance_(preferences_, portal_)
{
}

void WindowPreferences::follow(const WindowCommands& commands)
{
    keys_ = std::make_unique<KeyBindings>(commands.all, preferences_);
    pause_ = commands.pause;
    connect(&preferences_, &Preferences::changed, this, &WindowPreferences::apply);
    connect(&preferences_, &Preferences::notWritten, this,
            [this](const QString& why) { window_.say(MessageStrip::Mood::problem, why); });
    connect(&appearance_, &Appearance::applied, this, &WindowPreferences::applyMotion);
    connect(pause_, &QAction::toggled, this, [this] { held_ = false; });
    // A visitor who presses a button wants to see its effect.
    connect(&window_.viewport().interaction(), &Interaction::pressed, this, [this] {
        if (held_) holdClock(false);
    });
    apply();
    applyMotion();
    if (!preferences_.complaint().isEmpty()) window_.say(MessageStrip::Mood::problem, preferences_.complaint());
}

void WindowPreferences::apply()
{
    const PreferenceValues& values = preferences_.values();
    window_.viewport().input().setHandling({values.lookSpeed / 100.0, values.wheelSpeed / 100.0, values.invertedLook});
    const bool limited = values.mostSamples < PreferenceValues::sampleLimits.most;
    window_.viewport().pictures().setLimits(limited ? values.mostSamples : std::numeric_limits<int>::max(),
                                            values.leastScale / 100.0);
    keepRecentFiles(values.recentFiles);
}

void WindowPreferences::applyMotion()
{
    const bool reduced = appearance_.reducesMotion();
    if (reduced == reduced_) return;
    reduced_ = reduced;
    window_.viewport().visitor().control().setCutting(reduced);
    window_.setAnimated(!reduced);
    if (reduced ? !pause_->isChecked() : held_) holdClock(reduced);
}

void WindowPreferences::holdClock(bool stands)
{
    pause_->setChecked(stands);
    held_ = stands;
}

void WindowPreferences::openDialog()
{
    auto* dialog = window_.findChild<PreferencesDialog*>();
    if (!dialog) {
        dialog = new PreferencesDialog(preferences_, *keys_, &window_);
        connect(dialog, &PreferencesDialog::forgetRecentAsked, this, [] { keepRecentFiles(0); });
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
}

}  // namespace vitrine::ui

#include "moc_window_preferences.cpp"
