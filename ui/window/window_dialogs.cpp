#include "ui/window/window_dialogs.h"

#include "exhibits/museum/museum.h"
#include "ui/export/export_again.h"
#include "ui/export/picture_export.h"
#include "ui/export/screenshot_dialog.h"
#include "ui/jobs/job_dialog.h"
#include "ui/kit/text.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/lessons/page_dialog.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/print/print_dialog.h"
#include "ui/print/shown_views.h"
#include "ui/record/bookmarks.h"
#include "ui/study/table_export.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"

#include <QFileDialog>

namespace vitrine::ui {
namespace {

/// Shows a dialog in front of all other windows.
void bringUp(QWidget& dialog)
{
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

/// Returns the scene that is shown, for a job.
jobs::JobScene sceneOf(Workbench& workbench, const jobs::Job& job)
{
    const Museum& museum = workbench.museum();
    jobs::JobScene scene{&museum, workbench.history().sceneState(), workbench.chosen(), {}};
    if (!job.needs().anyScene) scene.subject = museum.find(job.needs().subject).value();
    scene.frame.camera = scene.state.camera;
    scene.frame.time = workbench.viewport().time();
    if (scene.subject != hallIndex) scene.frame.subject = scene.subject;
    return scene;
}

}  // namespace

WindowDialogs::WindowDialogs(Workbench& workbench, QWidget& window, Bookmarks& bookmarks, LessonController& lessons,
                             ExportAgain& again)
    : QObject(&window), workbench_(workbench), window_(window), bookmarks_(bookmarks), lessons_(lessons), again_(again)
{
}

void WindowDialogs::openAbout()
{
    (new AboutDialog(&window_))->show();
}

void WindowDialogs::openScreenshot()
{
    auto* dialog = new ScreenshotDialog(workbench_, &window_);
    connect(dialog, &ScreenshotDialog::begun, &again_, &ExportAgain::note);
    dialog->show();
}

void WindowDialogs::openPrint(const QString& print)
{
    auto* dialog = window_.findChild<PrintDialog*>();
    if (!dialog) dialog = new PrintDialog(new ShownViews(workbench_, &window_), &window_);
    bringUp(*dialog);
    if (!print.isEmpty()) dialog->open({print});
}

void WindowDialogs::openJob(const jobs::Job& job)
{
    JobDialog* dialog = nullptr;
    for (JobDialog* open : window_.findChildren<JobDialog*>())
        if (&open->job() == &job) dialog = open;
    if (!dialog)
        dialog = new JobDialog(
            job, [&workbench = workbench_, &job] { return sceneOf(workbench, job); }, workbench_.renderers(),
            workbench_.viewport().renderThread(), &window_);
    connect(&bookmarks_, &Bookmarks::changed, dialog, &JobDialog::refresh, Qt::UniqueConnection);
    bringUp(*dialog);
}

void WindowDialogs::saveTour()
{
    auto* dialog = new QFileDialog(&window_, tr("Save as a tour"), QStringLiteral("tour.json"), tr("Tours (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    connect(dialog, &QFileDialog::fileSelected, &bookmarks_, &Bookmarks::saveAs);
    dialog->open();
}

void WindowDialogs::openPage(std::size_t subject)
{
    openPage(text(workbench_.museum().subject(subject).name()));
}

void WindowDialogs::openPage(const QString& page)
{
    auto* dialog = window_.findChild<PageDialog*>();
    if (!dialog) {
        dialog = new PageDialog(&window_, [this](const QString& name) -> const Parameters* {
            const auto found = workbench_.museum().find(name.toStdString());
            return found ? &workbench_.history().sceneState().values[*found].table() : nullptr;
        });
        connect(dialog, &PageDialog::lessonAsked, this, [this](const QString& exhibit) {
            if (const auto found = workbench_.museum().find(exhibit.toStdString())) lessons_.start(*found);
        });
    }
    dialog->showPage(page);
    bringUp(*dialog);
}

void WindowDialogs::closeAll()
{
    qDeleteAll(window_.findChildren<PreferencesDialog*>());
    qDeleteAll(window_.findChildren<PrintDialog*>());
    qDeleteAll(window_.findChildren<JobDialog*>());
    qDeleteAll(window_.findChildren<TableExport*>());
    qDeleteAll(window_.findChildren<PictureExport*>());
}

}  // namespace vitrine::ui

#include "moc_window_dialogs.cpp"
