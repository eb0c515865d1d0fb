#pragma once

#include "exhibits/printing/print_table.h"
#include "ui/model/history.h"

#include <QObject>
#include <QStringList>

#include <string>

namespace vitrine::ui {

/// All settings of a print.
struct PrintState {
    ParameterValues values = printing::printTable().initial();
    QStringList files{};  ///< Files from which the views are read.
    std::string sheet{};  ///< Name of the sheet chosen or saved last, which decides between sheets with equal numbers.

    bool operator==(const PrintState&) const = default;
};

/// Settings of the print dialog, with undo. They are restored the next time.
class PrintSetup final : public QObject {
    Q_OBJECT

public:
    /// `canShow`: views can be rendered from the window's picture. Otherwise views come from files.
    PrintSetup(bool canShow, QObject* parent);
    ~PrintSetup() override;

    [[nodiscard]] const PrintState& state() const { return state_; }
    [[nodiscard]] const ParameterValues& values() const { return state_.values; }
    /// Sets `after` as one undo step; `text` is its label. Edits with the same gesture number, other than 0, are one
    /// step. Equal settings make no step.
    void change(const QString& text, PrintState after, Gesture = 0);
    /// The same for the values only.
    void change(const QString& text, const ParameterValues&, Gesture = 0);
    /// Returns the history of the values, for a parameter panel.
    [[nodiscard]] History& history() { return history_; }
    [[nodiscard]] QUndoStack& stack() { return history_.stack(); }

    /// Returns all settings as a text, in the format of a print's own JSON.
    [[nodiscard]] std::string text() const;
    /// Applies the settings of such a text. Returns sentences on corrected values. Throws Failure naming file and key.
    QStringList load(const std::string& text, const std::string& fileName);

    /// Restores the settings that `remember` wrote, and clears the undo stack. Without such settings, the initial ones
    /// are set. `changed` is emitted in any case. Throws Failure if the settings cannot be read; the initial ones are
    /// then set.
    QStringList recall();
    /// Saves the settings for `recall`. Throws Failure if they cannot be written.
    void remember() const;

signals:
    /// Emitted after a change. `views`: other views are needed than those read or rendered so far.
    void changed(bool views);

private:
    /// Emits `changed` if the settings differ from `state_`.
    void follow();
    [[nodiscard]] PrintState possible(PrintState) const;

    History history_{SceneState{{printing::printTable().initial()}, {}}};
    QStringList files_;
    std::string sheet_;
    PrintState state_;  ///< Settings at the last `changed`.
    bool canShow_;
};

/// Converts file names for the print functions.
[[nodiscard]] std::vector<std::string> textsOf(const QStringList&);

}  // namespace vitrine::ui
