#pragma once

#include "exhibits/framework/files/recovery.h"

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::ui {

class MainWindow;

/// Restores the last session, also after a crash: values and camera as an exhibition, the window's layout, folded
/// groups, the chosen exhibit. Journal and layout are written two seconds after the first unwritten change, so a crash
/// loses no more than that. A thread writes the journal, because disks may be slow.
///
/// The journal of a crash is kept until this session has written its own. A journal that was restored three times
/// without any change or a minute passing is put aside, because it may cause the crash. A session that cannot be read
/// completely is also put aside before it would be overwritten.
class SessionKeeper final : public QObject {
    Q_OBJECT

public:
    explicit SessionKeeper(MainWindow&);

    /// Restores the last session. Returns whether there was one.
    bool restore();
    /// Saves the session when the window closes normally.
    void close();
    /// Call when docks or other parts of the layout changed.
    void noteLayout();
    /// Begins to watch values and layout: earlier changes are made by the window itself.
    void watch();
    /// Saves the layout. In the bare-picture mode the docks' saved layout is kept.
    void saveLayout() const;

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void noteChange();
    void noteWalk();
    [[nodiscard]] std::string journalText() const;
    void write();
    bool writeJournal();
    void writeJournalLater();
    /// Renames session.json to a free name. Returns the new path; empty if that failed.
    [[nodiscard]] QString putSessionAside() const;
    /// Returns a message on what was corrected or unknown while reading a session; empty: nothing.
    [[nodiscard]] static QString changesText(const std::vector<std::string>& notes);
    bool restoreCrash();
    /// Restores a scene state. Returns notes on what was corrected or unknown. If it cannot be read, shows a message
    /// and returns nullopt.
    [[nodiscard]] std::optional<std::vector<std::string>> restoreSceneState(const std::string& text,
                                                                            const std::string& fileName);
    void restoreLayout();
    [[nodiscard]] int timesRestored() const;
    void setTimesRestored(int) const;

    MainWindow& window_;
    std::filesystem::path folder_;
    RecoveryJournal journal_;
    QTimer due_;                  // Started by the first unwritten change.
    QTimer settled_;              // Runs out if a restored session has not crashed again.
    bool changed_ = false;        // Values changed since the start.
    bool layoutChanged_ = false;  // The layout changed since it was written.
    bool closed_ = false;
    std::future<void> writing_;  // Writing of the journal.
};

}  // namespace vitrine::ui
