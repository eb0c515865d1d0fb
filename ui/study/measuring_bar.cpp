#include "ui/study/measuring_bar.h"

#include "ui/kit/time_left.h"
#include "ui/kit/type_size.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace vitrine::ui {

MeasuringBar::MeasuringBar(QWidget* parent)
    : QWidget(parent), parameter_(new QComboBox(this)), go_(new QPushButton(this)), progress_(new QProgressBar(this)),
      doing_(new QLabel(this))
{
    parameter_->setAccessibleName(QCoreApplication::translate("StudyDock", "What to measure"));
    // Long names of parameters must not widen the window.
    parameter_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    parameter_->setMinimumContentsLength(14);
    parameter_->setPlaceholderText(QCoreApplication::translate("StudyDock", "As in the settings"));
    progress_->setAccessibleName(QCoreApplication::translate("StudyDock", "Progress"));
    go_->setAccessibleName(QCoreApplication::translate("StudyDock", "Measure, or stop measuring"));
    growWidth(*progress_, 120);
    progress_->setTextVisible(false);
    // Widgets that are shown only while measuring must not move the picture above.
    QSizePolicy keepsItsPlace = progress_->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(keepsItsPlace);
    growWidth(*go_, 80);
    doing_->setTextFormat(Qt::PlainText);
    doing_->setMinimumWidth(40);
    doing_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    row->addWidget(parameter_);
    row->addWidget(go_);
    row->addWidget(progress_);
    row->addWidget(doing_, 1);
    connect(go_, &QPushButton::clicked, this, &MeasuringBar::goAsked);
    connect(parameter_, &QComboBox::activated, this,
            [this] { emit parameterChosen(parameter_->currentData().toString()); });
}

void MeasuringBar::setParameters(const std::vector<std::pair<QString, QString>>& parameters)
{
    parameter_->clear();
    parameter_->addItem(QCoreApplication::translate("StudyDock", "All parameters together"), QString());
    for (const auto& [label, name] : parameters) parameter_->addItem(label, name);
}

void MeasuringBar::select(const QString& name)
{
    parameter_->setCurrentIndex(parameter_->findData(name));
}

bool MeasuringBar::hasSelection() const
{
    return parameter_->currentIndex() >= 0;
}

void MeasuringBar::insert(QWidget* widget)
{
    static_cast<QHBoxLayout*>(layout())->insertWidget(2, widget);
}

void MeasuringBar::showStart()
{
    go_->setText(QCoreApplication::translate("StudyDock", "Cancel"));
    go_->setEnabled(true);
    progress_->setValue(0);
    progress_->show();
    elapsed_.start();
    doing_->setText(QCoreApplication::translate("StudyDock", "Starting"));
}

void MeasuringBar::showProgress(double part, const QString& doing)
{
    progress_->setValue(static_cast<int>(100 * part));
    const double left = secondsLeft(part, elapsed_);
    doing_->setText(doing + (left >= 0 && part < 1 ? QStringLiteral(", ") + timeLeft(left) : QString()));
}

void MeasuringBar::showIdle(bool running)
{
    go_->setText(running ? QCoreApplication::translate("StudyDock", "Cancel")
                         : QCoreApplication::translate("StudyDock", "Measure"));
    go_->setEnabled(running || parameter_->count() > 1);
    progress_->setVisible(running);
    if (!running) doing_->clear();
}

}  // namespace vitrine::ui

#include "moc_measuring_bar.cpp"
