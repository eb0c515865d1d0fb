#include "ui/viewport/render_thread.h"

#include "render/failure.h"
#include "render/measure/clock.h"
#include "ui/kit/message_of.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

/// Cancellation of the task whose step the render thread runs now; null between steps.
thread_local const std::atomic<bool>* canceledNow = nullptr;

constexpr int nicer = 5;  ///< Niceness of the render thread, relative to the window's.

/// Lowers the priority of the calling thread. On Linux each thread has its own, and threads that it starts inherit it.
void lowerPriorityOfThisThread()
{
    setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), nicer);
}

}  // namespace

RenderThread::RenderThread(Renderers& renderers) : renderers_(renderers)
{
    thread_ = std::thread([this] { run(); });
}

RenderThread::~RenderThread()
{
    {
        const std::scoped_lock lock(mutex_);
        ending_ = true;
        for (const auto& task : tasks_) *task->canceled = true;
    }
    unwanted_ = true;
    wake_.notify_one();
    thread_.join();
}

void RenderThread::draw(PictureOrder order)
{
    {
        const std::scoped_lock lock(mutex_);
        wanted_ = std::move(order);
        unwanted_ = ending_;
    }
    wake_.notify_one();
}

RenderThread::Task RenderThread::start(Step step, Ended ended)
{
    Task task;
    task.canceled_ = std::make_shared<std::atomic<bool>>(false);
    {
        const std::scoped_lock lock(mutex_);
        tasks_.push_back(std::make_shared<Running>(Running{std::move(step), std::move(ended), task.canceled_}));
    }
    wake_.notify_one();
    return task;
}

void RenderThread::post(std::function<std::function<void()>()> work)
{
    {
        const std::scoped_lock lock(mutex_);
        posted_.push_back(std::move(work));
    }
    wake_.notify_one();
}

void RenderThread::toWindow(std::function<void()> outcome)
{
    QMetaObject::invokeMethod(this, std::move(outcome), Qt::QueuedConnection);
}

void RenderThread::run()
{
    // The threads of the OpenGL context inherit the priority: input is handled before pictures are drawn.
    lowerPriorityOfThisThread();
    try {
        renderers_.open();
        open_ = true;
    } catch (const std::exception& thrown) {
        toWindow([this, why = messageOf(thrown)] { emit failed(why); });
    }
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            wake_.wait(lock, [this] { return ending_ || !idle(); });
            if (ending_) break;
        }
        work();
    }
    tasks_.clear();
    posted_.clear();
    if (open_) renderers_.close();
}

bool RenderThread::isTaskCanceled()
{
    return canceledNow && *canceledNow;
}

bool RenderThread::pictureFirst() const
{
    if (tasks_.empty()) return true;
    // A first picture after a change comes first, because the visitor waits for it. Tasks get one step between two such
    // pictures.
    const bool quick = !wanted_->region && wanted_->order.sample == 0;
    return quick ? !pictureWasLast_ : pictureSeconds_ <= taskSeconds_;
}

void RenderThread::work()
{
    std::function<std::function<void()>()> once;
    std::optional<PictureOrder> order;
    {
        const std::scoped_lock lock(mutex_);
        if (!posted_.empty()) {
            once = std::move(posted_.front());
            posted_.pop_front();
        } else if (wanted_ && pictureFirst()) {
            order = std::exchange(wanted_, std::nullopt);
        }
    }
    if (once) {
        try {
            if (std::function<void()> outcome = once()) toWindow(std::move(outcome));
        } catch (const std::exception& thrown) {
            toWindow([this, why = messageOf(thrown)] { emit failed(why); });
        }
        return;
    }
    if (!order) {
        step();
        return;
    }
    DrawnPicture done = picture(std::move(*order));
    pictureWasLast_ = true;
    pictureSeconds_ += done.seconds;
    toWindow([this, done = std::move(done)] { emit drawn(done); });
    const std::scoped_lock lock(mutex_);
    if (tasks_.empty()) pictureSeconds_ = taskSeconds_ = 0;
}

DrawnPicture RenderThread::picture(PictureOrder order)
{
    DrawnPicture done;
    const double start = render::wallSeconds();
    try {
        if (!open_) throw Failure(ErrorKind::openGl, "Nothing can be drawn: there is no graphics context.");
        const std::function<bool()> isCanceled = [this] { return unwanted_.load(); };
        if (order.region)
            done.image =
                renderers_.drawRegion(order.sceneState, order.request, *order.region, order.order.samples, isCanceled);
        else {
            done.report = renderers_.draw(order.sceneState, order.request, isCanceled);
            done.image = renderers_.screenImage(order.screen);
        }
    } catch (const render::gl::Abandoned&) {
        done.abandoned = true;
    } catch (const std::exception& thrown) {
        done.failure = messageOf(thrown);
    }
    done.problems = renderers_.problems();
    done.seconds = render::wallSeconds() - start;
    done.order = std::move(order);
    return done;
}

void RenderThread::step()
{
    std::shared_ptr<Running> task;
    {
        const std::scoped_lock lock(mutex_);
        if (tasks_.empty()) return;
        task = std::move(tasks_.front());
        tasks_.pop_front();
    }
    if (*task->canceled) return;
    const Notify notify = [this, canceled = task->canceled](std::function<void()> what) {
        toWindow([canceled, what = std::move(what)] {
            if (!*canceled) what();
        });
    };
    const double start = render::wallSeconds();
    QString failure;
    bool more = false;
    canceledNow = task->canceled.get();
    try {
        if (!open_) throw Failure(ErrorKind::openGl, "Nothing can be drawn: there is no graphics context.");
        more = task->step(notify);
    } catch (const render::gl::Abandoned&) {  // The task was canceled; nobody waits for its end.
    } catch (const std::exception& thrown) {
        failure = messageOf(thrown);
    }
    canceledNow = nullptr;
    if (!more) {
        task->step = {};  // Destroys the step's captures before its end is reported.
        notify([ended = task->ended, failure] { ended(failure); });
    }
    pictureWasLast_ = false;
    taskSeconds_ += render::wallSeconds() - start;
    const std::scoped_lock lock(mutex_);
    // Time without a picture order is not credited to later pictures.
    if (!wanted_) taskSeconds_ = std::min(taskSeconds_, pictureSeconds_);
    if (more) tasks_.push_back(std::move(task));
}

}  // namespace vitrine::ui

#include "moc_render_thread.cpp"
