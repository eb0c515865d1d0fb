#include "ui/window/first_picture.h"

#include "render/measure/clock.h"
#include "ui/viewport/viewport.h"

#include <cstdio>
#include <memory>

namespace vitrine::ui {

void reportFirstPicture(Viewport& viewport, QWidget& window)
{
    if (!qEnvironmentVariableIsSet("VITRINE_FIRST_PICTURE")) return;
    const auto drawn = std::make_shared<QSize>();
    QObject::connect(&viewport, &Viewport::drawn, &window,
                     [drawn](const render::FrameReport&, const QSize& pixels) { *drawn = pixels; });
    // What was drawn is seen when the window's buffers have been swapped.
    QObject::connect(&viewport, &QOpenGLWidget::frameSwapped, &window, [drawn, &window] {
        if (drawn->isEmpty()) return;
        std::printf("first picture at %.6f s, %dx%d\n", render::wallSeconds(), drawn->width(), drawn->height());
        std::fflush(stdout);
        *drawn = QSize();
        window.close();
    });
}

}  // namespace vitrine::ui
