#include "ui/explore/variations.h"

#include "exhibits/framework/table/random_values.h"
#include "ui/model/workbench.h"
#include "ui/parameters/panel_choices.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace vitrine::ui {
namespace {

constexpr int widest = 256;     // Width of a small picture in pixels.
constexpr int mostSamples = 4;  // Most samples per pixel.

}  // namespace

Variations::Variations(Workbench& workbench, const ParameterPanel& panel, QObject* parent)
    : QObject(parent), workbench_(workbench), panel_(panel)
{
    connect(&workbench.history(), &History::changesSettled, this, &Variations::changed);
    connect(&panel.choices(), &PanelChoices::changed, this, &Variations::changed);
    // Requests copy the viewport's, so they wait for its first picture.
    connect(&workbench.viewport().pictures(), &ViewportPictures::drawn, this, [this] {
        if (waiting_) order();
    });
}

const ParameterValues& Variations::shownValues() const
{
    return workbench_.history().sceneState().values[exhibit_];
}

void Variations::setSeen(bool seen)
{
    if (seen == seen_) return;
    seen_ = seen;
    if (seen) {
        order();
        return;
    }
    task_.cancel();
    workbench_.viewport().renderThread().post([&renderers = workbench_.renderers()] {
        renderers.forgetSmall();
        return std::function<void()>();
    });
}

std::uint64_t Variations::seedOf(int variation) const
{
    return static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(number_ - 1) +
           static_cast<std::uint64_t>(variation) + 1;
}

void Variations::drawAnew()
{
    clear();
    exhibit_ = workbench_.shown();
    base_ = shownValues();
    locked_ = panel_.choices().list(PanelChoice::locked);
    for (int i = 0; i < count; ++i)
        made_.at(static_cast<std::size_t>(i)) = variation(
            *base_, seedOf(i), [this](std::size_t row) { return panel_.isLocked(row); }, strength_);
    order();
    emit changed();
}

void Variations::clear()
{
    task_.cancel();
    base_.reset();
    made_ = {};
    images_ = {};
    finished_ = 0;
    failure_.clear();
    emit changed();
}

void Variations::order()
{
    task_.cancel();
    Viewport& viewport = workbench_.viewport();
    const bool wanted = seen_ && made() && finished_ < count;
    waiting_ = wanted && viewport.pictures().shown().image().isNull();
    if (!wanted || waiting_) return;
    struct Work {
        std::vector<SceneState> looks;
        int next;  // Index among the nine.
        FrameRequest request;
        QSize screen;
    };
    auto work = std::make_shared<Work>(
        Work{{}, finished_, viewport.pictures().shown().request(), viewport.pictures().shown().image().size()});
    for (int i = finished_; i < count; ++i) {
        work->looks.push_back(workbench_.history().sceneState());
        work->looks.back().values[exhibit_] = values(i);
    }
    if (work->screen.width() > widest) work->screen.scale(widest, 4 * widest, Qt::KeepAspectRatio);
    FrameRequest& request = work->request;
    request.raster = {};
    request.raster.size = {work->screen.width(), std::max(work->screen.height(), 1)};
    request.sample = 0;
    request.samples = std::min(pictureQuality(work->looks.front().hall()).supersamples, mostSamples);
    request.movingFrame = 0;
    request.mostExhibits = std::numeric_limits<int>::max();
    request.resetHistory = request.finished = true;
    request.idle = request.nonBlocking = request.runEverything = false;
    auto step = [this, work, &renderers = workbench_.renderers()](const RenderThread::Notify& notify) {
        const auto left = static_cast<std::size_t>(count - work->next);
        const SceneState& look = work->looks[work->looks.size() - left];
        QImage image = renderers.drawSmall(look, work->request, work->screen);
        const bool whole = ++work->request.sample >= work->request.samples;
        notify([this, number = work->next, image = std::move(image), whole] {
            images_.at(static_cast<std::size_t>(number)) = image;
            if (whole) finished_ = number + 1;
            emit changed();
        });
        if (whole) {
            work->request.sample = 0;
            ++work->next;
        }
        return work->next < count;
    };
    task_ = viewport.renderThread().start(std::move(step), [this](const QString& failure) {
        if (failure.isEmpty()) return;
        failure_ = failure;
        emit changed();
    });
}

std::optional<int> Variations::onShow() const
{
    if (!made()) return std::nullopt;
    for (int i = 0; i < count; ++i)
        if (values(i) == shownValues()) return i;
    return std::nullopt;
}

bool Variations::stale() const
{
    if (!made()) return false;
    return panel_.choices().list(PanelChoice::locked) != locked_ || (!(*base_ == shownValues()) && !onShow());
}

void Variations::pick(int i)
{
    if (!made()) return;
    SceneState next = workbench_.history().sceneState();
    next.values[exhibit_] = values(i);
    workbench_.history().change(tr("Take variation %1 of nine %2").arg(i + 1).arg(number_), next);
}

void Variations::goOnFrom(int i)
{
    if (!made()) return;
    pick(i);
    ++number_;
    drawAnew();
}

}  // namespace vitrine::ui

#include "moc_variations.cpp"
