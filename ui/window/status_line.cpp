#include "ui/window/status_line.h"

#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/kit/type_size.h"
#include "ui/report/frame_graph.h"

#include <QHBoxLayout>
#include <QLabel>

namespace vitrine::ui {

StatusLine::StatusLine(QWidget* parent) : QWidget(parent), graph_(new FrameGraph(this))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->setSpacing(24);
    const std::array<QString, 4> names{tr("What is drawn and why"), tr("Resolution"), tr("Time of the frame"),
                                       tr("Passes")};
    for (std::size_t i = 0; i < labels_.size(); ++i) {
        labels_[i] = new QLabel(this);
        labels_[i]->setTextFormat(Qt::PlainText);
        labels_[i]->setAccessibleName(names[i]);
        labels_[i]->setToolTip(names[i]);
        if (i == 2) layout->addWidget(graph_);
        layout->addWidget(labels_[i], i == 0 ? 1 : 0);
    }
    growMinimumWidth(*labels_[0], 80);
    labels_[0]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
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
    labels_[1]->setText(tr("%1 × %2").arg(pixels_.width()).arg(pixels_.height()));
    labels_[2]->setText(tr("%1 ms").arg(numberLocale().toString(milliseconds_, 'f', 1)));
    labels_[2]->setToolTip(tr("Time of the frame, by %1").arg(clock_));
    labels_[3]->setText(tr("%1 passes ran, %2 skipped").arg(ran_).arg(skipped_));
}

void StatusLine::showHelp(const QString& help)
{
    help_ = help;
    showWords();
}

void StatusLine::showWords()
{
    const QString& words = help_.isEmpty() ? shownReason_ : help_;
    labels_[0]->setText(labels_[0]->fontMetrics().elidedText(words, Qt::ElideRight, labels_[0]->width()));
    labels_[0]->setToolTip(words);
}

QString StatusLine::text() const
{
    QStringList all{shownReason_};
    for (std::size_t i = 1; i < labels_.size(); ++i) all << labels_[i]->text();
    return all.join(QStringLiteral(" | "));
}

}  // namespace vitrine::ui

#include "moc_status_line.cpp"
