#include "ui/kit/accessible_plot.h"

#include "ui/kit/theme.h"

namespace vitrine::ui {

AccessiblePlot::AccessiblePlot(QWidget* parent) : QCustomPlot(parent)
{
    setFocusPolicy(Qt::StrongFocus);
}

void AccessiblePlot::setSentences(const QString& sentences)
{
    if (sentences == sentences_) return;
    sentences_ = sentences;
    notifyText(*this);
}

void AccessiblePlot::applyTheme()
{
    const Theme& t = theme();
    setBackground(t.base);
    QColor faint = t.dim;
    faint.setAlphaF(0.25F);
    for (QCPAxis* axis : {xAxis, yAxis}) {
        for (const auto set : {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
            (axis->*set)(QPen(t.dim));
        axis->setTickLabelColor(t.text);
        axis->setLabelColor(t.text);
        axis->grid()->setPen(QPen(faint, 0));
        axis->grid()->setZeroLinePen(QPen(faint, 0));
    }
    legend->setBrush(t.base);
    legend->setBorderPen(Qt::NoPen);
    legend->setTextColor(t.text);
}

void AccessiblePlot::paintEvent(QPaintEvent* event)
{
    QCustomPlot::paintEvent(event);
    if (!hasFocus()) return;
    QPainter painter(this);
    painter.setPen(theme().accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void AccessiblePlot::focusInEvent(QFocusEvent* event)
{
    QCustomPlot::focusInEvent(event);
    update();
}

void AccessiblePlot::focusOutEvent(QFocusEvent* event)
{
    QCustomPlot::focusOutEvent(event);
    update();
}

}  // namespace vitrine::ui

#include "moc_accessible_plot.cpp"
