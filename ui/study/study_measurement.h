#pragma once

#include "exhibits/study/study_result.h"
#include "render/files/strict_json.h"
#include "ui/viewport/render_thread.h"

#include <QObject>

#include <functional>
#include <memory>
#include <string>

namespace vitrine::ui {

/// Result of a running study so far.
struct StudyProgress {
    study::StudyResult result;
    double part = 0;  ///< Finished share, 0 to 1.
    std::string doing;
    render::Json machine = {};
};

/// Study that runs on the render thread, between the pictures of the viewport.
class StudyMeasurement final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object, but for a thread that ends after `cancel`.
    StudyMeasurement(Renderers&, RenderThread&, QObject* parent);

    /// Starts a study in place of the one that runs.
    void start(study::StudyRequest);
    /// Ends the study without `ended`.
    void cancel();
    [[nodiscard]] bool running() const { return isRunning_; }
    /// Request of the running or last study.
    [[nodiscard]] const study::StudyRequest& request() const { return request_; }

signals:
    /// Emitted a few times a second, and when the study is finished. The receiver may move the result.
    void progressed(const std::shared_ptr<vitrine::ui::StudyProgress>&);
    /// Emitted after the study has ended by itself. `failure` is empty if it is finished.
    void ended(const QString& failure);

private:
    struct Work;
    using Take = std::function<void(const std::shared_ptr<StudyProgress>&)>;
    /// Performs one step of the study on the render thread, and passes on intermediate results.
    static bool step(Work&, const RenderThread::Notify&, const Take&);

    Renderers& renderers_;
    RenderThread& thread_;
    RenderThread::Task task_;
    bool isRunning_ = false;
    study::StudyRequest request_;
};

}  // namespace vitrine::ui
