#pragma once

#include <QByteArray>
#include <QString>

class QImage;

namespace vitrine::ui {

/// The picture as PNG; empty where it cannot be encoded.
[[nodiscard]] QByteArray pngOf(const QImage&);

/// Writes a small picture that can be made again, as PNG; makes its folder. Where that fails there is none.
void saveThumbnail(const QString& path, const QImage&);

}  // namespace vitrine::ui
