#include "ui/print/export_bar.h"

#include "ui/kit/replace_question.h"
#include "ui/kit/time_left.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace vitrine::ui {
namespace {

/// The name in that folder, or with a number, not taken yet.
QString freePath(const QString& folder, const QString& name)
{
    const QString path = QDir(folder).filePath(name);
    return QFileInfo::exists(path) ? nextFreePath(path) : path;
}

/// What a print of this name may be written to besides the file itself.
QStringList besidePrint(const QString& path)
{
    const QFileInfo file(path);
    return {path + QStringLiteral(".json"),
            QStringLiteral("%1/%2-1.%3").arg(file.path(), file.completeBaseName(), file.suffix())};
}

}  // namespace

ExportBar::ExportBar(QWidget* parent)
    : QWidget(parent), path_(new QLineEdit(this)), browse_(new QToolButton(this)), progress_(new QProgressBar(this)),
      status_(new QLabel(this))
{
    path_->setAccessibleName(tr("File"));
    path_->setToolTip(tr("The print: .tif, or .png. Its settings are written inside and beside it."));
    browse_->setText(QStringLiteral("…"));
    browse_->setAccessibleName(tr("Choose a file"));
    browse_->setToolTip(tr("Choose a file"));
    browse_->setFocusPolicy(Qt::StrongFocus);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    progress_->setAccessibleName(tr("Progress"));
    status_->setTextFormat(Qt::PlainText);
    load_ =
        addButton(tr("Load settings…"), tr("From a print that Vitrine made, or a .json. Dropping one here works too."));
    save_ = addButton(tr("Save settings…"), tr("Everything that is set here, as JSON."));
    stop_ = addButton(tr("Close"), {});
    go_ = addButton(tr("Export"), {});
    go_->setMinimumWidth(112);
    layOut();
    connectParts();
}

QPushButton* ExportBar::addButton(const QString& text, const QString& help)
{
    auto* button = new QPushButton(text, this);
    button->setToolTip(help);
    button->setAutoDefault(false);  // Enter in a number field ends the number, nothing else.
    button->setAccessibleName(text);
    button->setMinimumWidth(button->sizeHint().width() + 16);
    return button;
}

void ExportBar::layOut()
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
    buttons->addWidget(load_);
    buttons->addWidget(save_);
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

void ExportBar::connectParts()
{
    connect(path_, &QLineEdit::textChanged, this, &ExportBar::pathChanged);
    connect(browse_, &QToolButton::clicked, this, &ExportBar::browse);
    connect(load_, &QPushButton::clicked, this, [this] { askSettings(false); });
    connect(save_, &QPushButton::clicked, this, [this] { askSettings(true); });
    connect(go_, &QPushButton::clicked, this, &ExportBar::ask);
    connect(stop_, &QPushButton::clicked, this, &ExportBar::stopAsked);
}

QString ExportBar::path() const
{
    return path_->text();
}

void ExportBar::setPath(const QString& path)
{
    path_->setText(path);
}

void ExportBar::suggest(const QString& folder)
{
    path_->setText(freePath(folder, QStringLiteral("lenticular-print.tif")));
    otherPath_ = freePath(folder, QStringLiteral("lenticular-chart.tif"));
}

void ExportBar::setChart(bool chart)
{
    if (chart == chart_) return;
    chart_ = chart;
    go_->setText(chart ? tr("Export chart") : tr("Export"));
    const QString other = std::exchange(otherPath_, path_->text());
    path_->setText(other);
}

void ExportBar::ask()
{
    const auto begin = [this](const QString& path) {
        path_->setText(path);
        replaced_.clear();
        emit exportAsked(path);
    };
    if (path_->text() == replaced_)
        begin(replaced_);
    else
        askBeforeReplacing(this, path_->text(), begin, besidePrint(path_->text()));
}

void ExportBar::showPossible(bool exporting, bool possible)
{
    go_->setEnabled(possible && !exporting);
    stop_->setText(exporting ? tr("Cancel") : tr("Close"));
    for (QWidget* input : std::initializer_list<QWidget*>{path_, browse_, load_}) input->setEnabled(!exporting);
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
    auto* dialog = new QFileDialog(this, tr("Export lenticular print"), path_->text(), tr("TIFF (*.tif);;PNG (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
        path_->setText(chosen);
        replaced_ = chosen;  // The dialog has asked.
    });
    dialog->open();
}

void ExportBar::askSettings(bool save)
{
    auto* dialog =
        new QFileDialog(this, save ? tr("Save settings") : tr("Load settings"), QFileInfo(path_->text()).absolutePath(),
                        save ? tr("Settings (*.json)") : tr("Settings and prints (*.json *.tif *.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
    dialog->setDefaultSuffix(save ? QStringLiteral("json") : QString());
    connect(dialog, &QFileDialog::fileSelected, this, save ? &ExportBar::settingsSaved : &ExportBar::settingsLoaded);
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_export_bar.cpp"
