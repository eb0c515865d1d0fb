#pragma once

#include "exhibits/recording/record.h"
#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QObject>

#include <filesystem>
#include <functional>

namespace vitrine::ui {

/// What to record.
struct FilmWish {
    SceneState sceneState;
    std::size_t subject = 0;
    std::function<RecordingRequest()> request;  ///< Called on the render thread: finding a way takes a while.
    std::filesystem::path path;
};

/// Records a film on the render thread, a step at a time, beside what else is drawn there.
class FilmMaker final : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    FilmMaker(const Museum&, Renderers&, RenderThread&, QObject* parent);
    ~FilmMaker() override;

    void start(FilmWish);
    /// Leaves no video; frames stay as far as they are.
    void stop();
    [[nodiscard]] bool running() const { return running_; }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    /// The film is there; or why it is not: then the old file, if any, is as it was.
    void finished();
    void failed(const QString& why);

private:
    struct Work;
    void note(double part);
    void end(const QString& failure);

    const Museum& museum_;
    Renderers& renderers_;
    RenderThread& thread_;
    RenderThread::Task task_;
    QElapsedTimer elapsed_;
    bool running_ = false;
};

}  // namespace vitrine::ui
