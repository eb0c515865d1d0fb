#pragma once

#include "exhibits/compare/offered_comparison.h"
#include "exhibits/museum/scene_state.h"
#include "render/plan/render_backend.h"
#include "ui/compare/compare_mode.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class QUndoStack;

namespace vitrine::ui {

class CompareActions;
class CompareBar;
class CompareOverlay;
class History;
class PictureB;
class SettingsB;
class PresetController;
class Workbench;

/// Parameter whose values differ between A and B.
struct ParameterDifference {
    std::size_t exhibit = 0;
    std::string name;
    QString text;  ///< "Torus to Mug: Morph: 0.5 | 0.7", A's value first.
};

/// Comparison of the present settings, A, with other settings, B: the source of B, the mode, and the cost of each.
class CompareController final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object. `parent` is the window.
    CompareController(Workbench&, PresetController&, QWidget* parent);
    ~CompareController() override;

    [[nodiscard]] SettingsB& other() const { return *other_; }
    [[nodiscard]] PictureB& picture() const { return *picture_; }
    [[nodiscard]] CompareOverlay& overlay() const { return *overlay_; }
    [[nodiscard]] CompareActions& actions() const { return *actions_; }
    /// Bar for the window's layout; hidden while nothing is compared.
    [[nodiscard]] CompareBar& bar() const { return *bar_; }
    [[nodiscard]] QWidget* window() const { return window_; }

    /// Sets the mode. If there is no B, the present settings become B.
    void setMode(CompareMode);
    void setToCurrent();
    void holdSelectedPreset();
    /// Sets B to the preset, exhibition or picture in this file.
    void holdFile(const QString& path);
    void holdStep(int step, const QString& name);
    /// Makes B follow A, with the parameters changed that this subject offers for comparison.
    void compareWith(std::size_t subject, const OfferedComparison&);
    void chooseFile();
    void letGo();
    [[nodiscard]] std::vector<std::pair<QString, QString>> presets() const;
    [[nodiscard]] const QUndoStack& steps() const;
    [[nodiscard]] History& history() const;
    [[nodiscard]] Workbench& workbench() const { return workbench_; }
    /// Returns the parameters in which A and B differ; empty if there is no B.
    [[nodiscard]] std::vector<ParameterDifference> differences() const;

signals:
    /// Emitted with the frame report of B. `report` is null while B is not drawn, and `why` gives the reason; an empty
    /// `why` means that there is no B.
    void reportChanged(const vitrine::render::FrameReport* report, const QString& why);

private:
    /// Sets B once its files are read. Without a name, B is the same with files read again.
    void set(const SceneState&, const QString& name);
    /// Reads B's files again if they have changed.
    void lookAtFiles();
    void refresh();
    void tellReport();

    Workbench& workbench_;
    PresetController& presetController_;
    QWidget* window_;
    SettingsB* other_;
    PictureB* picture_;
    CompareOverlay* overlay_;
    CompareActions* actions_;
    CompareBar* bar_;
    int holds_ = 0;  ///< Number of B's so far. A result of an older reading is dropped.
    QTimer fileWatch_;
    std::uint64_t filesRead_ = 0;  ///< State of the files that B names.
};

}  // namespace vitrine::ui
