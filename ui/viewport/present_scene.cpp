#include "ui/viewport/present_scene.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/museum/picture_settings.h"
#include "ui/viewport/exhibit_clock.h"
#include "ui/viewport/visitor.h"

#include <QWidget>
#include <QWindow>

#include <algorithm>
#include <utility>

namespace vitrine::ui {

PresentScene::PresentScene(const QWidget& viewport, const Museum& museum, const History& history,
                           const Visitor& visitor, const ExhibitClock& clock)
    : viewport_(viewport), museum_(museum), history_(history), visitor_(visitor), clock_(clock),
      files_(museum, history), prepared_(museum)
{
    files_.renew();
    rest_.setSingleShot(true);
    rest_.start(restsAfter);
    connect(&rest_, &QTimer::timeout, this, &PresentScene::rested);
    connect(&files_, &FileWatch::changed, this, [this] {
        change();
        emit filesChanged();
    });
    connect(&clock, &ExhibitClock::changed, this, &PresentScene::change);
    connect(&history, &History::changed, this, &PresentScene::takeValues);
    connect(&history, &History::replaced, this, &PresentScene::takeValues);
}

FrameRequest PresentScene::request() const
{
    return request(clock_.time());
}

FrameRequest PresentScene::request(double time) const
{
    FrameRequest wanted;
    const double aspect = static_cast<double>(viewport_.width()) / std::max(viewport_.height(), 1);
    wanted.camera = widened(visitor_.control().camera(), aspect);
    const QSize pixels = devicePixels();
    wanted.raster.size = {pixels.width(), pixels.height()};
    wanted.time = time;
    wanted.runEverything = runEverything_;
    if (visitor_.isInDepot()) wanted.alone = visitor_.subject();
    wanted.idle = !rest_.isActive();
    wanted.sincePressed = clock_.sincePressed(time);
    return wanted;
}

render::View PresentScene::view() const
{
    const FrameRequest now = request();
    return render::makeView(now.camera, now.raster);
}

QSize PresentScene::devicePixels() const
{
    return (QSizeF(viewport_.size()) * viewport_.devicePixelRatioF()).toSize().expandedTo({1, 1});
}

bool PresentScene::canBeSeen() const
{
    const QWindow* handle = viewport_.window()->windowHandle();
    return viewport_.width() > 0 && viewport_.height() > 0 && viewport_.isVisible() && handle && handle->isExposed();
}

void PresentScene::setRunEverything(bool on)
{
    runEverything_ = on;
    change();
}

const Prepared& PresentScene::prepared() const
{
    const Prepared& now = prepared_.of(state(), number_, request());
    if (!now.pending.empty()) emit reading();
    return now;
}

void PresentScene::takeValues()
{
    // Values that differ only in parameters without effect give the same picture, whose refinement goes on.
    std::vector<ParameterValues> acting;
    for (const ParameterValues& values : state().values) acting.push_back(actingValues(values));
    if (acting == acting_) return;
    acting_ = std::move(acting);
    files_.renew();
    rest_.start(restsAfter);
    emit valuesChanged();
    change();
}

void PresentScene::change()
{
    ++number_;
    emit changed();
}

void PresentScene::changeCamera(bool cut)
{
    ++number_;
    emit cameraChanged(cut);
}

}  // namespace vitrine::ui

#include "moc_present_scene.cpp"
