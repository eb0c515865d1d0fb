#include "ui/study/large_pictures.h"

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace vitrine::ui {

LargePictures::LargePictures(QWidget* parent)
    : QDialog(parent), view_(new QComboBox(this)), wipe_(new QToolButton(this)), zoom_(new QLabel(this)),
      caption_(new QLabel(this)), reading_(new QLabel(this)), scale_(new QLabel(this)), panes_(new PicturePanes(this))
{
    setWindowTitle(tr("Pictures of the study"));
    setWindowFlags(windowFlags() | Qt::WindowMaximizeButtonHint | Qt::WindowMinimizeButtonHint);
    for (QLabel* label : {zoom_, caption_, reading_, scale_}) label->setTextFormat(Qt::PlainText);
    for (QLabel* label : {caption_, reading_}) {
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    view_->setAccessibleName(tr("View"));
    reading_->setAccessibleName(tr("Values of the pixel"));
    auto* below = new QHBoxLayout;
    below->setSpacing(12);
    below->addWidget(reading_, 1);
    below->addWidget(scale_);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(12, 12, 12, 12);
    all->setSpacing(8);
    all->addLayout(buttons());
    all->addWidget(panes_, 1);
    all->addLayout(below);
    connect(view_, &QComboBox::currentIndexChanged, this, &LargePictures::viewChosen);
    connect(panes_, &PicturePanes::viewChanged, this, &LargePictures::showZoom);
    connect(panes_, &PicturePanes::pixelChanged, this, [this] { reading_->setText(panes_->reading()); });
    resize(1080, 640);
    showZoom();
    panes_->setFocus();
}

QToolButton* LargePictures::addButton(QLayout* row, const QString& text, const QString& help)
{
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setToolTip(help);
    button->setAccessibleName(help);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setFixedHeight(26);
    row->addWidget(button);
    return button;
}

QLayout* LargePictures::buttons()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(view_);
    row->addWidget(caption_, 1);
    wipe_->setText(tr("Wipe"));
    wipe_->setToolTip(tr("Setting and reference in one place, with a line between them to drag"));
    wipe_->setAccessibleName(tr("Wipe between setting and reference"));
    wipe_->setCheckable(true);
    wipe_->setFocusPolicy(Qt::StrongFocus);
    wipe_->setFixedHeight(26);
    row->addWidget(wipe_);
    connect(wipe_, &QToolButton::toggled, panes_, &PicturePanes::setWiped);
    connect(addButton(row, QStringLiteral("−"), tr("Zoom out (-)")), &QToolButton::clicked, panes_,
            [this] { panes_->zoomBy(1 / 1.25); });
    zoom_->setMinimumWidth(zoom_->fontMetrics().horizontalAdvance(QStringLiteral("6400 %")));
    zoom_->setAlignment(Qt::AlignCenter);
    row->addWidget(zoom_);
    connect(addButton(row, QStringLiteral("+"), tr("Zoom in (+)")), &QToolButton::clicked, panes_,
            [this] { panes_->zoomBy(1.25); });
    connect(addButton(row, tr("Fit"), tr("Show all of it (0)")), &QToolButton::clicked, panes_, &PicturePanes::fit);
    connect(addButton(row, tr("100 %"), tr("Show pixel for pixel (1)")), &QToolButton::clicked, panes_,
            &PicturePanes::setActualSize);
    return row;
}

void LargePictures::setPictures(PictureTriple triple, const QString& caption, const QString& scale)
{
    panes_->setPictures(std::move(triple));
    caption_->setText(caption);
    caption_->setToolTip(caption);
    scale_->setText(scale);
}

void LargePictures::setViews(const QStringList& views, int shown)
{
    const QSignalBlocker quiet(view_);
    view_->clear();
    view_->addItems(views);
    view_->setCurrentIndex(shown);
}

void LargePictures::showZoom()
{
    zoom_->setText(tr("%1 %").arg(QLocale::c().toString(100 * panes_->scale(), 'f', 0)));
}

}  // namespace vitrine::ui

#include "moc_large_pictures.cpp"
