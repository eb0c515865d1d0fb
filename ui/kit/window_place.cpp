#include "ui/kit/window_place.h"

#include <QByteArray>
#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace vitrine::ui {
namespace {

// Pixels of title bar and borders on common desktops. They are unknown before the window is shown.
constexpr int titleBar = 40;
constexpr int border = 8;
constexpr int offset = 32;

}  // namespace

void restorePlace(QWidget& window, const QByteArray& kept, int before)
{
    if (!window.restoreGeometry(kept) || window.isMaximized() || window.isFullScreen()) return;
    const QRect room = window.screen()->availableGeometry().adjusted(border, titleBar, -border, -border);
    QRect place = window.geometry();
    place.setSize(place.size().boundedTo(room.size()));
    place.translate(before * offset, before * offset);
    place.moveTo(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()),
                 std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
    if (place != window.geometry()) window.setGeometry(place);
}

}  // namespace vitrine::ui
