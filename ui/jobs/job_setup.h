#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/model/history.h"

#include <QObject>

namespace vitrine::ui {

/// Values in the dialog of a job, with undo. They are remembered as a settings document.
class JobSetup final : public QObject {
    Q_OBJECT

public:
    JobSetup(const jobs::Job&, QObject* parent);

    [[nodiscard]] const ParameterValues& values() const { return history_.sceneState().values[0]; }
    /// Changes the values in one undo step; `text` is its name for people.
    void change(const QString& text, const ParameterValues&);
    /// Returns the history of the values, for a panel.
    [[nodiscard]] History& history() { return history_; }

    /// Restores what `remember` wrote, without an undo step. An unreadable document is ignored.
    void recall();
    /// Writes the values as the settings document. A failure is logged: nothing else depends on it.
    void remember() const;

signals:
    void changed();

private:
    const jobs::Job& job_;
    History history_;
};

}  // namespace vitrine::ui
