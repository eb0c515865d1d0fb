#pragma once

#include "exhibits/printing/print_table.h"
#include "ui/model/history.h"

#include <QObject>
#include <QStringList>

#include <string>

namespace vitrine::ui {

/// Settings of the print dialog, with undo. They are restored the next time.
class PrintSetup final : public QObject {
    Q_OBJECT

public:
    /// `canShow`: views can be rendered from the window's picture. Otherwise views come from files.
    PrintSetup(bool canShow, QObject* parent);
    ~PrintSetup() override;

    [[nodiscard]] const ParameterValues& values() const { return values_; }
    /// Sets `after` as one undo step; `text` is its label. Edits with the same gesture number, other than 0, are one
    /// step. Equal settings make no step.
    void change(const QString& text, ParameterValues after, Gesture = 0);
    /// Returns the history of the values, for a parameter panel.
    [[nodiscard]] History& history() { return history_; }
    [[nodiscard]] QUndoStack& stack() { return history_.stack(); }

    /// Returns the files from which the views are read.
    [[nodiscard]] QStringList pictures() const;

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
    /// Emits `changed` if the settings differ from `values_`.
    void follow();
    /// Returns the values with an origin of the views that the dialog has.
    [[nodiscard]] ParameterValues possible(ParameterValues) const;

    ParameterValues values_ = printing::printTable().initial();  ///< Settings at the last `changed`.
    History history_{SceneState{{printing::printTable().initial()}, {}}};
    bool canShow_;
};

/// Converts file names for the print functions.
[[nodiscard]] std::vector<std::string> textsOf(const QStringList&);

}  // namespace vitrine::ui
