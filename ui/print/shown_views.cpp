#include "ui/print/shown_views.h"

#include "render/failure.h"
#include "render/measure/memory.h"
#include "ui/kit/message_of.h"
#include "ui/kit/time_left.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/presets/scene_text.h"
#include "ui/viewport/viewport.h"

#include <algorithm>

namespace vitrine::ui {

ShownViews::ShownViews(Workbench& window, QObject* parent) : QObject(parent), window_(window) {}

ShownViews::~ShownViews()
{
    stop();
}

void ShownViews::start(const ParameterValues& values, bool draft)
{
    stop();
    const SceneState sceneState = window_.history().sceneState();
    FrameRequest frame;
    frame.camera = sceneState.camera;
    frame.time = window_.viewport().clock().time();
    // Only a turn needs to know what turns.
    if (values[printing::printTable().turn] != 0 && window_.chosen() != hallIndex) frame.subject = window_.chosen();
    auto work = std::make_shared<Work>();
    try {
        work->rendered.emplace(
            printing::printShots(values, sceneState, frame, draft, {&window_.museum(), window_.chosen()}));
    } catch (const std::exception& failure) {
        emit failed(messageOf(failure));
        return;
    }
    work->pictures = work->rendered->shots();
    work->pictures.insert(work->pictures.begin(), printing::depthShot(work->rendered->base()));
    for (printing::ViewShot& shot : work->pictures)
        shot.request.largestTile = std::min(shot.request.largestTile, RenderThread::taskTile);
    values_ = values;
    sceneState_ = sceneState;
    views_ = std::make_shared<printing::PrintViews>();
    views_->setScenePreset(textOf(window_.museum(), sceneState, window_.chosen(), "Picture"));
    work->views = views_;
    elapsed_.start();
    task_ = window_.viewport().renderThread().start(
        [this, work, &renderers = window_.renderers()](const RenderThread::Notify& notify) {
            return step(renderers, *work, notify, *this);
        },
        [this](const QString& failure) { end(failure); });
}

void ShownViews::stop()
{
    task_.cancel();
    views_.reset();
}

bool ShownViews::step(Renderers& renderers, Work& work, const RenderThread::Notify& notify, ShownViews& told)
{
    const printing::ViewShot& shot = work.pictures[work.next];
    if (!work.job.renderer)
        work.job = renderers.makePicture(shot.sceneState, shot.request);
    else if (!work.job.maker)
        renderers.nextPicture(work.job, shot.sceneState, shot.request);
    if (!work.job.maker) throw Failure(ErrorKind::openGl, "No views can be rendered: there is no graphics context.");
    work.job.maker->step();
    if (work.job.maker->finished()) {
        if (work.next == 0) {
            fitCameras(work);
            notify([&told, picture = work.job.maker->picture()] {
                told.depth_ = printing::sceneDepth(*told.values_, told.sceneState_, picture);
            });
        } else {
            work.views->add(work.job.maker->picture());
        }
        ++work.next;
        work.job.maker.reset();
    }
    if (!work.told.isValid() || work.told.elapsed() >= RenderThread::tellEvery) {
        work.told.start();
        const double part = (static_cast<double>(work.next) + (work.job.maker ? work.job.maker->progress() : 0)) /
                            static_cast<double>(work.pictures.size());
        notify([&told, part] { told.note(part); });
    }
    if (work.next < work.pictures.size()) return true;
    work.job = {};
    render::trimHeap();
    return false;
}

void ShownViews::fitCameras(Work& work)
{
    if (!work.rendered->waitsForDepth()) return;
    work.rendered->fit(printing::depthRange(work.job.maker->picture()));
    for (std::size_t k = 1; k < work.pictures.size(); ++k)
        work.pictures[k].sceneState.camera = work.pictures[k].request.frame.camera =
            work.rendered->rig().camera(static_cast<int>(k) - 1);
}

void ShownViews::note(double part)
{
    emit progressed(part, secondsLeft(part, elapsed_));
}

void ShownViews::end(const QString& failure)
{
    const std::shared_ptr<const printing::PrintViews> views = std::move(views_);
    stop();
    if (failure.isEmpty())
        emit finished(views, depth_);
    else
        emit failed(failure);
}

}  // namespace vitrine::ui

#include "moc_shown_views.cpp"
