#pragma once

#include "exhibits/museum/picture_settings.h"

#include <QRectF>
#include <QSize>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {

/// Returns where to draw a picture of another size in `room`: centered, with its own aspect ratio. Its scale is that of
/// the next picture, which fills the room (see `widened`). Sides beyond the room are cut off; missing sides stay empty.
[[nodiscard]] inline QRectF pictureIn(const QSize& picture, const QRectF& room)
{
    if (picture.isEmpty() || room.isEmpty()) return room;
    const auto viewHeight = [](double aspect) { return std::max(1.0, keptAspect / aspect); };
    const double aspect = static_cast<double>(picture.width()) / picture.height();
    const double high = room.height() * viewHeight(aspect) / viewHeight(room.width() / room.height());
    const double wide = high * aspect;
    if (std::abs(wide - room.width()) < 1 && std::abs(high - room.height()) < 1) return room;
    return {room.center().x() - wide / 2, room.center().y() - high / 2, wide, high};
}

}  // namespace vitrine::ui
