#include "ui/print/view_loader.h"

#include "ui/print/shown_views.h"

#include <QFileInfo>

#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int renderAfter = 400;  // Milliseconds without a change.

}  // namespace

ViewLoader::ViewLoader(ShownViews* shown, QObject* parent) : QObject(parent), shown_(shown), read_(this)
{
    soon_.setSingleShot(true);
    soon_.setInterval(renderAfter);
    connect(&soon_, &QTimer::timeout, this, [this] {
        if (full_ || !possible_) return;
        wanted_ = false;
        shown_->start(values_, true);
    });
    connect(&read_, &ProgressJob::progressed, this,
            [this](double part) { emit said(tr("Reading, %1 %").arg(std::lround(part * 100))); });
    connect(&read_, &ProgressJob::failed, this, [this](const QString& why) {
        emit said(tr("No views could be read."));
        emit failed(why);
    });
    if (shown_) connectShown();
}

void ViewLoader::connectShown()
{
    shown_->setParent(this);
    connect(shown_, &ShownViews::progressed, this, [this](double part, double secondsLeft) {
        emit said(tr("Rendering views, %1 %").arg(std::lround(part * 100)));
        if (full_) emit progressed(part, secondsLeft);
    });
    connect(shown_, &ShownViews::finished, this,
            [this](const std::shared_ptr<const printing::PrintViews>& views, const printing::SceneDepth& depth) {
                const bool full = std::exchange(full_, false);
                take(views, depth, !full);
                if (full) emit readyForPrint();
            });
    connect(shown_, &ShownViews::failed, this, [this](const QString& why) {
        full_ = false;
        emit said(tr("No views could be rendered."));
        emit failed(why);
    });
}

bool ViewLoader::fromWindow() const
{
    return values_[printing::printTable().origin] == printing::ViewOrigin::shown;
}

void ViewLoader::load(const ParameterValues& values)
{
    values_ = values;
    if (fromWindow()) {
        read_.stop();
        draft_ = wanted_ = true;
        soon_.start();
        return;
    }
    wanted_ = false;
    soon_.stop();
    if (shown_) shown_->stop();
    depth_.reset();
    read();
}

void ViewLoader::read()
{
    if (printing::picturesOf(values_).empty()) {
        views_.reset();
        read_.stop();
        const bool quilt = values_[printing::printTable().origin] == printing::ViewOrigin::quilt;
        emit said(quilt ? tr("Choose a picture with a grid of views, or drop it here.")
                        : tr("Choose a folder or pictures, or drop them here."));
        emit changed();
        return;
    }
    emit said(tr("Reading"));
    read_.start([this, values = values_](const ProgressJob::Progress& progress) -> ProgressJob::Outcome {
        const std::shared_ptr<const printing::PrintViews> views = printing::readViews(values, progress);
        return [this, views] { take(views, std::nullopt, false); };
    });
}

void ViewLoader::take(std::shared_ptr<const printing::PrintViews> views,
                      const std::optional<printing::SceneDepth>& depth, bool draft)
{
    views_ = std::move(views);
    depth_ = depth;
    draft_ = draft;
    const std::vector<std::string> files = fromWindow() ? std::vector<std::string>() : printing::picturesOf(values_);
    const QString from = files.empty()       ? tr("what is shown")
                         : files.size() == 1 ? QFileInfo(QString::fromStdString(files.front())).fileName()
                                             : tr("%1 pictures").arg(files.size());
    emit said(draft ? tr("%1 views of %2, as small previews").arg(views_->count()).arg(from)
                    : tr("%1 views from %2").arg(views_->count()).arg(from));
    emit changed();
}

void ViewLoader::setPossible(bool possible)
{
    possible_ = possible;
    if (wanted_ && possible_ && !soon_.isActive()) soon_.start();
}

void ViewLoader::renderInFull()
{
    soon_.stop();
    full_ = true;
    shown_->start(values_, false);
}

void ViewLoader::stop()
{
    full_ = false;
    if (shown_) shown_->stop();
}

bool ViewLoader::busy() const
{
    return read_.running() || soon_.isActive() || (shown_ && shown_->running());
}

}  // namespace vitrine::ui

#include "moc_view_loader.cpp"
