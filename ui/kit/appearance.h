#pragma once

#include "ui/kit/desktop_preferences.h"
#include "ui/kit/preferences.h"
#include "ui/kit/theme.h"

#include <QObject>

class QApplication;

namespace vitrine::ui {

/// Returns the preferred theme. If the preference follows the desktop, this is what its portal says, or else
/// `desktopIsDark`.
[[nodiscard]] Theme themeFor(const PreferenceValues&, const DesktopPreferences&, bool desktopIsDark);
/// Returns whether animations that the visitor did not start are off.
[[nodiscard]] bool reducesMotion(const PreferenceValues&, const DesktopPreferences&);

/// Applies colors, font size and motion to the whole application. The desktop's palette and font are those of the first
/// call.
void applyAppearance(QApplication&, const PreferenceValues&, const DesktopPreferences&);
/// Returns whether motion is reduced, as applied last. While true, fading and sliding happen at once.
[[nodiscard]] bool reducedMotion();

/// Keeps the application's appearance up to date with the preferences and the desktop's settings. Does nothing before
/// either changes.
class Appearance final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    Appearance(const Preferences&, const DesktopPortal&, QObject* parent = nullptr);

    [[nodiscard]] bool reducesMotion() const
    {
        return ui::reducesMotion(preferences_.values(), portal_.desktopPreferences());
    }

signals:
    /// Emitted after colors, font size or motion may have changed.
    void applied();

private:
    void apply();

    const Preferences& preferences_;
    const DesktopPortal& portal_;
};

}  // namespace vitrine::ui
