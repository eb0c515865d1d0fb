#include "ui/viewport/gl_probe.h"

#include "ui/viewport/viewport_format.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

namespace vitrine::ui {

QString whyNoOpenGl()
{
    QOpenGLContext context;
    context.setFormat(viewportFormat());
    QOffscreenSurface surface;
    surface.setFormat(viewportFormat());
    surface.create();
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface))
        return QObject::tr("OpenGL 4.5 is needed, but no OpenGL context could be made: install a graphics driver, "
                           "or Mesa's software renderer (package libgl1-mesa-dri).");
    const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QString renderer = QString::fromUtf8(name ? name : "unknown");
    const std::pair<int, int> version = context.format().version();
    context.doneCurrent();
    if (version >= std::pair(4, 5) && context.format().profile() == QSurfaceFormat::CoreProfile) return {};
    return QObject::tr("OpenGL %1.%2 found, 4.5 core needed (%3): update the graphics driver, or install Mesa's "
                       "software renderer (package libgl1-mesa-dri).")
        .arg(version.first)
        .arg(version.second)
        .arg(renderer);
}

}  // namespace vitrine::ui
