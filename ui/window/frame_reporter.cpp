#include "ui/window/frame_reporter.h"

#include "exhibits/museum/museum.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/report/frame_report_dock.h"
#include "ui/report/log_view.h"
#include "ui/viewport/viewport.h"
#include "ui/window/parameter_tabs.h"
#include "ui/window/status_line.h"
#include "ui/window/window_docks.h"

namespace vitrine::ui {

FrameReporter::FrameReporter(Workbench& workbench, WindowDocks& docks, StatusLine& status, QObject* parent)
    : QObject(parent), workbench_(workbench), docks_(docks), status_(status)
{
    connect(&workbench.viewport().pictures(), &ViewportPictures::drawn, this, &FrameReporter::note);
    connect(&workbench.viewport().pictures(), &ViewportPictures::failed, this,
            [this](const QString& message) { workbench_.setProblems(QStringLiteral("drawing"), {message}); });
}

void FrameReporter::note(const render::FrameReport& report, const QSize& pixels)
{
    Viewport& viewport = workbench_.viewport();
    workbench_.setProblems(QStringLiteral("drawing"), {});
    status_.note(report, pixels, viewport.pictures().reason());
    docks_.frameReport().note(report);
    docks_.parameters().panel().showMoment(workbench_.museum().animationTime(
        workbench_.history().sceneState(), workbench_.shown(), viewport.pictures().shown().request()));
    showComplaints(report.skipped);
}

void FrameReporter::showComplaints(const std::vector<render::CulledPass>& skipped)
{
    for (const render::CulledPass& complaint : logged_.begun(skipped))
        if (complaint.unreadable.empty()) docks_.log().add(translatedText(lineOf(complaint)));
    QStringList unreadable;  // Messages are also written to the log.
    for (const render::CulledPass& complaint : skipped)
        if (complaint.complaint && !complaint.unreadable.empty()) unreadable << translatedText(lineOf(complaint));
    workbench_.setProblems(QStringLiteral("files that are drawn"), unreadable);
}

}  // namespace vitrine::ui

#include "moc_frame_reporter.cpp"
