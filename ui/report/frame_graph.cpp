#include "ui/report/frame_graph.h"

#include "ui/kit/numbers.h"
#include "ui/kit/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vitrine::ui {
namespace {

constexpr double displayFrame = 1000.0 / 60;  // Milliseconds of a frame at 60 Hz.

}  // namespace

FrameGraph::FrameGraph(QWidget* parent) : QWidget(parent)
{
    setFixedSize(sizeHint());
    setAccessibleName(tr("Times of the last frames"));
}

void FrameGraph::add(double milliseconds)
{
    if (!std::isfinite(milliseconds) || milliseconds < 0) return;
    milliseconds_.push_back(milliseconds);
    if (milliseconds_.size() > most) milliseconds_.pop_front();
    setAccessibleDescription(summary());
    update();
}

QString FrameGraph::summary() const
{
    if (milliseconds_.empty()) return tr("No frame has been drawn yet.");
    std::vector<double> sorted(milliseconds_.begin(), milliseconds_.end());
    std::sort(sorted.begin(), sorted.end());
    const auto number = [](double value) { return numberLocale().toString(value, 'f', 1); };
    if (sorted.size() == 1) return tr("1 frame: %1 ms").arg(number(sorted.front()));
    return tr("%1 frames: %2 to %3 ms, half of them up to %4 ms")
        .arg(sorted.size())
        .arg(number(sorted.front()), number(sorted.back()), number(sorted[(sorted.size() - 1) / 2]));
}

bool FrameGraph::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), summary(), this);
        return true;
    }
    return QWidget::event(event);
}

void FrameGraph::paintEvent(QPaintEvent*)
{
    if (milliseconds_.empty()) return;
    QPainter painter(this);
    const double highest = std::max(displayFrame, *std::max_element(milliseconds_.begin(), milliseconds_.end()));
    const int left = width() - 2 * static_cast<int>(milliseconds_.size());
    for (std::size_t i = 0; i < milliseconds_.size(); ++i) {
        const int high = std::max(1, static_cast<int>(std::lround(milliseconds_[i] / highest * height())));
        painter.fillRect(left + 2 * static_cast<int>(i), height() - high, 1, high, theme().dim);
    }
    painter.setPen(theme().accent);
    const int line = height() - 1 - static_cast<int>(std::lround(displayFrame / highest * (height() - 1)));
    painter.drawLine(0, line, width(), line);
}

}  // namespace vitrine::ui

#include "moc_frame_graph.cpp"
