#pragma once

#include "exhibits/museum/scene_state.h"

#include <QObject>
#include <QTimer>

#include <string>
#include <vector>

class QKeyEvent;

namespace vitrine::ui {

class KioskPanel;
class MainWindow;

/// How the window is shown in an exhibition.
struct KioskOptions {
    double minutes = 5;                        ///< Minutes without input after which everything begins anew.
    std::vector<std::string> parameters = {};  ///< Parameters that visitors may change, as "exhibit.parameter".
};

/// Window of an exhibition: the picture fills the screen, without menus, panels, commands and shortcuts. Visitors walk,
/// visit exhibits, press their buttons and change the allowed parameters. After some idle minutes the state of the
/// start comes back. Only the keys Ctrl+Alt+Shift+Q close the window.
class Kiosk final : public QObject {
    Q_OBJECT

public:
    /// Takes the window's present state as the start. Call before the window is shown. The window must outlive this
    /// object. Throws Failure (ErrorKind::usage) for a parameter that there is not, or that names files or texts.
    Kiosk(MainWindow&, const KioskOptions&);
    ~Kiosk() override;

    /// Restores the state of the start, as after the idle minutes.
    void beginAnew();
    /// Returns whether there was input since the start.
    [[nodiscard]] bool isWaiting() const { return idle_.isActive(); }

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void ignoreOtherInput();
    void noteInput();
    void noteChange();
    void follow();
    /// Returns whether a key reaches the window.
    [[nodiscard]] bool passes(const QKeyEvent&) const;

    MainWindow& window_;
    SceneState start_;
    KioskPanel* panel_ = nullptr;  ///< Null: no parameter may be changed.
    QTimer idle_;
    bool leaving_ = false;
};

}  // namespace vitrine::ui
