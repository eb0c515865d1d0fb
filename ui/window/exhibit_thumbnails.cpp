#include "ui/window/exhibit_thumbnails.h"

#include "exhibits/museum/museum.h"
#include "render/files/assets.h"
#include "ui/kit/picture_file.h"
#include "ui/kit/text.h"
#include "ui/kit/tile_delegate.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"
#include "ui/window/exhibit_list.h"

#include <QStandardPaths>

#include <string>

namespace vitrine::ui {
namespace {

QString keptThumbnail(const SceneObject& subject)
{
    const QString cache = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
    return cache + QStringLiteral("/vitrine/thumbnails/") + text(subject.name()) + QStringLiteral(".png");
}

}  // namespace

ExhibitThumbnails::ExhibitThumbnails(Workbench& workbench, ExhibitList& list, QObject* parent)
    : QObject(parent), workbench_(workbench), list_(list)
{
    showKept();
    connect(&workbench.viewport().pictures(), &ViewportPictures::drawn, this, &ExhibitThumbnails::keep);
}

void ExhibitThumbnails::showKept()
{
    const Museum& museum = workbench_.museum();
    for (std::size_t i = 0; i < museum.subjects().size(); ++i) {
        // A shipped thumbnail shows the exhibit's best view.
        const std::string shipped = "thumbnails/" + std::string(museum.subject(i).name()) + ".png";
        QPixmap picture(QString::fromStdString(render::asset(shipped).string()));
        if (picture.isNull()) picture.load(keptThumbnail(museum.subject(i)));
        if (!picture.isNull()) list_.setThumbnail(i, picture);
    }
}

void ExhibitThumbnails::keep()
{
    Viewport& viewport = workbench_.viewport();
    const std::size_t chosen = workbench_.chosen();
    if (!viewport.pictures().schedule().still() || list_.hasThumbnail(chosen)) return;
    const auto posed = chosen == hallIndex ? CameraControl::Mode::walk : CameraControl::Mode::orbit;
    if (viewport.visitor().mode() != posed) return;
    // Queued, because the picture is still being passed on.
    QMetaObject::invokeMethod(
        this,
        [this] {
            const QImage& picture = workbench_.viewport().pictures().shown().image();
            if (picture.isNull()) return;
            const QPixmap small = thumbnailOf(picture);
            list_.setThumbnail(workbench_.chosen(), small);
            saveThumbnail(keptThumbnail(workbench_.museum().subject(workbench_.chosen())), small.toImage());
        },
        Qt::QueuedConnection);
}

}  // namespace vitrine::ui

#include "moc_exhibit_thumbnails.cpp"
