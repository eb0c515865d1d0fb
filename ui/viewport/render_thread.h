#pragma once

#include "ui/viewport/draw_schedule.h"
#include "ui/viewport/renderers.h"

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QPoint>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace vitrine::ui {

/// Order for one picture. It holds copies of everything needed: later changes do not affect it.
struct PictureOrder {
    SceneState sceneState;
    FrameRequest request;
    DrawOrder order;
    QSize screen;  ///< Size of the viewport in device pixels.
    std::optional<PictureRegion>
        region;  ///< Part of the picture to draw, with all its supersamples at once. Unset: the whole picture.
};

/// Result of a picture order.
struct DrawnPicture {
    PictureOrder order;
    QImage image;  ///< Image at the size of the viewport, or of the region, in device pixels.
    render::FrameReport report;
    double seconds = 0;      ///< Wall-clock time that drawing took.
    bool abandoned = false;  ///< No picture: drawing was abandoned because a newer one is wanted.
    QString failure;         ///< Sentence why there is no image; empty if there is one.
    std::vector<render::gl::ShaderProblem> problems;
};

/// Render thread: draws pictures, reads their files, and makes studies, exports and print views. It has an OpenGL
/// context of its own and returns pictures as pixels.
///
/// Pixels are used instead of a texture of a context shared with the window's for this reason: on Mesa's software
/// renderer all contexts of one display draw through one rasterizer, one after the other. With a shared context a
/// window of 1600 x 1000 pixels waited 820 ms (median) for one quad of its own while passes of 700 ms were drawn. With
/// a display of its own it waited 2.8 ms, as long as without any other work.
///
/// The newest picture order is drawn first and replaces older ones that wait. Work done in steps (refinement, and tasks
/// in turn) shares the rest of the time evenly.
class RenderThread final : public QObject {
    Q_OBJECT

public:
    /// Largest side of a tile of a task's picture, in pixels. A step then takes a fraction of a second, and the
    /// viewport is drawn between steps.
    static constexpr int taskTile = 512;
    static constexpr qint64 tellEvery = 50;  ///< Milliseconds between two progress reports of a task.

    /// Calls its argument later in the window's thread, unless the task was canceled before then.
    using Notify = std::function<void(std::function<void()>)>;
    /// One step of a task; returns whether there is another one. Its captures are destroyed on the render thread.
    using Step = std::function<bool(const Notify&)>;
    /// Called in the window's thread after the last step. `failure` is the sentence of an exception; empty: success.
    using Ended = std::function<void(const QString& failure)>;

    /// Handle of a task. The task goes on step by step until it ends; destroying the handle cancels it.
    class Task {
    public:
        Task() = default;
        ~Task() { cancel(); }
        Task(Task&&) = default;
        Task& operator=(Task&& other) noexcept
        {
            cancel();
            canceled_ = std::move(other.canceled_);
            return *this;
        }
        Task(const Task&) = delete;
        Task& operator=(const Task&) = delete;

        /// Cancels the task: no further step or callback follows. A step that has begun ends after the present pass.
        void cancel()
        {
            if (canceled_) *canceled_ = true;
            canceled_.reset();
        }

    private:
        friend class RenderThread;
        std::shared_ptr<std::atomic<bool>> canceled_;
    };

    /// Starts the thread and opens the renderers on it. The renderers must outlive this object.
    explicit RenderThread(Renderers&);
    /// Abandons the present picture, waits for the end of the present step, and closes the renderers.
    ~RenderThread() override;

    /// Queues a picture order, which replaces one that still waits; `drawn` follows. A picture that is being drawn goes
    /// on.
    void draw(PictureOrder);
    /// Abandons the last order: drawing ends after the present pass.
    void abandon() { unwanted_ = true; }
    [[nodiscard]] Task start(Step, Ended);
    /// Returns whether the task whose step runs on the calling thread was canceled. Renderers of tasks poll it between
    /// passes.
    [[nodiscard]] static bool isTaskCanceled();
    /// Calls `work` once on the render thread, before anything else, and then its result in the window's thread.
    void post(std::function<std::function<void()>()> work);

    [[nodiscard]] std::thread::id id() const { return thread_.get_id(); }

signals:
    /// Emitted in the window's thread.
    void drawn(const vitrine::ui::DrawnPicture& picture);
    /// Emitted if nothing can be drawn, or if work given to `post` threw.
    void failed(const QString& message);

private:
    struct Running {
        Step step;
        Ended ended;
        std::shared_ptr<std::atomic<bool>> canceled;
    };
    void run();
    void work();
    [[nodiscard]] DrawnPicture picture(PictureOrder);
    void step();
    void toWindow(std::function<void()>);
    [[nodiscard]] bool idle() const { return !wanted_ && posted_.empty() && tasks_.empty(); }
    [[nodiscard]] bool pictureFirst() const;

    Renderers& renderers_;
    std::atomic<bool> unwanted_ = false;
    bool open_ = false;  // Used by the render thread only, like the members up to the mutex.
    bool pictureWasLast_ = false;
    double pictureSeconds_ = 0, taskSeconds_ = 0;  // Seconds spent on each since both were waiting.

    std::mutex mutex_;  // Guards the following members.
    std::condition_variable wake_;
    bool ending_ = false;
    std::optional<PictureOrder> wanted_;
    std::deque<std::function<std::function<void()>()>> posted_;
    std::deque<std::shared_ptr<Running>> tasks_;  // Tasks in turn; the front runs next.

    std::thread thread_;
};

}  // namespace vitrine::ui
