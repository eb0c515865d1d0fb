#include "ui/window/window_dialogs.h"

#include "exhibits/jobs.h"
#include "exhibits/museum/museum.h"
#include "ui/export/export_dialog.h"
#include "ui/export/picture_export.h"
#include "ui/jobs/export_again.h"
#include "ui/jobs/job_dialog.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/lessons/lesson_controller.h"
#include "ui/lessons/page_dialog.h"
#include "ui/model/history.h"
#include "ui/model/settings_b.h"
#include "ui/model/workbench.h"
#include "ui/preferences/preferences_dialog.h"
#include "ui/print/print_dialog.h"
#include "ui/print/shown_views.h"
#include "ui/record/bookmarks.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"
#include "ui/window/job_scene.h"

#include <QFileDialog>

#include <set>

namespace vitrine::ui {
namespace {

/// Shows a dialog in front of all other windows.
void bringUp(QWidget& dialog)
{
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

/// Returns the settings of a page for its presets.
ExportSettings settingsOf(JobDialog& page)
{
    return {&page.job(), [&page] { return page.setup().values(); },
            [&page](const QString& undoText, const ParameterValues& values) { page.setup().change(undoText, values); }};
}

ExportSettings settingsOf(PrintDialog& page)
{
    return {jobs::findJob("print"), [&page] { return page.values(); },
            [&page](const QString& undoText, const ParameterValues& values) { page.change(undoText, values); }};
}

}  // namespace

WindowDialogs::WindowDialogs(Workbench& workbench, QWidget& window, SettingsB& other, Bookmarks& bookmarks,
                             LessonController& lessons, ExportAgain& again)
    : QObject(&window), workbench_(workbench), window_(window), other_(other), bookmarks_(bookmarks), lessons_(lessons),
      again_(again)
{
    connect(&workbench.viewport().pictures(), &ViewportPictures::drawn, this,
            [this](const render::FrameReport& report, const QSize& pixels) {
                const double samples = static_cast<double>(pixels.width()) * pixels.height();
                if (samples > 0) secondsPerSample_ = report.milliseconds / 1000 / samples;
            });
}

void WindowDialogs::openAbout()
{
    (new AboutDialog(&window_))->show();
}

std::vector<ExportKind> WindowDialogs::exportKinds()
{
    std::vector<ExportKind> kinds;
    for (const auto& each : jobs::allJobs()) {
        const jobs::Job& job = *each;
        const std::string_view subject = job.needs().subject;
        if (!job.needs().inWindow) continue;
        kinds.push_back(
            {text(job.name()), translatedText(std::string(job.product())),
             [this, &job](QWidget* parent) { return makeJobPage(job, parent); },
             [](const QDialog& page) { return static_cast<const JobDialog&>(page).exporting(); },
             subject.empty() || workbench_.museum().find(subject) ? QString() : tr("This museum lacks its exhibit."),
             [](QDialog& page) { return settingsOf(static_cast<JobDialog&>(page)); }});
    }
    const auto print = [this](QWidget* parent) {
        return new PrintDialog(new ShownViews(workbench_, &window_), parent);
    };
    kinds.push_back({QStringLiteral("print"), tr("Lenticular print"), print,
                     [](const QDialog& page) { return static_cast<const PrintDialog&>(page).exporting(); }, QString(),
                     [](QDialog& page) { return settingsOf(static_cast<PrintDialog&>(page)); }});
    return kinds;
}

QDialog* WindowDialogs::makeJobPage(const jobs::Job& job, QWidget* parent)
{
    auto* page = new JobDialog(
        job,
        [this, &job] {
            jobs::JobScene scene = jobSceneOf(workbench_, other_, job);
            scene.usual.secondsPerSample = secondsPerSample_;
            return scene;
        },
        workbench_.renderers(), workbench_.viewport().renderThread(), parent);
    connect(&bookmarks_, &Bookmarks::changed, page, &JobDialog::refresh);
    if (job.needs().twoSettings) connect(&other_, &SettingsB::changed, page, &JobDialog::refresh);
    if (job.name() == "render") {
        connect(page, &JobDialog::exportBegun, &again_,
                [this, page] { again_.note(page->setup().values(), page->path()); });
    }
    connect(&workbench_.history(), &History::changesSettled, page,
            [page, needed = workbench_.museum().find(job.needs().subject)](const std::set<std::size_t>& changed) {
                if (!needed || changed.count(*needed) > 0) page->refresh();
            });
    return page;
}

QDialog* WindowDialogs::openExport(const QString& kind)
{
    auto* dialog = window_.findChild<ExportDialog*>();
    if (!dialog) dialog = new ExportDialog(exportKinds(), &window_);
    QDialog* page = dialog->showKind(kind);
    bringUp(*dialog);
    return page;
}

void WindowDialogs::openPrint(const QString& print)
{
    auto* dialog = static_cast<PrintDialog*>(openExport(QStringLiteral("print")));
    if (!print.isEmpty()) dialog->openFiles({print});
}

void WindowDialogs::openJob(const jobs::Job& job)
{
    openExport(text(job.name()));
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
    qDeleteAll(window_.findChildren<ExportDialog*>());
    again_.stop();
    qDeleteAll(window_.findChildren<PictureExport*>());
}

}  // namespace vitrine::ui

#include "moc_window_dialogs.cpp"
