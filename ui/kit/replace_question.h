#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace vitrine::ui {

/// Returns the next free name in the same folder: "picture-2.png" for "picture.png", "print-3.tif" for "print-2.tif".
[[nodiscard]] QString nextFreePath(const QString& path);

/// Calls `write` with the path to write to. If neither it nor a file of `beside` exists, this happens at once.
/// Otherwise the visitor is asked to replace the file, to use the next free name, or to cancel, in which case `write`
/// is not called. Does not block.
void askBeforeReplacing(QWidget* parent, const QString& path, std::function<void(const QString&)> write,
                        const QStringList& beside = {});

}  // namespace vitrine::ui
