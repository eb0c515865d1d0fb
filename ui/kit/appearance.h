#pragma once

#include "ui/kit/desktop_wishes.h"
#include "ui/kit/preferences.h"
#include "ui/kit/theme.h"

#include <QObject>

class QApplication;

namespace vitrine::ui {

/// The theme that is chosen; of the desktop's choice, what its portal wishes, or else what its palette is.
[[nodiscard]] Theme themeFor(const PreferenceValues&, const DesktopWishes&, bool desktopIsDark);
/// Whether nothing should move that the visitor did not ask to move.
[[nodiscard]] bool reducesMotion(const PreferenceValues&, const DesktopWishes&);

/// Colors, size of type and motion of the whole application, at once. What the desktop's palette and type are is what
/// they were when this was first called.
void applyAppearance(QApplication&, const PreferenceValues&, const DesktopWishes&);
/// As applied last: what fades or slides by itself does it at once while this is true.
[[nodiscard]] bool reducedMotion();

/// Follows the preferences and the desktop's wishes, but does nothing before either changes.
class Appearance final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it.
    Appearance(const Preferences&, const DesktopPortal&, QObject* parent = nullptr);

    [[nodiscard]] bool reducesMotion() const { return ui::reducesMotion(preferences_.values(), portal_.wishes()); }

signals:
    /// Colors, type or motion may be others now.
    void applied();

private:
    void apply();

    const Preferences& preferences_;
    const DesktopPortal& portal_;
};

}  // namespace vitrine::ui
