#include "ui/jobs/picture_preview.h"

#include "ui/kit/theme.h"

#include <QPainter>

#include <utility>

namespace vitrine::ui {
namespace {

constexpr int checkSize = 8;  // Pixels of a square of the checkerboard.

}  // namespace

PicturePreview::PicturePreview(QWidget* parent) : JobPreview(parent)
{
    setMinimumSize(240, 160);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
    setToolTip(tr("The result, smaller or coarser."));
}

std::function<void()> PicturePreview::prepare(const jobs::JobRun& run, const ParameterValues&, const ParameterValues&)
{
    QImage picture = imageWithOpacity(run.previewPicture());
    return [this, picture = std::move(picture)] { setPicture(picture); };
}

void PicturePreview::setPicture(QImage picture)
{
    picture_ = std::move(picture);
    update();
}

void PicturePreview::paintEvent(QPaintEvent*)
{
    if (picture_.isNull()) return;
    QPainter painter(this);
    const QSize size = picture_.size().scaled(this->size(), Qt::KeepAspectRatio);
    const QRect place(QPoint((width() - size.width()) / 2, (height() - size.height()) / 2), size);
    painter.setClipRect(place);
    painter.fillRect(place, theme().base);
    for (int y = place.top(); y <= place.bottom(); y += checkSize)
        for (int x = place.left() + (y - place.top()) / checkSize % 2 * checkSize; x <= place.right();
             x += 2 * checkSize)
            painter.fillRect(x, y, checkSize, checkSize, theme().window);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, picture_);
}

}  // namespace vitrine::ui

#include "moc_picture_preview.cpp"
