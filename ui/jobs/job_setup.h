#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/model/history.h"

#include <QObject>

namespace vitrine::ui {

/// What is set in the dialog of a job, with undo. It is remembered as a settings document.
class JobSetup final : public QObject {
    Q_OBJECT

public:
    JobSetup(const jobs::Job&, QObject* parent);

    [[nodiscard]] const ParameterValues& values() const { return history_.sceneState().values[0]; }
    /// `text` names the step for people.
    void change(const QString& text, const ParameterValues&);
    /// The values, for a panel.
    [[nodiscard]] History& history() { return history_; }

    /// Brings back what `remember` wrote, with nothing to undo. A document that cannot be read is left out.
    void recall();
    void remember() const;

signals:
    void changed();

private:
    const jobs::Job& job_;
    History history_;
};

}  // namespace vitrine::ui
