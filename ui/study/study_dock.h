#pragma once

#include "exhibits/study/study_store.h"
#include "exhibits/study/study_table.h"
#include "ui/jobs/job_setup.h"
#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <string>

class QBoxLayout;
class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

class KeptStudies;
class SettingsB;
class ParameterPanel;
class StudyChart;
class StudyFinder;
class StudyView;

/// Dock for studies of accuracy and cost. Measures one parameter of the chosen exhibit, or all of them together, on the
/// render thread, with the settings of the job "study". Shows points as they are measured, and applies a point that is
/// clicked or searched for. Results are kept.
class StudyDock final : public QWidget {
    Q_OBJECT

public:
    /// Museum, renderers and history must outlive the dock. So must the thread, unless `stop` is called before it ends.
    StudyDock(const Museum&, Renderers&, History&, RenderThread&, StudyStore = StudyStore::standard(),
              QWidget* parent = nullptr);
    ~StudyDock() override;

    /// Offers the parameters of this exhibit. The shown study stays until the next one.
    void setSubject(std::size_t exhibit);
    /// Measures one parameter at once; `row` is its index in the exhibit's table.
    void ask(std::size_t exhibit, std::size_t row);
    /// Measures with the settings of studies and the present settings of the exhibits, or others.
    void measurePresent();
    void measureWith(const SceneState&);
    /// Adds a button that measures with these settings, too. They must outlive the dock.
    void offerBoth(const SettingsB&);
    /// Stops the running study. Its results stay visible, and are kept if three or more settings were measured.
    void stop();
    [[nodiscard]] bool running() const { return isRunning_; }
    /// Returns the result of the running study once it has a point, before that of the one before.
    [[nodiscard]] const StudyResult& result() const;
    /// Returns the content of a file with all measured data shown: .csv, .json (including `machine`), or the chart as
    /// .png or .svg.
    [[nodiscard]] QByteArray exported(const QString& suffix) const;
    [[nodiscard]] StudyChart& chart() const;
    [[nodiscard]] StudyView& view() const { return *shown_; }
    [[nodiscard]] KeptStudies& kept() const { return *kept_; }

    /// Settings of the next study.
    [[nodiscard]] JobSetup& setup() { return setup_; }
    [[nodiscard]] ParameterPanel& settings() const { return *settings_; }

signals:
    void failed(const QString& why);
    void finished();
    void stopped();  ///< Emitted when a study ended before it was finished.

private:
    void setTexts();
    void layOutMeasuring();
    [[nodiscard]] QLayout* choosing();
    [[nodiscard]] QWidget* studies();
    void connectParts();
    void vary(const QString& parameters);
    void showVaried();
    void measure(const ParameterValues&, const SceneState&);
    void find(StudyFind, double limit);
    void endRun();
    void start(StudyRequest);
    /// Intermediate result of the running study.
    struct Progress {
        StudyResult result;
        double progress = 0;
        std::string doing;
        render::Json machine = {};
    };
    /// Performs one step of the study on the render thread, and passes on intermediate results.
    struct Work;
    static bool step(Work&, const RenderThread::Notify&, const std::function<void(std::shared_ptr<Progress>)>& take);
    void take(Progress);
    void end(const QString& failure);
    void showIdle();
    void keepMeasured();
    void save();

    const Museum& museum_;
    Renderers& renderers_;
    History& history_;
    RenderThread& thread_;
    RenderThread::Task task_;
    bool isRunning_ = false;
    StudyRequest running_;  ///< Request of the running study.
    bool showsRunning_ = false;
    std::shared_ptr<const Parameters> table_;  ///< Table whose parameters can be chosen; null: none yet.
    std::size_t subject_ = 0;
    JobSetup setup_;
    QElapsedTimer elapsed_;

    QBoxLayout* measuring_;  ///< Row with the parameter, the buttons that measure, and the progress.
    QComboBox* parameter_;
    QPushButton* go_;
    QToolButton* copy_;
    QToolButton* save_;
    QToolButton* list_;
    QProgressBar* progress_;
    QLabel* doing_;
    StudyFinder* finder_;
    StudyView* shown_;
    KeptStudies* kept_;
    ParameterPanel* settings_;
};

}  // namespace vitrine::ui
