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

/// A picture to draw, complete in itself: nothing that happens afterwards changes it.
struct PictureOrder {
    SceneState sceneState;
    FrameRequest request;
    DrawOrder order;
    QSize screen;  ///< Device pixels of the viewport.
    std::optional<PictureRegion>
        region;  ///< Only this part of the picture, all its supersamples at once; empty: all of it.
};

/// What became of it.
struct DrawnPicture {
    PictureOrder order;
    QImage image;  ///< As the screen shows it: the viewport's size, or the region's.
    render::FrameReport report;
    double seconds = 0;      ///< That it took, wall clock.
    bool abandoned = false;  ///< Nothing was drawn: something newer was wanted.
    QString failure;         ///< Why there is no image, for people; empty when there is one.
    std::vector<render::gl::ShaderProblem> problems;
};

/// The thread on which pictures are drawn, files for them are read, and studies, exports and print views are made. It
/// has an OpenGL context of its own and hands pictures over as pixels.
///
/// Why pixels and not a texture of a context shared with the window's: on Mesa's software renderer all contexts of one
/// display draw through one rasterizer, one after the other. With a shared context a window of 1600 x 1000 pixels
/// waited 820 ms (median) for one quad of its own while passes of 700 ms were drawn; on a display of its own it
/// waited 2.8 ms, as long as with nothing beside it.
///
/// The newest picture is drawn first and replaces those that wait. What is made step by step (refinement, and tasks in
/// turn) shares the rest of the time evenly.
class RenderThread final : public QObject {
    Q_OBJECT

public:
    /// Largest side of a tile of a task's pictures: a step takes part of a second, and the viewport goes on in between.
    static constexpr int taskTile = 512;
    static constexpr qint64 tellEvery = 50;  ///< Milliseconds between two words about a task's progress.

    /// Calls its argument later in the window's thread, unless the task was canceled before.
    using Tell = std::function<void(std::function<void()>)>;
    /// One step; returns whether there is another one. What it holds is let go on the render thread.
    using Step = std::function<bool(const Tell&)>;
    /// In the window's thread: the last step was done, or what a step threw, for people.
    using Ended = std::function<void(const QString& failure)>;

    /// A task that goes on step by step until it ends or this is destroyed.
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

        /// No further step, and nothing more is told; a step that is being done is finished.
        void cancel()
        {
            if (canceled_) *canceled_ = true;
            canceled_.reset();
        }

    private:
        friend class RenderThread;
        std::shared_ptr<std::atomic<bool>> canceled_;
    };

    /// The renderers must outlive it. Opens them on the new thread.
    explicit RenderThread(Renderers&);
    /// Abandons the picture that is being drawn, waits for the step that is being done, and closes the renderers.
    ~RenderThread() override;

    /// Draws this one in place of one that still waits, which is forgotten; `drawn` follows. One that is being drawn
    /// goes on.
    void draw(PictureOrder);
    /// What `draw` was called for last is not wanted any more: it ends with the pass that is being drawn.
    void abandon() { unwanted_ = true; }
    [[nodiscard]] Task start(Step, Ended);
    /// Calls `work` once on the render thread, before anything else, and then what it returns in the window's.
    void post(std::function<std::function<void()>()> work);

    [[nodiscard]] std::thread::id id() const { return thread_.get_id(); }

signals:
    /// In the window's thread.
    void drawn(const vitrine::ui::DrawnPicture& picture);
    /// Nothing can be drawn, or a `post`ed piece of work threw.
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
    bool open_ = false;  // The rest is the render thread's.
    bool pictureWasLast_ = false;
    double pictureSeconds_ = 0, taskSeconds_ = 0;  // That each took since both were wanted.

    std::mutex mutex_;  // For what follows.
    std::condition_variable wake_;
    bool ending_ = false;
    std::optional<PictureOrder> wanted_;
    std::deque<std::function<std::function<void()>()>> posted_;
    std::deque<std::shared_ptr<Running>> tasks_;  // The next one first.

    std::thread thread_;
};

}  // namespace vitrine::ui
