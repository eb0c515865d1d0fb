#pragma once

#include "ui/export/picture_export.h"

#include <QObject>

#include <optional>

namespace vitrine::ui {

/// Repeats the window's last export of a picture with the present view: the same size, samples and format, under the
/// next free name in the same folder.
class ExportAgain final : public QObject {
    Q_OBJECT

public:
    /// `parent` is the window, which is the parent of all exports. The workbench must outlive this object.
    ExportAgain(Workbench&, QObject& parent);

    /// Remembers an export that the visitor began.
    void note(const ExportRequest&);
    /// Returns whether there was an export yet.
    [[nodiscard]] bool possible() const { return last_.has_value(); }
    /// Begins the export and reports its end. Does nothing if there was none yet.
    void run();

signals:
    /// Emitted when an export was remembered.
    void noted();

private:
    Workbench& window_;
    std::optional<ExportRequest> last_;
};

}  // namespace vitrine::ui
