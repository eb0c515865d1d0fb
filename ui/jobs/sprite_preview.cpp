#include "ui/jobs/sprite_preview.h"

#include "exhibits/jobs/sprite/sprite_job.h"
#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr double shortestTurn = 0.25;  ///< Seconds that a direction is shown at least.

}  // namespace

SpritePreview::SpritePreview(QWidget* parent) : JobPreview(parent)
{
    setMinimumSize(240, 240);
    setAccessibleName(tr("Preview"));
    setToolTip(tr("The sprite from all its sides. The cross is its pivot."));
    connect(&timer_, &QTimer::timeout, this, &SpritePreview::next);
}

std::function<void()> SpritePreview::prepare(const jobs::JobRun& run, const ParameterValues& all,
                                             const ParameterValues& drawn)
{
    const jobs::SpriteSheet& sheet = *static_cast<const jobs::SpriteRun&>(run).sheet();
    const jobs::SpriteTable& t = jobs::spriteTable();
    auto shown = std::make_shared<Shown>();
    shown->picture = imageWithOpacity(sheet.color);
    shown->cells = sheet.cells;
    for (const glm::ivec2 pivot : sheet.pivots) shown->pivots.emplace_back(pivot.x, pivot.y);
    shown->frame = {drawn[t.width], drawn[t.height]};
    shown->frames = drawn[t.frames];
    // The draft's fewer frames last as long as all frames would.
    const bool atRate = all[t.framesPerSecond] > 0 && all[t.frames] > 0;
    shown->seconds = sheet.frameSeconds * (atRate ? static_cast<double>(all[t.frames]) / drawn[t.frames] : 1);
    return [this, shown] { setShown(shown); };
}

void SpritePreview::setShown(std::shared_ptr<const Shown> shown)
{
    shown_ = std::move(shown);
    if (!shown_ || cell_ >= static_cast<int>(shown_->cells.size())) cell_ = 0;
    if (shown_) {
        const double each = shown_->frames == 1 ? std::max(shown_->seconds, shortestTurn) : shown_->seconds;
        timer_.setInterval(static_cast<int>(std::lround(std::clamp(each, 0.015, 10.0) * 1000)));
    }
    if (shown_ && isVisible())
        timer_.start();
    else
        timer_.stop();
    update();
}

QString SpritePreview::accessibleText() const
{
    if (!shown_) return tr("Nothing is drawn yet.");
    return tr("%1 directions of %2 frames, each %3 × %4 pixels.")
        .arg(static_cast<int>(shown_->cells.size()) / std::max(shown_->frames, 1))
        .arg(shown_->frames)
        .arg(shown_->frame.width())
        .arg(shown_->frame.height());
}

void SpritePreview::next()
{
    cell_ = (cell_ + 1) % static_cast<int>(shown_->cells.size());
    update();
}

void SpritePreview::showEvent(QShowEvent*)
{
    if (shown_) timer_.start();
}

void SpritePreview::hideEvent(QHideEvent*)
{
    timer_.stop();
}

void SpritePreview::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (!shown_) return;
    const jobs::SpriteCell& cell = shown_->cells[static_cast<std::size_t>(cell_)];
    // Each pixel of the sprite covers a whole number of screen pixels, unless the sprite is too large for that.
    const double room = std::min(0.9 * width() / shown_->frame.width(), 0.9 * height() / shown_->frame.height());
    const double scale = room >= 1 ? std::floor(room) : room;
    const QSizeF whole = QSizeF(shown_->frame) * scale;
    const QPointF corner(std::floor((width() - whole.width()) / 2), std::floor((height() - whole.height()) / 2));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawRect(QRectF(corner, whole).adjusted(-1, -1, 0, 0));
    painter.drawImage(
        QRectF(corner + QPointF(cell.cutOff.x, cell.cutOff.y) * scale, QSizeF(cell.size.x, cell.size.y) * scale),
        shown_->picture, QRectF(cell.place.x, cell.place.y, cell.size.x, cell.size.y));
    const QPointF pivot = corner + QPointF(shown_->pivots[static_cast<std::size_t>(cell_)]) * scale;
    painter.setPen(theme().accent);
    painter.drawLine(pivot - QPointF(5, 0), pivot + QPointF(5, 0));
    painter.drawLine(pivot - QPointF(0, 5), pivot + QPointF(0, 5));
}

}  // namespace vitrine::ui

#include "moc_sprite_preview.cpp"
