#pragma once

#include <QByteArray>
#include <QString>

class QImage;

namespace vitrine::ui {

/// Encodes the picture as PNG; empty if that fails.
[[nodiscard]] QByteArray pngOf(const QImage&);

/// Writes a small picture as PNG and makes its folder. Errors are ignored, because the picture can be made again.
void saveThumbnail(const QString& path, const QImage&);

}  // namespace vitrine::ui
