#pragma once

#include "exhibits/study/study_store.h"
#include "ui/model/history.h"
#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <string>

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace vitrine::ui {

class KeptStudies;
class StudyChart;
class StudyView;

/// What accuracy costs: measures a parameter of the chosen exhibit, or all of them together, on the render thread,
/// shows every point as it is measured, and applies the one that is clicked or searched for. What was measured is kept.
class StudyDock final : public QWidget {
    Q_OBJECT

public:
    /// Museum, renderers and history must outlive it; the thread must, or `stop` is called before it ends.
    StudyDock(const Museum&, Renderers&, History&, RenderThread&, StudyStore = StudyStore::standard(),
              QWidget* parent = nullptr);
    ~StudyDock() override;

    /// Whose parameters are offered; what is shown stays until the next study.
    void setSubject(std::size_t exhibit);
    /// Measures one parameter at once: a row of the exhibit's table.
    void ask(std::size_t exhibit, std::size_t row);
    /// Ends the study that runs; what it measured stays to be seen, and is kept where that is three settings or more.
    void stop();
    [[nodiscard]] bool running() const { return isRunning_; }
    /// Of the study that runs as soon as it has a point, until then of the one before.
    [[nodiscard]] const StudyResult& result() const;
    /// Everything shown that was measured, as a file: .csv, .json (with `machine` beside it), or the chart as .png or
    /// .svg.
    [[nodiscard]] QByteArray exported(const QString& suffix) const;
    [[nodiscard]] StudyChart& chart() const;
    [[nodiscard]] StudyView& view() const { return *shown_; }
    [[nodiscard]] KeptStudies& kept() const { return *kept_; }

    /// Side of the pictures that it measures with, and how often each is timed.
    void setEffort(glm::ivec2 size, int runs);

signals:
    void failed(const QString& why);
    void finished();

private:
    void setTexts();
    [[nodiscard]] QLayout* measuring();
    [[nodiscard]] QLayout* choosing();
    [[nodiscard]] QWidget* studies();
    void connectParts();
    void measure();
    void find(bool byError);
    void start(StudyRequest);
    /// What the study that runs has so far.
    struct News {
        StudyResult result;
        double progress = 0;
        std::string doing;
        render::Json machine = {};
    };
    /// On the render thread: one step, and now and then what has come of it.
    struct Work;
    static bool step(Work&, const RenderThread::Tell&, const std::function<void(std::shared_ptr<News>)>& take);
    void take(News);
    void end(const QString& failure);
    void showIdle();
    void keepMeasured();
    void save();
    void suggestTime();
    [[nodiscard]] StudyRequest requestFor(std::vector<StudyAxis>) const;

    const Museum& museum_;
    Renderers& renderers_;
    History& history_;
    RenderThread& thread_;
    RenderThread::Task task_;
    bool isRunning_ = false;
    StudyRequest running_;  ///< Of the study that runs.
    bool showsRunning_ = false;
    std::shared_ptr<const Parameters> table_;  ///< Whose rows can be chosen; null: none yet.
    std::size_t subject_ = 0;
    glm::ivec2 size_{320, 180};
    int runs_ = 5;
    QElapsedTimer elapsed_;

    QComboBox* parameter_;
    QPushButton* go_;
    QToolButton* copy_;
    QToolButton* save_;
    QToolButton* list_;
    QProgressBar* progress_;
    QLabel* doing_;
    QLineEdit* error_;
    QLineEdit* milliseconds_;
    StudyView* shown_;
    KeptStudies* kept_;
};

}  // namespace vitrine::ui
