#include "ui/study/point_pictures.h"

#include "render/measure/distance.h"
#include "ui/kit/language.h"
#include "ui/study/large_pictures.h"
#include "ui/study/point_caption.h"
#include "ui/study/study_pictures.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

QLabel* wrappedLabel(QWidget* parent)
{
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setMinimumWidth(40);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    label->setWordWrap(true);
    return label;
}

PointPictures::PointPictures(QWidget* parent)
    : QWidget(parent), view_(new QComboBox(this)), pictures_(new StudyPictures(this)), caption_(wrappedLabel(this))
{
    view_->setObjectName(QStringLiteral("view"));
    view_->setAccessibleName(QCoreApplication::translate("StudyView", "View"));
    // Long names must not widen the window.
    view_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    view_->setMinimumContentsLength(14);
    layOut();
    connect(view_, &QComboBox::currentIndexChanged, this, &PointPictures::viewChosen);
    connect(pictures_, &StudyPictures::enlargeAsked, this, &PointPictures::enlarge);
    hidePictures();
    setCaption({});
}

void PointPictures::layOut()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    auto* views = new QWidget(this);  // Hidden and shown with its label.
    auto* inRow = new QHBoxLayout(views);
    auto* label = new QLabel(QCoreApplication::translate("StudyView", "&View:"), views);
    label->setBuddy(view_);
    inRow->setContentsMargins(0, 0, 0, 0);
    inRow->addWidget(label);
    inRow->addWidget(view_, 1);
    column->addWidget(views);
    column->addWidget(pictures_, 1);
    column->addWidget(caption_);
}

void PointPictures::setViews(const std::vector<std::string>& names)
{
    const QSignalBlocker quiet(view_);
    view_->clear();
    for (const std::string& name : names) view_->addItem(translatedText(name));
}

std::size_t PointPictures::view() const
{
    return static_cast<std::size_t>(std::max(view_->currentIndex(), 0));
}

void PointPictures::hidePictures()
{
    shown_ = {};
    pictures_->show({}, {}, {});
    pictures_->hide();
    view_->parentWidget()->hide();
}

void PointPictures::setCaption(const QString& caption)
{
    caption_->setText(caption);
    caption_->setToolTip(caption);
    setVisible(!caption.isEmpty());
    fillLarge();
}

void PointPictures::showPictures(render::Image picture, render::Image reference, render::Metric metric)
{
    shown_.picture = std::move(picture);
    shown_.reference = std::move(reference);
    shown_.errors = render::errorMap(metric, shown_.reference, shown_.picture)
                        .value_or(render::differenceMap(shown_.reference, shown_.picture));
    const bool differ =
        std::any_of(shown_.errors.pixels.begin(), shown_.errors.pixels.end(), [](float error) { return error > 0; });
    if (!differ) shown_.errors = {};  // A black heat map shows nothing, so it is left out.
    shown_.full = differ ? render::fullScale(metric, shown_.errors) : 1;
    scale_ = differ ? QCoreApplication::translate("StudyView", "The heat map ranges from 0 to %1 (%2).")
                          .arg(threeDigits(shown_.full), translatedText(title(metric)))
                    : noPixelDiffers();
    pictures_->show(screenImage(shown_.picture), screenImage(shown_.reference),
                    differ ? screenImage(render::heatMap(shown_.errors, shown_.full)) : QImage(),
                    differ ? threeDigits(shown_.full) : QString());
    pictures_->setVisible(true);
    view_->parentWidget()->setVisible(true);
    pictures_->setAccessibleDescription(
        QCoreApplication::translate("StudyView", "Left of the line the setting, right of it the reference; arrows move "
                                                 "the line, Enter opens a large view.") +
        QLatin1Char(' ') + scale_);
}

void PointPictures::enlarge()
{
    if (shown_.picture.empty()) return;
    if (!large_) {
        large_ = new LargePictures(window());
        connect(large_, &LargePictures::viewChosen, view_, &QComboBox::setCurrentIndex);
    }
    large_->show();
    fillLarge();
    large_->raise();
    large_->activateWindow();
}

void PointPictures::fillLarge()
{
    if (!large_ || !large_->isVisible()) return;
    QStringList views;
    for (int i = 0; i < view_->count(); ++i) views << view_->itemText(i);
    large_->setViews(views, view_->currentIndex());
    large_->setPictures(shown_, caption_->text(), shown_.picture.empty() ? QString() : scale_);
}

}  // namespace vitrine::ui

#include "moc_point_pictures.cpp"
