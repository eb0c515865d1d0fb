#pragma once

#include "ui/window/picture_export.h"

#include <QObject>

#include <optional>

namespace vitrine::ui {

/// The window's last export of a picture, once more with what is seen now: the same size, samples and format, under the
/// next free name in the same folder.
class ExportAgain final : public QObject {
    Q_OBJECT

public:
    /// `parent` is the window itself: whose children exports are. It must outlive this.
    ExportAgain(Workbench&, QObject& parent);

    /// One was begun by the visitor.
    void note(const ExportWish& wish) { last_ = wish; }
    /// Begins it and says when it is done; says what to do first where there was none yet.
    void run();

private:
    Workbench& window_;
    std::optional<ExportWish> last_;
};

}  // namespace vitrine::ui
