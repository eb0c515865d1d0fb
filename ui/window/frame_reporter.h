#pragma once

#include "render/plan/diagnostics.h"

#include <QObject>

#include <vector>

class QSize;

namespace vitrine::render {
struct FrameReport;
}

namespace vitrine::ui {

class StatusLine;
class WindowDocks;
class Workbench;

/// Passes the report of each drawn picture on: to the status line, the frame report, the animated parameters, the log,
/// and, where files could not be read or drawing failed, to the messages.
class FrameReporter final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object.
    FrameReporter(Workbench&, WindowDocks&, StatusLine&, QObject* parent);

private:
    void note(const render::FrameReport&, const QSize& pixels);
    void showComplaints(const std::vector<render::CulledPass>&);

    Workbench& workbench_;
    WindowDocks& docks_;
    StatusLine& status_;
    render::Diagnostics logged_;  // Complaints that are in the log already.
};

}  // namespace vitrine::ui
