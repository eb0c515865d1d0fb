#include "ui/export/screenshot_dialog.h"

#include "render/image/picture_formats.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/scroll_room.h"
#include "ui/kit/show_in_folder.h"
#include "ui/kit/text.h"
#include "ui/kit/time_left.h"
#include "ui/kit/type_size.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>

#include <array>

namespace vitrine::ui {
namespace {

constexpr std::array<QSize, 5> usualSizes{QSize(1280, 720), QSize(1920, 1080), QSize(3840, 2160), QSize(7680, 4320),
                                          QSize(2048, 2048)};

}  // namespace

ScreenshotDialog::ScreenshotDialog(Workbench& window, QWidget* parent)
    : QDialog(parent), window_(window), sizes_(new QComboBox(this)), width_(new QSpinBox(this)),
      height_(new QSpinBox(this)), samples_(new QSpinBox(this)), format_(new QComboBox(this)),
      transparent_(new QCheckBox(this)), path_(new QLineEdit(this)), progress_(new QProgressBar(this)),
      left_(new QLabel(this)), folder_(new QPushButton(tr("Show in folder"), this)),
      go_(new QPushButton(tr("Export"), this)), stop_(new QPushButton(tr("Close"), this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export picture"));
    fillInputs();
    layOut();
    connect(sizes_, &QComboBox::activated, this, [this] {
        const QSize size = sizes_->currentData().toSize();
        width_->setValue(size.width());
        height_->setValue(size.height());
    });
    connect(format_, &QComboBox::currentIndexChanged, this, &ScreenshotDialog::takeFormat);
    connect(go_, &QPushButton::clicked, this, &ScreenshotDialog::start);
    connect(folder_, &QPushButton::clicked, this, [this] { showInFolder(saved_); });
    connect(stop_, &QPushButton::clicked, this, [this] { reject(); });
    setBusy(false);
    const auto name = window.museum().subject(window.chosen()).name();
    path_->setText(QString::fromStdString(freeScreenshotPath(*parent, text(name)).string()));
}

void ScreenshotDialog::fillInputs()
{
    const double ratio = window_.viewport().devicePixelRatioF();
    const QSize now = QSizeF(window_.viewport().size() * ratio).toSize();
    sizes_->addItem(tr("As in the window"), now);
    for (const QSize& size : usualSizes)
        sizes_->addItem(QStringLiteral("%1 × %2").arg(size.width()).arg(size.height()), size);
    for (QSpinBox* side : {width_, height_}) {
        side->setRange(1, 65536);
        side->setSuffix(tr(" px"));
    }
    width_->setValue(now.width());
    height_->setValue(now.height());
    samples_->setRange(1, 64);
    samples_->setValue(16);
    format_->setObjectName(QStringLiteral("format"));
    for (const render::PictureFileFormat& file : render::pictureFormats())
        for (const render::WrittenDepth& depth : file.written)
            format_->addItem((file.isLinear ? tr("%1, linear light, %2 bit") : tr("%1, %2 bit"))
                                 .arg(text(file.name))
                                 .arg(depth.bits),
                             static_cast<int>(depth.format));
    transparent_->setText(tr("Only the chosen exhibit"));
    growMinimumWidth(*path_, 320);
    left_->setTextFormat(Qt::PlainText);
    left_->setWordWrap(true);
    left_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    progress_->setRange(0, 1000);
    progress_->setTextVisible(false);
    progress_->setFixedHeight(4);
    sizes_->setAccessibleName(tr("Usual sizes"));
    width_->setAccessibleName(tr("Width"));
    height_->setAccessibleName(tr("Height"));
    path_->setAccessibleName(tr("File"));
    progress_->setAccessibleName(tr("Progress"));
    samples_->setToolTip(tr("Samples per pixel: 1 leaves jagged edges, 16 gives smooth ones; 64 is for prints."));
    transparent_->setToolTip(tr("The exhibit alone, in the hall's light; around it the picture is transparent."));
}

void ScreenshotDialog::layOut()
{
    auto* size = new QHBoxLayout;
    size->setSpacing(8);
    size->addWidget(width_);
    size->addWidget(new QLabel(QStringLiteral("×"), this));
    size->addWidget(height_);
    size->addStretch(1);
    auto* file = new QHBoxLayout;
    file->setSpacing(4);
    auto* browseButton = new QToolButton(this);
    browseButton->setText(QStringLiteral("…"));
    browseButton->setAccessibleName(tr("Choose a file"));
    browseButton->setToolTip(tr("Choose a file"));
    connect(browseButton, &QToolButton::clicked, this, &ScreenshotDialog::browse);
    file->addWidget(path_, 1);
    file->addWidget(browseButton);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(folder_);
    buttons->addStretch(1);
    buttons->addWidget(stop_);
    buttons->addWidget(go_);
    go_->setDefault(true);
    folder_->setAutoDefault(false);
    folder_->setToolTip(tr("Show the file in its folder"));
    folder_->hide();
    // The button gets the focus while the export runs: a second Enter must not cancel it.
    stop_->setAutoDefault(false);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(16, 16, 16, 16);
    form->setSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft);
    form->addRow(tr("Size"), sizes_);
    form->addRow(QString(), size);
    form->addRow(tr("Samples per pixel"), samples_);
    form->addRow(tr("Format"), format_);
    form->addRow(tr("Transparent"), transparent_);
    form->addRow(tr("File"), file);
    form->addRow(progress_);
    form->addRow(left_);
    form->addRow(buttons);
    scrollWhenTight(*this);
}

void ScreenshotDialog::takeFormat()
{
    const QFileInfo file(path_->text());
    const QString ending = text(render::fileFormat(format()).extensions.front());
    path_->setText(file.path() + QLatin1Char('/') + file.completeBaseName() + ending);
}

void ScreenshotDialog::browse()
{
    auto* dialog = new QFileDialog(this, tr("Export picture"), path_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
        path_->setText(chosen);
        replaced_ = chosen;  // The file dialog has already asked about replacing it.
    });
    dialog->open();
}

void ScreenshotDialog::setPath(const QString& path)
{
    path_->setText(path);
}

QString ScreenshotDialog::path() const
{
    return path_->text();
}

void ScreenshotDialog::reject()
{
    if (!running_ || !running_->running()) {
        QDialog::reject();
        return;
    }
    if (!running_->cancel()) return;  // The file is being written.
    setBusy(false);
    left_->setText(tr("Canceled; no file was written."));
}

render::PictureFormat ScreenshotDialog::format() const
{
    return static_cast<render::PictureFormat>(format_->currentData().toInt());
}

ExportRequest ScreenshotDialog::exportRequest() const
{
    return {path_->text().toStdString(),
            format(),
            {width_->value(), height_->value()},
            samples_->value(),
            transparent_->isChecked()};
}

void ScreenshotDialog::setBusy(bool busy)
{
    for (QWidget* input :
         std::initializer_list<QWidget*>{sizes_, width_, height_, samples_, format_, transparent_, path_})
        input->setEnabled(!busy);
    go_->setEnabled(!busy);
    stop_->setText(busy ? tr("Cancel") : tr("Close"));
    if (!busy) progress_->setValue(0);
}

void ScreenshotDialog::start()
{
    if (transparent_->isChecked() && capability<OverFrame>(window_.museum().subject(window_.chosen()))) {
        left_->setText(tr("This exhibit is made of light alone: there is nothing to cut out."));
        return;
    }
    if (transparent_->isChecked() && window_.chosen() == hallIndex) {
        left_->setText(tr("Visit an exhibit first: the hall has nothing around it that could be left out."));
        return;
    }
    if (path_->text() == replaced_)
        write(replaced_);
    else
        askBeforeReplacing(this, path_->text(), [this](const QString& path) { write(path); });
}

void ScreenshotDialog::write(const QString& to)
{
    if (running_ && running_->running()) return;
    path_->setText(to);
    replaced_.clear();
    running_ = new PictureExport(window_, exportRequest(), parent());
    connect(running_, &PictureExport::progressed, this, [this](double part, double secondsLeft) {
        progress_->setValue(static_cast<int>(part * 1000));
        left_->setText(secondsLeft < 0 ? tr("Drawing …") : timeLeft(secondsLeft));
    });
    connect(running_, &PictureExport::finished, this, [this](const QString& path) {
        setBusy(false);
        left_->setText(tr("Saved %1.").arg(QFileInfo(path).fileName()));
        left_->setToolTip(path);
        saved_ = path;
        folder_->show();
        path_->setText(nextFreePath(path));
    });
    connect(running_, &PictureExport::failed, this, [this](const QString& why) {
        setBusy(false);
        left_->setText(why);
        window_.say(MessageStrip::Mood::problem, why);
    });
    emit begun(exportRequest());
    folder_->hide();
    setBusy(true);
    left_->setText(tr("Drawing …"));
    running_->start();
}

}  // namespace vitrine::ui

#include "moc_screenshot_dialog.cpp"
