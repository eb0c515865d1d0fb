#pragma once

#include "exhibits/study/study_store.h"
#include "exhibits/study/study_table.h"
#include "ui/jobs/job_setup.h"
#include "ui/study/study_measurement.h"

#include <QWidget>

#include <array>
#include <cstdint>
#include <memory>

class QLayout;
class QToolButton;

namespace vitrine::ui {

class KeptStudies;
class MeasuringBar;
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
    StudyDock(const Museum&, Renderers&, History&, RenderThread&, study::StudyStore = study::StudyStore::standard(),
              QWidget* parent = nullptr);
    ~StudyDock() override;

    /// Offers the parameters of this exhibit. The shown study stays until the next one.
    void setSubject(std::size_t exhibit);
    /// Action at the end of a study; none is taken if the study is stopped, fails or is replaced by another one.
    enum class Then : std::uint8_t { nothing, saveFigure };
    /// Measures one parameter at once; `row` is its index in the exhibit's table.
    void ask(std::size_t exhibit, std::size_t row, Then = Then::nothing);
    /// Measures with the settings of studies and the present settings of the exhibits, or others.
    void measurePresent();
    void measureWith(const SceneState&);
    /// Adds a button that measures with these settings, too. They must outlive the dock.
    void offerBoth(const SettingsB&);
    /// Stops the running study. Its results stay visible, and are kept if three or more settings were measured.
    void stop();
    [[nodiscard]] bool running() const { return measurement_.running(); }
    /// Returns the result of the running study once it has a point, before that of the one before.
    [[nodiscard]] const study::StudyResult& result() const;
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
    /// Emitted when the chart was saved to this file.
    void saved(const QString& file);
    void finished();
    void stopped();  ///< Emitted when a study ended before it was finished.

private:
    void setTexts();
    [[nodiscard]] QLayout* choosing();
    [[nodiscard]] QWidget* studies();
    void connectParts();
    void vary(const QString& parameters);
    void showVaried();
    void measure(const ParameterValues&, const SceneState&);
    void find(study::StudyFind, double limit);
    void endRun();
    void take(StudyProgress&);
    void end(const QString& failure);
    void showIdle();
    void keepMeasured();
    void save();
    /// Saves the chart under a free name in the pictures folder.
    void saveFigure();

    const Museum& museum_;
    History& history_;
    StudyMeasurement measurement_;
    bool showsRunning_ = false;
    Then then_ = Then::nothing;                ///< Action at the end of the running study.
    std::shared_ptr<const Parameters> table_;  ///< Table whose parameters can be chosen; null: none yet.
    std::size_t subject_ = 0;
    JobSetup setup_;

    MeasuringBar* bar_;
    std::array<QToolButton*, 3> keepers_;  ///< They copy the measurements, save them, and save a figure.
    QToolButton* list_;
    StudyFinder* finder_;
    StudyView* shown_;
    KeptStudies* kept_;
    ParameterPanel* settings_;
};

}  // namespace vitrine::ui
