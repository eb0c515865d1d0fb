#include "ui/window/close_guard.h"

#include "ui/print/print_dialog.h"
#include "ui/window/picture_export.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace vitrine::ui {
namespace {

/// The files that are being made.
QStringList unfinished(const QWidget& window)
{
    QStringList files;
    for (const PictureExport* work : window.findChildren<PictureExport*>())
        if (work->running()) files << QString::fromStdString(work->path().filename().string());
    for (const PrintDialog* dialog : window.findChildren<PrintDialog*>())
        if (dialog->exporting()) files << QFileInfo(dialog->path()).fileName();
    return files;
}

}  // namespace

CloseGuard::CloseGuard(QWidget& window) : QObject(&window), window_(window) {}

bool CloseGuard::mayClose()
{
    if (givenUp_ || unfinished(window_).isEmpty()) return true;
    ask();
    return false;
}

void CloseGuard::ask()
{
    if (question_) {
        question_->raise();
        return;
    }
    const QString words = tr("Still being written: %1.").arg(unfinished(window_).join(QStringLiteral(", ")));
    question_ = new QMessageBox(QMessageBox::Question, tr("Close Vitrine?"), words, QMessageBox::Cancel, &window_);
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
    // What fails says so in the window, which stays for that.
    for (const PictureExport* work : window_.findChildren<PictureExport*>())
        connect(work, &PictureExport::finished, this, &CloseGuard::closeIfDone, Qt::QueuedConnection);
    for (const PrintDialog* dialog : window_.findChildren<PrintDialog*>())
        connect(
            dialog, &PrintDialog::exportEnded, this,
            [this](bool saved) {
                if (saved) closeIfDone();
            },
            Qt::QueuedConnection);
    closeIfDone();
}

void CloseGuard::closeIfDone()
{
    if (unfinished(window_).isEmpty()) window_.close();
}

}  // namespace vitrine::ui

#include "moc_close_guard.cpp"
