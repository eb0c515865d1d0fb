#pragma once

#include "exhibits/printing/print_table.h"
#include "ui/model/history.h"

#include <QObject>
#include <QStringList>

#include <string>

namespace vitrine::ui {

/// Everything that is set about a print.
struct PrintState {
    ParameterValues values = printing::printTable().initial();
    QStringList files{};  ///< Where the views come from.
    std::string sheet{};  ///< Chosen or saved last: of sheets that are alike, the one that is meant.

    bool operator==(const PrintState&) const = default;
};

/// What is set in the print dialog, with undo; it comes back the next time.
class PrintSetup final : public QObject {
    Q_OBJECT

public:
    /// `canShow`: there is a picture in the window to render views from. Without one, views come from files.
    PrintSetup(bool canShow, QObject* parent);
    ~PrintSetup() override;

    [[nodiscard]] const PrintState& state() const { return state_; }
    [[nodiscard]] const ParameterValues& values() const { return state_.values; }
    /// Sets `after`; `text` names the step for people. Edits with the same number, other than 0, are one step. What is
    /// set already is no step.
    void change(const QString& text, PrintState after, Gesture = 0);
    /// The same, for the values only.
    void change(const QString& text, const ParameterValues&, Gesture = 0);
    /// The values, for a panel.
    [[nodiscard]] History& history() { return history_; }
    [[nodiscard]] QUndoStack& stack() { return history_.stack(); }

    /// Everything that is set, as a print's own JSON has it.
    [[nodiscard]] std::string text() const;
    /// Sets what such a text says and returns what had to be changed, for people. Throws Failure naming file and key.
    QStringList load(const std::string& text, const std::string& fileName);

    /// Brings back what `remember` wrote, with nothing to undo; without it, what is set at first. `changed` follows in
    /// any case. Throws Failure where it cannot be read; then what is set at first stays.
    QStringList recall();
    /// Throws Failure when it cannot be written.
    void remember() const;

signals:
    /// `views`: those that were got so far are not the ones that are now asked for.
    void changed(bool views);

private:
    /// Says what is another than what was said last.
    void follow();
    [[nodiscard]] PrintState possible(PrintState) const;

    History history_{SceneState{{printing::printTable().initial()}, {}}};
    QStringList files_;
    std::string sheet_;
    PrintState state_;  ///< What was said last.
    bool canShow_;
};

/// The file names as the print's functions take them.
[[nodiscard]] std::vector<std::string> textsOf(const QStringList&);

}  // namespace vitrine::ui
