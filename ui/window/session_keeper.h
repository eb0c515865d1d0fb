#pragma once

#include "exhibits/framework/recovery.h"

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::ui {

class MainWindow;

/// Brings back the last session, also after a crash: values and camera as an exhibition, the window's
/// layout, folded groups, the chosen exhibit. Writes journal and layout two seconds after a change, however many
/// follow it: what a crash loses is never older. The journal is written by a thread of its own, because a disk may take
/// its time.
///
/// The journal of a crash is kept until this session has written its own. One that was brought back three times
/// without anything being changed or a minute going by is put aside: it may be what crashes. A session that cannot be
/// read, or not all of it, is put aside, too, before it would be written over.
class SessionKeeper final : public QObject {
    Q_OBJECT

public:
    explicit SessionKeeper(MainWindow&);

    /// Returns whether there was a session to bring back.
    bool restore();
    /// The window closes as it should.
    void close();
    /// What stands where changed.
    void noteLayout();
    /// From now on changes of values and layout count: not those of the window's making.
    void watch();
    /// The bare picture is no layout: docks are left as they were saved before.
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
    /// Keeps session.json under another name that is free. Returns where; empty where that failed.
    [[nodiscard]] QString putSessionAside() const;
    /// What reading a session changed or did not know, for the message; empty: nothing.
    [[nodiscard]] static QString changesText(const std::vector<std::string>& notes);
    bool restoreCrash();
    /// Nothing where it cannot be read, which is said; else what reading changed or did not know.
    [[nodiscard]] std::optional<std::vector<std::string>> restoreSceneState(const std::string& text,
                                                                            const std::string& fileName);
    void restoreLayout();
    [[nodiscard]] int timesRestored() const;
    void setTimesRestored(int) const;

    MainWindow& window_;
    std::filesystem::path folder_;
    RecoveryJournal journal_;
    QTimer due_;                  // From the first change that is not written on.
    QTimer settled_;              // Runs out when a restored session did not crash again.
    bool changed_ = false;        // The look, since the start.
    bool layoutChanged_ = false;  // Since it was written.
    bool closed_ = false;
    std::future<void> writing_;  // The journal.
};

}  // namespace vitrine::ui
