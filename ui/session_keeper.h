#pragma once

#include "exhibits/framework/recovery.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <filesystem>

namespace vitrine::ui {

class MainWindow;

/// Brings back the last session, also after a crash: values and camera as an exhibition, the window's
/// layout, folded groups. Writes the journal after two quiet seconds, at most every ten.
class SessionKeeper final : public QObject {
    Q_OBJECT

public:
    explicit SessionKeeper(MainWindow&);

    /// Returns whether there was a session to bring back.
    bool restore();
    /// The window closes as it should.
    void close();
    /// Something worth keeping changed.
    void noteChange();

private:
    void writeJournal();
    bool restoreLook(const std::string& text, const std::string& fileName);
    void restoreLayout();
    void saveLayout() const;

    MainWindow& window_;
    std::filesystem::path folder_;
    RecoveryJournal journal_;
    QTimer quiet_;
    QElapsedTimer sinceWritten_;
};

}  // namespace vitrine::ui
