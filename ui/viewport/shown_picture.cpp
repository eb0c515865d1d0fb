#include "ui/viewport/shown_picture.h"

#include <QPainter>

namespace vitrine::ui {

void ShownPicture::show(const DrawnPicture& picture)
{
    image_ = picture.image;
    request_ = picture.order.request;
    order_ = picture.order.order;
    if (order_.sample == 0)
        region_ = {};
    else
        layRegionOver();
    ++pictures_;
}

void ShownPicture::showRegion(const DrawnPicture& picture)
{
    region_ = picture.image;
    place_ = *picture.order.region;
    layRegionOver();
    ++regions_;
}

void ShownPicture::layRegionOver()
{
    if (region_.isNull()) return;
    QPainter painter(&image_);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(QPoint(place_.offset.x, image_.height() - place_.offset.y - place_.size.y), region_);
}

}  // namespace vitrine::ui
