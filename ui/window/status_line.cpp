#include "ui/window/status_line.h"

#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/kit/type_size.h"
#include "ui/report/frame_graph.h"

#include <QHBoxLayout>
#include <QLabel>

namespace vitrine::ui {

StatusLine::StatusLine(QWidget* parent)
    : QWidget(parent), words_(new QLabel(this)), time_(new QLabel(this)), graph_(new FrameGraph(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(24);
    words_->setAccessibleName(tr("What is drawn and why"));
    time_->setAccessibleName(tr("Time of the frame"));
    for (QLabel* label : {words_, time_}) {
        label->setTextFormat(Qt::PlainText);
        label->setToolTip(label->accessibleName());
    }
    layout->addWidget(words_, 1);
    layout->addWidget(graph_);
    layout->addWidget(time_);
    growMinimumWidth(*words_, 80);
    words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    growHeight(*this, 24);
    timer_.setSingleShot(true);
    timer_.setInterval(500);
    connect(&timer_, &QTimer::timeout, this, &StatusLine::renew);
}

void StatusLine::note(const render::FrameReport& report, const QSize& pixels, const QString& reason)
{
    reason_ = reason;
    pixels_ = pixels;
    milliseconds_ = report.milliseconds;
    graph_->add(report.milliseconds);
    clock_ = translatedText(report.clock);
    if (!report.clockTrusted) clock_ += tr(", not trusted");
    ran_ = report.ran.size();
    skipped_ = report.skipped.size();
    if (!timer_.isActive()) timer_.start();
}

void StatusLine::renew()
{
    shownReason_ = reason_;
    showWords();
    time_->setText(tr("%1 ms").arg(numberLocale().toString(milliseconds_, 'f', 1)));
    const QStringList details{tr("%1 × %2").arg(pixels_.width()).arg(pixels_.height()),
                              tr("%1 passes ran, %2 skipped").arg(ran_).arg(skipped_),
                              tr("Time of the frame, by %1").arg(clock_)};
    time_->setToolTip(details.join(QLatin1Char('\n')));
    time_->setAccessibleDescription(details.join(QStringLiteral(", ")));
}

void StatusLine::showHelp(const QString& help)
{
    help_ = help;
    showWords();
}

void StatusLine::showWords()
{
    const QString& words = help_.isEmpty() ? shownReason_ : help_;
    words_->setText(words_->fontMetrics().elidedText(words, Qt::ElideRight, words_->width()));
    words_->setToolTip(words);
}

QString StatusLine::text() const
{
    return QStringList{shownReason_, time_->text(), time_->accessibleDescription()}.join(QStringLiteral(" | "));
}

}  // namespace vitrine::ui

#include "moc_status_line.cpp"
