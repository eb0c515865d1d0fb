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
    void note(const ExportWish&);
    /// Whether there was one yet.
    [[nodiscard]] bool possible() const { return last_.has_value(); }
    /// Begins it and says when it is done. Does nothing where there was none yet.
    void run();

signals:
    /// One was begun by the visitor.
    void noted();

private:
    Workbench& window_;
    std::optional<ExportWish> last_;
};

}  // namespace vitrine::ui
