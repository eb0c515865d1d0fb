#include "ui/sprites/sprite_export_bar.h"

#include "ui/kit/replace_question.h"
#include "ui/kit/time_left.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

namespace vitrine::ui {

SpriteExportBar::SpriteExportBar(QWidget* parent)
    : QWidget(parent), path_(new QLineEdit(this)), browse_(new QToolButton(this)), progress_(new QProgressBar(this)),
      status_(new QLabel(this)), stop_(new QPushButton(tr("Close"), this)), go_(new QPushButton(tr("Export"), this))
{
    path_->setAccessibleName(tr("File"));
    path_->setToolTip(tr("The sheet: .png. Further sheets and the description take its name."));
    browse_->setText(QStringLiteral("…"));
    browse_->setAccessibleName(tr("Choose a file"));
    browse_->setToolTip(tr("Choose a file"));
    browse_->setFocusPolicy(Qt::StrongFocus);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    progress_->setAccessibleName(tr("Progress"));
    status_->setTextFormat(Qt::PlainText);
    for (QPushButton* button : {stop_, go_}) {
        button->setAutoDefault(false);  // Enter in a number field ends the number, nothing else.
        button->setMinimumWidth(112);
    }
    layOut();
    connect(browse_, &QToolButton::clicked, this, &SpriteExportBar::browse);
    connect(go_, &QPushButton::clicked, this, &SpriteExportBar::goAsked);
    connect(stop_, &QPushButton::clicked, this, &SpriteExportBar::stopAsked);
}

void SpriteExportBar::layOut()
{
    auto* file = new QHBoxLayout;
    file->setSpacing(8);
    auto* label = new QLabel(tr("File"), this);
    label->setBuddy(path_);
    file->addWidget(label);
    file->addWidget(path_, 1);
    file->addWidget(browse_);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(status_, 1);
    buttons->addWidget(stop_);
    buttons->addWidget(go_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(file);
    layout->addWidget(progress_);
    layout->addLayout(buttons);
}

QString SpriteExportBar::path() const
{
    return path_->text();
}

void SpriteExportBar::setPath(const QString& path)
{
    path_->setText(path);
}

QString SpriteExportBar::status() const
{
    return status_->text();
}

void SpriteExportBar::ask(const QStringList& beside)
{
    const auto begin = [this](const QString& path) {
        path_->setText(path);
        replaced_.clear();
        emit exportAsked(path);
    };
    if (path_->text() == replaced_)
        begin(replaced_);
    else
        askBeforeReplacing(this, path_->text(), begin, beside);
}

void SpriteExportBar::showPossible(bool exporting, bool possible)
{
    go_->setEnabled(possible && !exporting);
    stop_->setText(exporting ? tr("Cancel") : tr("Close"));
    path_->setEnabled(!exporting);
    browse_->setEnabled(!exporting);
}

void SpriteExportBar::showProgress(double part, double secondsLeft)
{
    showStatus(secondsLeft < 0 ? QString() : timeLeft(secondsLeft), part);
}

void SpriteExportBar::showStatus(const QString& words, double part)
{
    progress_->setValue(static_cast<int>(part * 1000));
    status_->setText(words);
}

void SpriteExportBar::browse()
{
    auto* dialog = new QFileDialog(this, tr("Export sprites"), path_->text(), tr("PNG (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
        path_->setText(chosen);
        replaced_ = chosen;  // The dialog has asked.
    });
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_sprite_export_bar.cpp"
