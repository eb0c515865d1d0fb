#include "ui/kit/picture_file.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"

#include <QBuffer>
#include <QImage>

namespace vitrine::ui {

QByteArray pngOf(const QImage& picture)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    return picture.save(&buffer, "PNG") ? bytes : QByteArray();
}

void saveThumbnail(const QString& path, const QImage& picture)
{
    try {
        render::atomicWriteMakingFolder(path.toStdString(), pngOf(picture).toStdString());
    } catch (const Failure& failure) {
        qWarning("%s", failure.what());
    }
}

}  // namespace vitrine::ui
