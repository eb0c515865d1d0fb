#include "ui/window/close_guard.h"

#include "ui/export/picture_export.h"
#include "ui/jobs/export_again.h"
#include "ui/jobs/job_dialog.h"
#include "ui/print/print_dialog.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace vitrine::ui {
namespace {

/// Returns the files that would be missing if the window closed now.
QStringList unfinished(const QWidget& window)
{
    QStringList files;
    for (const PictureExport* work : window.findChildren<PictureExport*>())
        if (work->running() && !work->replaces()) files << QString::fromStdString(work->path().filename().string());
    for (const ExportAgain* again : window.findChildren<ExportAgain*>()) files << again->unfinished();
    for (const PrintDialog* dialog : window.findChildren<PrintDialog*>())
        if (dialog->exporting()) files << QFileInfo(dialog->path()).fileName();
    for (const JobDialog* dialog : window.findChildren<JobDialog*>())
        if (dialog->exporting()) files << QFileInfo(dialog->path()).fileName();
    return files;
}

}  // namespace

CloseGuard::CloseGuard(QWidget& window) : QObject(&window), window_(window) {}

bool CloseGuard::mayClose()
{
    if (!givenUp_ && !unfinished(window_).isEmpty()) {
        ask();
        return false;
    }
    const QStringList names = unsaved_ && !kept_ ? unsaved_() : QStringList();
    if (!names.isEmpty()) askToSave(names);
    return names.isEmpty();
}

void CloseGuard::setUnsaved(std::function<QStringList()> names, std::function<bool()> save)
{
    unsaved_ = std::move(names);
    save_ = std::move(save);
}

void CloseGuard::askToSave(const QStringList& names)
{
    if (question_) {
        question_->raise();
        return;
    }
    const QString words = tr("Not saved: %1. Unsaved changes are kept in the session and restored at the next start.")
                              .arg(names.join(QStringLiteral(", ")));
    question_ = new QMessageBox(QMessageBox::Question, tr("Close the window?"), words, QMessageBox::Cancel, &window_);
    question_->setTextFormat(Qt::PlainText);
    question_->setAttribute(Qt::WA_DeleteOnClose);
    auto* save = question_->addButton(tr("Save and close"), QMessageBox::AcceptRole);
    auto* keep = question_->addButton(tr("Close without saving"), QMessageBox::DestructiveRole);
    question_->button(QMessageBox::Cancel)->setText(tr("Stay open"));
    save->setObjectName(QStringLiteral("saveAndClose"));
    keep->setObjectName(QStringLiteral("closeUnsaved"));
    question_->setDefaultButton(save);
    connect(save, &QPushButton::clicked, this, [this] {
        if (save_()) window_.close();
    });
    connect(keep, &QPushButton::clicked, this, [this] {
        kept_ = true;
        window_.close();
    });
    question_->open();
}

void CloseGuard::ask()
{
    if (question_) {
        question_->raise();
        return;
    }
    const QString words = tr("Still being written: %1.").arg(unfinished(window_).join(QStringLiteral(", ")));
    question_ = new QMessageBox(QMessageBox::Question, tr("Close the window?"), words, QMessageBox::Cancel, &window_);
    question_->setTextFormat(Qt::PlainText);
    question_->setAttribute(Qt::WA_DeleteOnClose);
    auto* wait = question_->addButton(tr("Close when it is done"), QMessageBox::AcceptRole);
    auto* stop = question_->addButton(tr("Stop writing and close"), QMessageBox::DestructiveRole);
    question_->button(QMessageBox::Cancel)->setText(tr("Stay open"));
    wait->setObjectName(QStringLiteral("closeWhenDone"));
    stop->setObjectName(QStringLiteral("closeAnyway"));
    question_->setDefaultButton(wait);
    connect(wait, &QPushButton::clicked, this, &CloseGuard::closeWhenDone);
    connect(stop, &QPushButton::clicked, this, [this] {
        givenUp_ = true;
        window_.close();
    });
    question_->open();
}

void CloseGuard::closeWhenDone()
{
    // After a failure the window stays open and shows the message.
    for (const PictureExport* work : window_.findChildren<PictureExport*>())
        connect(work, &PictureExport::finished, this, &CloseGuard::closeIfDone, Qt::QueuedConnection);
    const auto follow = [this](bool written) {
        if (written) closeIfDone();
    };
    for (const ExportAgain* again : window_.findChildren<ExportAgain*>())
        connect(again, &ExportAgain::ended, this, follow, Qt::QueuedConnection);
    for (const PrintDialog* dialog : window_.findChildren<PrintDialog*>())
        connect(dialog, &PrintDialog::exportEnded, this, follow, Qt::QueuedConnection);
    for (const JobDialog* dialog : window_.findChildren<JobDialog*>())
        connect(dialog, &JobDialog::exportEnded, this, follow, Qt::QueuedConnection);
    closeIfDone();
}

void CloseGuard::closeIfDone()
{
    if (unfinished(window_).isEmpty()) window_.close();
}

}  // namespace vitrine::ui

#include "moc_close_guard.cpp"
