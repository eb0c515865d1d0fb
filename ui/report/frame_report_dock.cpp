#include "ui/report/frame_report_dock.h"

#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/report/frame_report_view.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace vitrine::ui {

FrameReportDock::FrameReportDock(std::function<QString()> reason, QWidget* parent)
    : QWidget(parent), askReason_(std::move(reason)), reason_(new QLabel(this)), sums_(new QLabel(this)),
      everything_(new QCheckBox(tr("Run everything"), this)), view_(new FrameReportView(this))
{
    everything_->setAccessibleName(tr("Run everything"));
    reason_->setAccessibleName(tr("What is drawn and why"));
    sums_->setAccessibleName(tr("What the frame cost"));
    for (QLabel* label : {reason_, sums_}) {
        label->setTextFormat(Qt::PlainText);
        label->setMinimumWidth(40);
        // A longer sentence must not move the picture above.
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }
    everything_->setToolTip(tr("Runs every pass, including those that the picture does not need. The picture stays "
                               "identical; only the cost changes."));
    auto* top = new QHBoxLayout;
    top->setContentsMargins(8, 4, 8, 4);
    top->setSpacing(24);
    top->addWidget(reason_, 1);
    top->addWidget(sums_, 1);
    top->addWidget(everything_);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(0);
    all->addLayout(top);
    all->addWidget(view_, 1);
    connect(everything_, &QCheckBox::toggled, this, &FrameReportDock::runEverythingAsked);
    timer_.setSingleShot(true);
    timer_.setInterval(500);
    connect(&timer_, &QTimer::timeout, this, &FrameReportDock::renew);
}

void FrameReportDock::note(const render::FrameReport& report)
{
    view_->note(report);
    milliseconds_ = report.milliseconds;
    ran_ = report.ran.size();
    clock_ = translatedText(report.clock);
    saved_ = 0;
    for (const render::CulledPass& step : report.skipped) saved_ += std::max(view_->costs().of(step.name), 0.0);
    if (!timer_.isActive()) timer_.start();
}

void FrameReportDock::noteOther(const render::FrameReport* report, const QString& why)
{
    view_->noteOther(report ? std::optional(*report) : std::nullopt);
    other_ = report ? tr("B: %1 steps, %2 ms")
                          .arg(report->ran.size())
                          .arg(numberLocale().toString(report->milliseconds, 'f', 2))
                    : why;
    if (!timer_.isActive()) timer_.start();
}

QString FrameReportDock::reasonText() const
{
    return reasonText_;
}

void FrameReportDock::renew()
{
    reasonText_ = askReason_();
    reason_->setText(reason_->fontMetrics().elidedText(reasonText_, Qt::ElideRight, reason_->width()));
    sumsText_ = tr("%1 steps, %2 ms").arg(ran_).arg(numberLocale().toString(milliseconds_, 'f', 2));
    if (!other_.isEmpty()) sumsText_ = tr("A: %1 · %2").arg(sumsText_, other_);
    sumsText_ += tr("; skipping saves %1 ms").arg(numberLocale().toString(saved_, 'f', 2));
    sums_->setText(sums_->fontMetrics().elidedText(sumsText_, Qt::ElideRight, sums_->width()));
    sums_->setToolTip(tr("%1.\nTimes by: %2.").arg(sumsText_, clock_));
    reason_->setToolTip(reasonText_);
}

}  // namespace vitrine::ui

#include "moc_frame_report_dock.cpp"
