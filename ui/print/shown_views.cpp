#include "ui/print/shown_views.h"

#include "render/failure.h"
#include "render/measure/memory.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/presets/look_text.h"
#include "ui/viewport/viewport.h"
#include "ui/kit/message_of.h"

namespace vitrine::ui {

ShownViews::ShownViews(Workbench& window, QObject* parent) : QObject(parent), window_(window)
{
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &ShownViews::step);
    connect(&window.viewport(), &Viewport::contextClosing, this, [this] {
        const bool was = running();
        job_ = {};
        stop();
        if (was) emit failed(tr("The views were not rendered: the graphics context was lost. Render them again."));
    });
}

ShownViews::~ShownViews()
{
    stop();
}

void ShownViews::start(const ParameterValues& values, bool draft)
{
    stop();
    const Look look = window_.history().look();
    FrameRequest frame;
    frame.camera = look.camera;
    frame.time = window_.viewport().time();
    try {
        pictures_ = printing::printShots(values, look, frame, draft);
    } catch (const std::exception& failure) {
        fail(messageOf(failure));
        return;
    }
    printing::ViewShot quick{look, pictures_.front().request};
    quick.request.frame.camera = look.camera;
    quick = printing::depthShot(quick);
    pictures_.insert(pictures_.begin(), quick);
    values_ = values;
    views_ = std::make_shared<printing::PrintViews>();
    views_->setLook(textOf(window_.gallery(), look, window_.chosen(), "Picture"));
    next_ = 0;
    elapsed_.start();
    timer_.start(0);
}

void ShownViews::stop()
{
    timer_.stop();
    const bool had = job_.renderer != nullptr;
    if (had) window_.viewport().withContext([this] { job_ = {}; });
    views_.reset();
    if (had) render::trimHeap();
}

void ShownViews::fail(const QString& why)
{
    stop();
    emit failed(why);
}

void ShownViews::begin(std::size_t picture)
{
    const printing::ViewShot& shot = pictures_[picture];
    if (job_.renderer) window_.gallery().nextPicture(job_, shot.look, shot.request);
    else job_ = window_.gallery().makePicture(shot.look, shot.request);
    if (!job_.maker) throw Failure(Blame::openGl, "No views can be rendered before the first picture is on the screen; try again then.");
}

void ShownViews::take()
{
    if (next_ == 0) depth_ = printing::sceneDepth(*values_, pictures_[0].look, job_.maker->picture());
    else views_->add(job_.maker->picture());
    ++next_;
    job_.maker.reset();
}

void ShownViews::step()
{
    try {
        window_.viewport().withContext([this] {
            if (!job_.maker) begin(next_);
            job_.maker->step();
            if (job_.maker->finished()) take();
        });
    } catch (const std::exception& failure) {
        fail(messageOf(failure));
        return;
    }
    if (next_ == pictures_.size()) {
        const std::shared_ptr<const printing::PrintViews> views = std::move(views_);
        stop();
        emit finished(views, depth_);
        return;
    }
    const double part = (static_cast<double>(next_) + (job_.maker ? job_.maker->progress() : 0)) / static_cast<double>(pictures_.size());
    const double seconds = static_cast<double>(elapsed_.elapsed()) / 1000;
    emit progressed(part, part > 0.02 ? seconds / part * (1 - part) : -1);
    timer_.start(0);
}

}  // namespace vitrine::ui

#include "moc_shown_views.cpp"
