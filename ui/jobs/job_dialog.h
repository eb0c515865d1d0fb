#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/jobs/job_draft.h"
#include "ui/jobs/job_planner.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/job_setup.h"
#include "ui/kit/message_strip.h"

#include <QDialog>

#include <filesystem>

class QLabel;

namespace vitrine::ui {

class ExportBar;
class JobPreview;
class ParameterPanel;

/// Dialog of a job, derived from its table and plan: its parameters on the left, a preview and the plan on the right,
/// and the export, which writes the same bytes as the job's command.
class JobDialog final : public QDialog {
    Q_OBJECT

public:
    using SceneSource = JobPlanner::SceneSource;

    /// All arguments must outlive the dialog. Plans and exports use the scene as it is when they begin.
    JobDialog(const jobs::Job&, SceneSource, Renderers&, RenderThread&, QWidget* parent);
    ~JobDialog() override;

    [[nodiscard]] const jobs::Job& job() const { return job_; }
    [[nodiscard]] JobSetup& setup() { return setup_; }
    /// Returns the preview; null if the job has none.
    [[nodiscard]] JobPreview* preview() { return preview_; }
    void setPath(const QString&);
    [[nodiscard]] QString path() const;
    [[nodiscard]] bool exporting() const { return full_.running(); }
    /// Returns whether the preview is up to date, or nothing can be previewed.
    [[nodiscard]] bool settled() const;
    /// Starts the export as its button does: asks before files are replaced.
    void startExport();
    /// Loads the settings of a document, or of the document beside an output. One undo step.
    void load(const QString& file);
    /// Reads the inputs and plans again, after a change outside of the settings.
    void refresh();
    /// Returns the command line that writes the same files, for a terminal.
    [[nodiscard]] QString commandLine() const;

    void done(int result) override;
    void reject() override;

protected:
    void showEvent(QShowEvent*) override;

signals:
    void exportBegun();
    /// Emitted at the end of an export. `written`: the files were written.
    void exportEnded(bool written);

private:
    void build();
    [[nodiscard]] QWidget* buildRight();
    void buildBar();
    void buildUndo();
    void connectParts();
    void recall();
    void remember();
    void follow();
    void showPlan();
    void startDraft();
    void showFacts(const std::vector<jobs::Fact>&, const std::vector<std::string>& warnings, bool partly);
    void showButtons();
    /// Returns how long the export will take, by its draft or by the time of the window's pictures; 0: unknown.
    [[nodiscard]] double secondsExpected() const;
    void chooseDocument();
    /// Shows why the plan refuses the export, and returns whether it does.
    bool refuse(const jobs::JobPlan&);
    void begin();
    void endExport(const QString& words);
    void complain(const QString&);
    [[nodiscard]] std::filesystem::path output() const;

    const jobs::Job& job_;
    JobSetup setup_;
    JobPlanner planner_;
    JobRunner full_;
    double draftSays_ = 0;  ///< Seconds that the export will take, judged by its draft; 0: unknown.
    QString ifStopped_;     ///< Sentence on what remains of the export when it is stopped.
    bool remembered_ = false;
    bool draftIsDue_ = false;  ///< Whether a draft was left out because the page is hidden.

    MessageStrip* messages_;
    ParameterPanel* panel_;
    QLabel* facts_;
    ExportBar* export_;
    JobPreview* preview_;
    JobDraft draft_;  ///< Declared after the preview that it fills.
    QString suffix_;  ///< Extension of the output that the draft is judged for.
};

}  // namespace vitrine::ui
