#pragma once

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace vitrine::ui {

/// "picture-2.png" for "picture.png", "print-3.tif" for "print-2.tif": the next name in the same folder that nothing
/// has yet.
[[nodiscard]] QString nextFreePath(const QString& path);

/// Calls `write` with the path to write to: at once when neither it nor one of `beside` is there, otherwise when the
/// visitor has said whether the old file goes or the new one takes the next free name; not at all when he says neither.
/// Does not block.
void askBeforeReplacing(QWidget* parent, const QString& path, std::function<void(const QString&)> write,
                        const QStringList& beside = {});

}  // namespace vitrine::ui
