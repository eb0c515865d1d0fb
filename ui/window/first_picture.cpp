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
    const auto shown = std::make_shared<bool>(false);
    QObject::connect(&viewport.pictures(), &ViewportPictures::drawn, &window,
                     [drawn](const render::FrameReport&, const QSize& pixels) { *drawn = pixels; });
    // A picture is visible once the window's buffers have been swapped.
    QObject::connect(&viewport, &QOpenGLWidget::frameSwapped, &window, [drawn, shown, &viewport, &window] {
        if (drawn->isEmpty()) return;
        if (!*shown)
            std::printf("first picture at %.6f s, %dx%d\n", render::wallSeconds(), drawn->width(), drawn->height());
        *shown = true;
        *drawn = QSize();
        if (viewport.pictures().schedule().opening()) return;
        std::printf("all at %.6f s\n", render::wallSeconds());
        std::fflush(stdout);
        window.close();
    });
}

}  // namespace vitrine::ui
