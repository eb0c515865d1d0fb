#include "ui/sprites/sprite_drawer.h"

#include "render/failure.h"
#include "ui/kit/time_left.h"
#include "ui/viewport/renderers.h"

#include <utility>

namespace vitrine::ui {

struct SpriteDrawer::Work {
    Work(const ParameterValues& look, std::shared_ptr<const SpriteSubject> subject, const SpriteRequest& request)
        : shots(look, std::move(subject), request)
    {
    }
    SpriteShots shots;
    std::unique_ptr<render::RenderBackend> backend;
    QElapsedTimer told;
};

SpriteDrawer::SpriteDrawer(Renderers& renderers, RenderThread& thread, QObject* parent)
    : QObject(parent), renderers_(renderers), thread_(thread)
{
}

SpriteDrawer::~SpriteDrawer()
{
    stop();
}

void SpriteDrawer::start(const ParameterValues& look, std::shared_ptr<const SpriteSubject> subject,
                         const SpriteRequest& request)
{
    stop();
    auto work = std::make_shared<Work>(look, std::move(subject), request);
    running_ = true;
    elapsed_.start();
    task_ = thread_.start(
        [this, work, &renderers = renderers_](const RenderThread::Tell& tell) {
            if (!work->backend) work->backend = renderers.makeBackend(false);
            if (!work->backend) throw Failure(Blame::openGl, "No sprites can be drawn: there is no graphics context.");
            work->shots.step(*work->backend);
            if (work->shots.finished()) {
                auto frames = std::make_shared<std::vector<SpriteFrame>>(std::move(work->shots.frames()));
                work->backend.reset();
                tell([this, frames] { frames_ = frames; });
                return false;
            }
            if (!work->told.isValid() || work->told.elapsed() >= RenderThread::tellEvery) {
                work->told.start();
                tell([this, part = work->shots.progress()] { note(part); });
            }
            return true;
        },
        [this](const QString& failure) { end(failure); });
}

void SpriteDrawer::stop()
{
    task_.cancel();
    running_ = false;
    frames_.reset();
}

void SpriteDrawer::note(double part)
{
    emit progressed(part, secondsLeft(part, elapsed_));
}

void SpriteDrawer::end(const QString& failure)
{
    const Frames frames = std::exchange(frames_, nullptr);
    stop();
    if (failure.isEmpty() && frames)
        emit finished(frames);
    else
        emit failed(failure);
}

}  // namespace vitrine::ui

#include "moc_sprite_drawer.cpp"
