#include "ui/window/run_window.h"

#include "exhibits/exhibits.h"
#include "render/failure.h"
#include "ui/kit/appearance.h"
#include "ui/kit/language.h"
#include "ui/viewport/gl_probe.h"
#include "ui/viewport/museum_renderers.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_format.h"
#include "ui/window/application.h"
#include "ui/window/file_opener.h"
#include "ui/window/first_picture.h"
#include "ui/window/main_window.h"
#include "ui/window/window_actions.h"

#include <QSurfaceFormat>
#include <QTemporaryDir>

#include <clocale>
#include <cstdio>

namespace vitrine::ui {

bool hasDisplay()
{
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
}

int runWindow(int& argc, char** argv, const WindowOptions& options)
{
    if (!hasDisplay()) {
        std::fprintf(stderr,
                     "vitrine: there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set); "
                     "\"vitrine --help\" lists what works without one.\n");
        return noDisplay;
    }
    // OpenGL objects of the viewport survive undocking and reparenting.
    QApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QSurfaceFormat::setDefaultFormat(viewportFormat());
    Application app(argc, argv);
    // QApplication sets the user's locale; numbers in shaders and files have decimal points.
    std::setlocale(LC_NUMERIC, "C");
    QApplication::setApplicationName(QStringLiteral("vitrine"));
    QApplication::setApplicationDisplayName(QStringLiteral("Vitrine"));
    QApplication::setDesktopFileName(QStringLiteral("org.vitrine.Vitrine"));
    // Before the museum is built, because its plaques are in the window's language.
    setLanguage(languageAsked() ? languageCode() : languageOfWindow());
    if (const QString why = whyNoOpenGl(); !why.isEmpty()) {
        std::fprintf(stderr, "vitrine: %s\n", qPrintable(why));
        return static_cast<int>(ErrorKind::openGl);
    }
    applyAppearance(app, Preferences::saved(), {});
    const Museum museum{allExhibits()};
    MuseumRenderers renderers(museum);
    std::optional<QTemporaryDir> apart;
    if (options.kiosk) {
        // An exhibition neither continues a session nor replaces it.
        apart.emplace();
        qputenv("XDG_STATE_HOME", apart->path().toLocal8Bit());
    }
    MainWindow window(museum, renderers, makeWindowActions);
    QObject::connect(&app, &Application::caught, &window,
                     [&window](const QString& message) { window.say(MessageStrip::Mood::problem, message); });
    reportFirstPicture(window.viewport(), window);
    if (!options.kiosk) window.show();
    for (const std::string& file : options.files) window.files().open(QString::fromStdString(file));
    std::optional<Kiosk> kiosk;
    if (options.kiosk) {
        kiosk.emplace(window, *options.kiosk);
        window.show();
    }
    const std::shared_ptr<void> kept = options.opened ? options.opened(window) : nullptr;
    return QApplication::exec();
}

}  // namespace vitrine::ui
