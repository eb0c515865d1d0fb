#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/kit/progress_job.h"

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::ui {

class JobSetup;

/// Plans a job for its newest settings on another thread: reads the inputs, finds out what would be written, and
/// chooses the values of the draft.
class JobPlanner final : public QObject {
    Q_OBJECT

public:
    /// Returns the scene as it is now. Its museum must outlive the planner.
    using SceneSource = std::function<jobs::JobScene()>;

    /// Job and setup must outlive it.
    JobPlanner(const jobs::Job&, SceneSource, JobSetup&, QObject* parent);

    /// Plans again once the settings have been the same for a moment.
    void follow();
    /// Reads the inputs and plans again, after a change outside of the settings.
    void refresh();
    [[nodiscard]] bool busy() const { return work_.running() || soon_.isActive(); }
    [[nodiscard]] jobs::JobScene scene() const { return scene_(); }
    /// Returns the plan without an output; nullopt while the inputs are unknown.
    [[nodiscard]] const std::optional<jobs::JobPlan>& plan() const { return planned_; }
    /// Returns the values of the draft. Only with a plan.
    [[nodiscard]] const ParameterValues& drawn() const { return *drawn_; }
    /// Returns whether the draft is the whole job: with the same values, or, if nothing is forecast, the same facts.
    [[nodiscard]] bool drawsAll(const jobs::JobForecast&) const;
    /// Returns whether the inputs have been read.
    [[nodiscard]] bool hasInputs() const { return inputs_ != nullptr; }
    /// Returns the plan for an output. Only with inputs.
    [[nodiscard]] jobs::JobPlan planFor(const std::filesystem::path& out) const;
    /// Returns the order of a run with these values, without an output.
    [[nodiscard]] jobs::JobOrder order(const ParameterValues&) const;

signals:
    void planned();
    /// Emitted when the inputs cannot be read. There is no plan then.
    void failed(const QString& why);

private:
    struct Planned;

    void start();
    void take(const Planned&);

    const jobs::Job& job_;
    SceneSource scene_;
    JobSetup& setup_;
    ProgressJob work_;
    QTimer soon_;                                    ///< Delays the plan until a slider has stopped moving.
    std::shared_ptr<const jobs::JobInputs> inputs_;  ///< Null while they are being read.
    std::vector<std::string> files_;                 ///< Files that the inputs were read from.
    std::optional<jobs::JobPlan> planned_;
    std::optional<ParameterValues> drawn_;  ///< Values of the draft.
    int refreshes_ = 0;                     ///< Number of calls of `refresh`.
};

}  // namespace vitrine::ui
