#include "ui/compare/picture_b.h"

#include "ui/model/settings_b.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <utility>

namespace vitrine::ui {

PictureB::PictureB(Viewport& viewport, Renderers& renderers, const SettingsB& other, QObject* parent)
    : QObject(parent), viewport_(viewport), renderers_(renderers), other_(other)
{
    connect(&viewport.pictures(), &ViewportPictures::drawn, this, &PictureB::follow);
    connect(&viewport.scene(), &PresentScene::filesChanged, this, &PictureB::order);
    connect(&other, &SettingsB::changed, this, [this] {
        failure_.clear();
        pictured_.reset();
        order();
    });
}

bool PictureB::present() const
{
    return pictured_ && pictured_->serves(sight());
}

bool PictureB::Sight::serves(const Sight& wanted) const
{
    return camera == wanted.camera && time == wanted.time && sincePressed == wanted.sincePressed &&
           screen == wanted.screen && runEverything == wanted.runEverything &&
           (idle || (!wanted.idle && scale >= wanted.scale));
}

PictureB::Sight PictureB::sight() const
{
    const FrameRequest& request = viewport_.pictures().shown().request();
    const DrawOrder& order = viewport_.pictures().shown().order();
    return {request.camera,
            request.time,
            request.sincePressed,
            viewport_.pictures().shown().image().size(),
            request.runEverything,
            order.scale,
            order.scale == 1 && order.samples == viewport_.pictures().schedule().samples()};
}

void PictureB::follow(const render::FrameReport& report)
{
    if (report.unfinished) {
        // A and B share the program families, of which one program is built at a time: A's first.
        if (finished_) return;
        task_.cancel();
        ordered_.reset();
    } else if (wanted_ && !(ordered_ && ordered_->serves(sight()))) {
        order();
    }
}

void PictureB::setWanted(bool wanted)
{
    if (wanted == wanted_) return;
    wanted_ = wanted;
    viewport_.pictures().setWhole(wanted);
    if (wanted) {
        order();
        return;
    }
    task_.cancel();
    ordered_.reset();
    failure_.clear();
    viewport_.renderThread().post([&renderers = renderers_] {
        renderers.forgetOther();
        return std::function<void()>();
    });
    forget();
}

void PictureB::forget()
{
    image_ = {};
    report_ = {};
    pictured_.reset();
    finished_ = false;
    emit gone();
}

void PictureB::fail(const QString& why)
{
    const bool said = std::exchange(failure_, why) == why;
    forget();
    if (!said) emit failed(why);
}

void PictureB::order()
{
    if (!wanted_ || !other_.isSet() || viewport_.pictures().shown().image().isNull()) return;
    const Sight wanted = sight();
    struct Work {
        SceneState sceneState;
        FrameRequest request;
        QSize screen;
    };
    auto work =
        std::make_shared<Work>(Work{other_.sceneState(), viewport_.pictures().shown().request(), wanted.screen});
    const PictureQuality quality = pictureQuality(work->sceneState.hall());
    FrameRequest& request = work->request;
    request.raster.size = glm::max(glm::ivec2(glm::round(glm::dvec2(wanted.screen.width(), wanted.screen.height()) *
                                                         (wanted.scale * quality.resolutionScale))),
                                   glm::ivec2(1));
    request.sample = 0;
    request.samples = wanted.idle ? std::min(quality.supersamples, viewport_.pictures().schedule().mostSamples()) : 1;
    // Its history may be outdated, and the picture is not drawn again.
    request.resetHistory = request.finished = true;
    request.idle = false;  // A may be idle while B has just changed.
    ordered_ = wanted;
    finished_ = false;
    auto step = [this, wanted, work, &renderers = renderers_](const RenderThread::Notify& notify) {
        OtherDrawn made = renderers.drawOther(work->sceneState, work->request, work->screen);
        const bool more = ++work->request.sample < work->request.samples;
        notify([this, wanted, made = std::move(made), more] {
            image_ = made.image;
            report_ = made.report;
            pictured_ = wanted;
            finished_ = !more;
            ++picturesDrawn_;
            failure_.clear();
            emit drawn();
        });
        return more;
    };
    task_ = viewport_.renderThread().start(std::move(step), [this](const QString& failure) {
        if (!failure.isEmpty()) fail(failure);
    });
}

}  // namespace vitrine::ui

#include "moc_picture_b.cpp"
