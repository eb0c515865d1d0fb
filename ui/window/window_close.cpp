// What keeps the window from closing over unfinished work.
#include "ui/window/main_window.h"

#include "ui/print/print_dialog.h"
#include "ui/window/picture_export.h"
#include "ui/window/session_keeper.h"

#include <QCloseEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace vitrine::ui {
namespace {

/// The files that are being made.
QStringList unfinished(const MainWindow& window)
{
    QStringList files;
    for (const PictureExport* work : window.findChildren<PictureExport*>())
        if (work->running()) files << QString::fromStdString(work->path().filename().string());
    for (const PrintDialog* dialog : window.findChildren<PrintDialog*>())
        if (dialog->exporting()) files << QFileInfo(dialog->path()).fileName();
    return files;
}

}  // namespace

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!closeAnyway_ && !unfinished(*this).isEmpty()) {
        event->ignore();
        askBeforeClosing();
        return;
    }
    keeper_->close();
    event->accept();
}

void MainWindow::askBeforeClosing()
{
    if (closing_) {
        closing_->raise();
        return;
    }
    closing_ = new QMessageBox(QMessageBox::Question, tr("Close Vitrine?"), tr("%1 is not finished yet.").arg(unfinished(*this).join(QStringLiteral(", "))),
                               QMessageBox::Cancel, this);
    closing_->setTextFormat(Qt::PlainText);
    closing_->setAttribute(Qt::WA_DeleteOnClose);
    auto* wait = closing_->addButton(tr("Close when it is done"), QMessageBox::AcceptRole);
    auto* stop = closing_->addButton(tr("Give it up and close"), QMessageBox::DestructiveRole);
    closing_->button(QMessageBox::Cancel)->setText(tr("Stay open"));
    wait->setObjectName(QStringLiteral("closeWhenDone"));
    stop->setObjectName(QStringLiteral("closeAnyway"));
    closing_->setDefaultButton(wait);
    connect(wait, &QPushButton::clicked, this, &MainWindow::closeWhenDone);
    connect(stop, &QPushButton::clicked, this, [this] {
        closeAnyway_ = true;
        close();
    });
    closing_->open();
}

void MainWindow::closeWhenDone()
{
    // What fails says so in the window, which stays for that.
    for (const PictureExport* work : findChildren<PictureExport*>()) connect(work, &PictureExport::finished, this, &MainWindow::closeIfDone, Qt::QueuedConnection);
    for (const PrintDialog* dialog : findChildren<PrintDialog*>())
        connect(dialog, &PrintDialog::exportEnded, this, [this](bool saved) { if (saved) closeIfDone(); }, Qt::QueuedConnection);
    closeIfDone();
}

void MainWindow::closeIfDone()
{
    if (unfinished(*this).isEmpty()) close();
}

}  // namespace vitrine::ui
