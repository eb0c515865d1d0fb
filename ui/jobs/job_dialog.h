#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/job_setup.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/progress_job.h"

#include <QDialog>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
    /// Returns the scene as it is now. Its museum must outlive the dialog.
    using SceneSource = std::function<jobs::JobScene()>;

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

signals:
    void exportBegun();
    /// Emitted at the end of an export. `written`: the files were written.
    void exportEnded(bool written);

private:
    struct Planned;

    void build();
    void buildBar();
    void buildUndo();
    void connectParts();
    void recall();
    void remember();
    void follow();
    void plan();
    void takePlan(const Planned&);
    void showDraft(const JobRunner::Run&);
    void showFacts(const jobs::JobReport&, bool partly);
    void showButtons();
    /// Returns how long the export will take, by the time of the window's pictures; 0: unknown.
    [[nodiscard]] double secondsExpected() const;
    void chooseDocument();
    /// Shows why the plan refuses the export, and returns whether it does.
    bool refuse(const jobs::JobPlan&);
    void begin();
    void endExport(const QString& words);
    void complain(const QString&);
    [[nodiscard]] std::filesystem::path output() const;
    [[nodiscard]] jobs::JobOrder order(const ParameterValues&) const;

    const jobs::Job& job_;
    SceneSource scene_;
    JobSetup setup_;
    JobRunner draft_, full_;
    ProgressJob plan_, show_;
    QTimer soon_;                                    ///< Delays the draft until a slider has stopped moving.
    std::shared_ptr<const jobs::JobInputs> inputs_;  ///< Null while they are being read.
    std::vector<std::string> files_;                 ///< Files that the inputs were read from.
    QString ifStopped_;                              ///< Sentence on what remains of the export when it is stopped.
    std::optional<jobs::JobPlan> planned_;
    std::optional<ParameterValues> drawn_;  ///< Values of the draft.
    bool remembered_ = false;

    MessageStrip* messages_;
    ParameterPanel* panel_;
    QLabel* facts_;
    JobPreview* preview_;
    ExportBar* export_;
};

}  // namespace vitrine::ui
