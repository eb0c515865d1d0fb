#include "ui/print/source_bar.h"

#include "render/image/picture_formats.h"
#include "render/video/video_frames.h"
#include "ui/kit/file_patterns.h"
#include "ui/kit/type_size.h"
#include "ui/print/place_bar.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace vitrine::ui {

SourceBar::SourceBar(bool canShow, PrintSetup& setup, QWidget* parent)
    : QWidget(parent), origin_(new QComboBox(this)), render_(new QPushButton(tr("Render again"), this)),
      folder_(new QPushButton(tr("Folder…"), this)), files_(new QPushButton(tr("Pictures…"), this)),
      said_(new QLabel(this)), places_(new PlaceBar(setup, this))
{
    if (canShow) origin_->addItem(tr("What is shown"), static_cast<int>(printing::ViewOrigin::shown));
    origin_->addItem(tr("Pictures"), static_cast<int>(printing::ViewOrigin::files));
    origin_->addItem(tr("Quilt"), static_cast<int>(printing::ViewOrigin::quilt));
    origin_->setAccessibleName(tr("Origin of the views"));
    origin_->setToolTip(
        tr("Views rendered from the picture in the window, read from a folder or a list of pictures,\nor cut from one "
           "picture with a grid of views. A folder or pictures can also be dropped here."));
    origin_->setFocusPolicy(Qt::StrongFocus);
    render_->setToolTip(tr("Renders the views once more, from where you stand now."));
    folder_->setToolTip(tr("All pictures in a folder, by name; numbers count by value."));
    files_->setToolTip(tr("Pictures in viewing order from the left."));
    for (QPushButton* button : {render_, folder_, files_}) {
        button->setAutoDefault(false);
        button->setAccessibleName(button->text());
        followType(*button, [button] { button->setMinimumWidth(button->sizeHint().width() + 16); });
    }
    said_->setTextFormat(Qt::PlainText);
    said_->setWordWrap(true);
    said_->setEnabled(false);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    for (QPushButton* button : {render_, folder_, files_}) buttons->addWidget(button);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(origin_, 1);
    row->addLayout(buttons);
    stackWhenLarge(*row, *this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(said_);
    layout->addWidget(places_);

    connect(origin_, &QComboBox::activated, this,
            [this] { emit originChosen(static_cast<printing::ViewOrigin>(origin_->currentData().toInt())); });
    connect(render_, &QPushButton::clicked, this, &SourceBar::renderAsked);
    connect(folder_, &QPushButton::clicked, this, &SourceBar::chooseFolder);
    connect(files_, &QPushButton::clicked, this, &SourceBar::chooseFiles);
    showOrigin(shown_);
}

void SourceBar::showOrigin(printing::ViewOrigin origin)
{
    shown_ = origin;
    origin_->setCurrentIndex(origin_->findData(static_cast<int>(origin)));
    render_->setVisible(origin == printing::ViewOrigin::shown);
    folder_->setVisible(origin == printing::ViewOrigin::files);
    files_->setVisible(origin != printing::ViewOrigin::shown);
    places_->setVisible(origin != printing::ViewOrigin::shown);
}

void SourceBar::say(const QString& text)
{
    said_->setText(text);
}

QString SourceBar::said() const
{
    return said_->text();
}

void SourceBar::chooseFolder()
{
    auto* dialog = new QFileDialog(this, tr("Folder with views"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) { emit filesChosen({folder}); });
    dialog->open();
}

void SourceBar::chooseFiles()
{
    const bool isQuilt = shown_ == printing::ViewOrigin::quilt;
    auto* dialog = new QFileDialog(
        this, isQuilt ? tr("Quilt") : tr("Views"), {},
        isQuilt ? tr("Pictures (%1);;All files (*)").arg(filePatterns(render::readEndings()))
                : tr("Pictures and videos (%1);;All files (*)")
                      .arg(filePatterns(std::string(render::readEndings()) + ' ' + render::readVideoEndings)));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(isQuilt ? QFileDialog::ExistingFile : QFileDialog::ExistingFiles);
    connect(dialog, &QFileDialog::filesSelected, this, &SourceBar::filesChosen);
    dialog->open();
}

}  // namespace vitrine::ui

#include "moc_source_bar.cpp"
