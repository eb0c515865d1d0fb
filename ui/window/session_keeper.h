#pragma once

#include "exhibits/framework/recovery.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <filesystem>

namespace vitrine::ui {

class MainWindow;

/// Brings back the last session, also after a crash: values and camera as an exhibition, the window's
/// layout, folded groups, the chosen exhibit. Writes journal and layout after two quiet seconds, at most every ten.
///
/// The journal of a crash is kept until this session has written its own. One that was brought back three times
/// without anything being changed or a minute going by is put aside: it may be what crashes.
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
    void write();
    bool writeJournal();
    bool restoreCrash();
    bool restoreSceneState(const std::string& text, const std::string& fileName);
    void restoreLayout();
    [[nodiscard]] int timesRestored() const;
    void setTimesRestored(int) const;

    MainWindow& window_;
    std::filesystem::path folder_;
    RecoveryJournal journal_;
    QTimer quiet_;
    QTimer settled_;        // Runs out when a restored session did not crash again.
    bool changed_ = false;  // The look, since the start.
    bool closed_ = false;
    QElapsedTimer sinceWritten_;
};

}  // namespace vitrine::ui
