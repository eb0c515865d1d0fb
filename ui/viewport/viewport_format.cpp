#include "ui/viewport/viewport_format.h"

namespace vitrine::ui {

QSurfaceFormat viewportFormat()
{
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapInterval(1);
#ifndef NDEBUG
    format.setOption(QSurfaceFormat::DebugContext);
#endif
    return format;
}

}  // namespace vitrine::ui
