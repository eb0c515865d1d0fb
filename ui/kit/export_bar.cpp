#include "ui/kit/export_bar.h"

#include "ui/kit/flow_layout.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/time_left.h"
#include "ui/kit/type_size.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace vitrine::ui {

ExportBar::ExportBar(Words words, QWidget* parent)
    : QWidget(parent), words_(std::move(words)), path_(new QLineEdit(this)), browse_(new QToolButton(this)),
      progress_(new QProgressBar(this)), status_(new QLabel(this)), line_(new FlowLayout), buttons_(new QHBoxLayout)
{
    path_->setAccessibleName(words_.isFolder ? tr("Folder") : tr("File"));
    path_->setToolTip(words_.help);
    browse_->setText(QStringLiteral("…"));
    browse_->setAccessibleName(words_.isFolder ? tr("Choose a folder") : tr("Choose a file"));
    browse_->setToolTip(browse_->accessibleName());
    browse_->setFocusPolicy(Qt::StrongFocus);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    progress_->setAccessibleName(tr("Progress"));
    status_->setTextFormat(Qt::PlainText);
    status_->setWordWrap(true);
    buttons_->addWidget(status_, 1);
    stop_ = makeButton(tr("Close"));
    go_ = makeButton(tr("Export"));
    for (QPushButton* button : {stop_, go_}) {
        buttons_->addWidget(button);
        followType(*button, [button] { button->setMinimumWidth(std::max(112, button->sizeHint().width() + 16)); });
    }
    layOut();
    connect(path_, &QLineEdit::textChanged, this, &ExportBar::pathChanged);
    connect(browse_, &QToolButton::clicked, this, &ExportBar::browse);
    connect(go_, &QPushButton::clicked, this, &ExportBar::goAsked);
    connect(stop_, &QPushButton::clicked, this, &ExportBar::stopAsked);
    // No shortcut of the button itself: it would be lost with each change of its text.
    const QKeySequence key(Qt::CTRL | Qt::Key_Return);
    connect(new QShortcut(key, this), &QShortcut::activated, go_, [this] { go_->click(); });
    go_->setToolTip(tr("Starts the export (%1).").arg(key.toString(QKeySequence::NativeText)));
}

QPushButton* ExportBar::makeButton(const QString& text)
{
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);  // Enter in a number field confirms the number only.
    button->setAccessibleName(text);
    followType(*button, [button] { button->setMinimumWidth(button->sizeHint().width() + 16); });
    return button;
}

QPushButton* ExportBar::addButton(const QString& text, const QString& help)
{
    QPushButton* button = makeButton(text);
    button->setToolTip(help);
    added_ << button;
    placeAdded();
    return button;
}

void ExportBar::placeAdded()
{
    int place = 0;
    for (QPushButton* button : added_) {
        line_->removeWidget(button);
        buttons_->removeWidget(button);
        if (isLargeType(*this))
            line_->addWidget(button);
        else
            buttons_->insertWidget(place++, button);
    }
}

void ExportBar::layOut()
{
    auto* file = new QHBoxLayout;
    file->setSpacing(8);
    auto* label = new QLabel(path_->accessibleName(), this);
    label->setBuddy(path_);
    file->addWidget(label);
    file->addWidget(path_, 1);
    file->addWidget(browse_);
    buttons_->setSpacing(8);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addLayout(file);
    layout->addWidget(progress_);
    layout->addLayout(line_);
    layout->addLayout(buttons_);
    followType(*this, [this] { placeAdded(); });
}

QString ExportBar::path() const
{
    return path_->text();
}

void ExportBar::setPath(const QString& path)
{
    path_->setText(path);
}

QString ExportBar::status() const
{
    return status_->text();
}

void ExportBar::ask(const QStringList& beside)
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

void ExportBar::showPossible(bool exporting, bool possible)
{
    go_->setEnabled(possible && !exporting);
    stop_->setText(exporting ? tr("Cancel") : tr("Close"));
    path_->setEnabled(!exporting);
    browse_->setEnabled(!exporting);
}

void ExportBar::showProgress(double part, double secondsLeft)
{
    showStatus(secondsLeft < 0 ? QString() : timeLeft(secondsLeft), part);
}

void ExportBar::showStatus(const QString& words, double part)
{
    progress_->setValue(static_cast<int>(part * 1000));
    status_->setText(words);
}

void ExportBar::browse()
{
    auto* dialog = new QFileDialog(this, words_.title, path_->text(), words_.filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (words_.isFolder) {
        dialog->setFileMode(QFileDialog::Directory);
        dialog->setOption(QFileDialog::ShowDirsOnly);
    } else {
        dialog->setAcceptMode(QFileDialog::AcceptSave);
        dialog->setDefaultSuffix(words_.suffix);
    }
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
        path_->setText(chosen);
        if (!words_.isFolder) replaced_ = chosen;  // The file dialog has already asked about replacing it.
    });
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_export_bar.cpp"
