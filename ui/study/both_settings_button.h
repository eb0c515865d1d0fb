#pragma once

#include "exhibits/museum/scene_state.h"
#include "render/files/strict_json.h"

#include <QPushButton>

#include <optional>

namespace vitrine::ui {

class SettingsB;
class StudyDock;

/// Button that measures the same study with settings A, then with settings B, and opens both curves in one chart.
/// Visible while there are settings B.
class BothSettingsButton final : public QPushButton {
    Q_OBJECT

public:
    /// Dock and settings must outlive the button.
    BothSettingsButton(StudyDock&, const SettingsB&, QWidget* parent);

private:
    void begin();
    void goOn();
    void showBoth(const render::Json& b);

    StudyDock& dock_;
    const SettingsB& other_;
    std::optional<SceneState> b_;  ///< Settings B that remain to be measured, or are being measured.
    QString nameOfB_;
    std::optional<render::Json> a_;  ///< Study with settings A, once it is complete.
};

}  // namespace vitrine::ui
