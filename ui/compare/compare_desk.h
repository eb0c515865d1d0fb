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
class OtherPicture;
class OtherSettings;
class PresetShelf;
class Workbench;

/// A row in which A and B differ.
struct RowDifference {
    std::size_t exhibit = 0;
    std::string name;
    QString text;  ///< "Torus to Mug: Morph: 0.5 | 0.7", A's value first.
};

/// The comparison of what is on show, A, with other settings, B: where B comes from, how both are shown, what each
/// costs.
class CompareDesk final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive it. `parent` is the window.
    CompareDesk(Workbench&, PresetShelf&, QWidget* parent);
    ~CompareDesk() override;

    [[nodiscard]] OtherSettings& other() const { return *other_; }
    [[nodiscard]] OtherPicture& picture() const { return *picture_; }
    [[nodiscard]] CompareOverlay& overlay() const { return *overlay_; }
    [[nodiscard]] CompareActions& actions() const { return *actions_; }
    /// To be placed by the window; hidden while nothing is compared.
    [[nodiscard]] CompareBar& bar() const { return *bar_; }
    [[nodiscard]] QWidget* window() const { return window_; }

    /// Where there is no B, what is on show becomes B.
    void setMode(CompareMode);
    void holdPresent();
    void holdSelectedPreset();
    /// The preset, exhibition or picture of this path.
    void holdFile(const QString& path);
    void holdStep(int step, const QString& name);
    /// B is from now on what is on show, but for the rows that this subject offers to be compared in.
    void compareWith(std::size_t subject, const OfferedComparison&);
    void chooseFile();
    void letGo();
    [[nodiscard]] std::vector<std::pair<QString, QString>> presets() const;
    [[nodiscard]] const QUndoStack& steps() const;
    [[nodiscard]] History& history() const;
    [[nodiscard]] Workbench& workbench() const { return workbench_; }
    /// The rows in which A and B differ; none while there is no B.
    [[nodiscard]] std::vector<RowDifference> differences() const;

signals:
    /// What B costs, for the ledger: null while it is not drawn, and `why` then says why; empty: there is no B.
    void ledgerChanged(const vitrine::render::FrameReport* report, const QString& why);

private:
    /// Once its files are read. Without a name: what is B now, of other files.
    void hold(const SceneState&, const QString& name);
    /// The same B once more, where a file that it names is another one now.
    void lookAtFiles();
    void refresh();
    void tellLedger();

    Workbench& workbench_;
    PresetShelf& shelf_;
    QWidget* window_;
    OtherSettings* other_;
    OtherPicture* picture_;
    CompareOverlay* overlay_;
    CompareActions* actions_;
    CompareBar* bar_;
    int holds_ = 0;  ///< B's so far: one that takes longer to read gives way to a later one.
    QTimer fileWatch_;
    std::uint64_t filesRead_ = 0;  ///< State of the files that B names.
};

}  // namespace vitrine::ui
