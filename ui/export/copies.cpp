#include "ui/export/copies.h"

#include "exhibits/museum/render_command.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QClipboard>
#include <QGuiApplication>

namespace vitrine::ui {

void copyPicture(Workbench& window)
{
    const QImage& picture = window.viewport().pictures().shown().image();
    if (picture.isNull()) return;  // There is no picture yet.
    QGuiApplication::clipboard()->setImage(picture);
    window.say(
        MessageStrip::Mood::notice,
        QObject::tr("The picture is on the clipboard, %1 × %2 pixels.").arg(picture.width()).arg(picture.height()));
}

QString commandLineOf(Workbench& window)
{
    Viewport& viewport = window.viewport();
    QString line =
        QString::fromStdString(renderCommand(window.museum(), window.history().sceneState(), viewport.scene().request(),
                                             viewport.pictures().schedule().samples(), "picture.png"));
    // The plaques in the picture depend on the language.
    const QString asked = QStringLiteral("vitrine --language %1 ").arg(languageCode());
    if (languageCode() != QLatin1String("en")) line.replace(0, static_cast<qsizetype>(sizeof "vitrine"), asked);
    return line;
}

void copyCommandLine(Workbench& window)
{
    QGuiApplication::clipboard()->setText(commandLineOf(window));
    window.say(MessageStrip::Mood::notice,
               QObject::tr("Copied a command line that renders this picture into picture.png."));
}

}  // namespace vitrine::ui
