#include "ui/parameters/color_picker.h"

#include "ui/kit/theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

constexpr double barHeight = 16, gap = 8, rim = 6;  // Pixels; the rim has room for half a handle.

QColor ofHsv(double hue, double saturation, double value)
{
    return QColor::fromHsvF(static_cast<float>(hue), static_cast<float>(saturation), static_cast<float>(value));
}

}  // namespace

ColorField::ColorField(const QColor& start, QWidget* parent)
    : QWidget(parent), hue_(std::max(0.0F, start.hsvHueF())), saturation_(start.hsvSaturationF()),
      value_(start.valueF())
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Color"));
    setToolTip(tr("Saturation to the right, brightness upward; hue in the bar.\nArrows move in the field, with Ctrl in "
                  "the bar."));
    setMinimumSize(160, 120);
}

QColor ColorField::color() const
{
    return ofHsv(hue_, saturation_, value_).toRgb();
}

QString ColorField::accessibleText() const
{
    return tr("Hue %1 degrees, saturation %2 %, brightness %3 %.")
        .arg(std::lround(hue_ * 360))
        .arg(std::lround(saturation_ * 100))
        .arg(std::lround(value_ * 100));
}

QRectF ColorField::field() const
{
    return QRectF(rim, rim, width() - 2 * rim, height() - 2 * rim - gap - barHeight);
}

QRectF ColorField::bar() const
{
    return QRectF(rim, height() - rim - barHeight, width() - 2 * rim, barHeight);
}

QPointF ColorField::placeOf(double saturation, double value) const
{
    return {field().left() + saturation * field().width(), field().bottom() - value * field().height()};
}

QPointF ColorField::placeOfHue(double hue) const
{
    return {bar().left() + hue * bar().width(), bar().center().y()};
}

void ColorField::set(double hue, double saturation, double value)
{
    hue_ = std::clamp(hue, 0.0, 1.0);
    saturation_ = std::clamp(saturation, 0.0, 1.0);
    value_ = std::clamp(value, 0.0, 1.0);
    update();
    notifyText(*this);
    emit picked(color());
}

void ColorField::take(const QPointF& at)
{
    if (inBar_)
        set((at.x() - bar().left()) / bar().width(), saturation_, value_);
    else
        set(hue_, (at.x() - field().left()) / field().width(), (field().bottom() - at.y()) / field().height());
}

void ColorField::mousePressEvent(QMouseEvent* event)
{
    inBar_ = event->position().y() > field().bottom() + gap / 2;
    take(event->position());
}

void ColorField::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton) take(event->position());
}

void ColorField::keyPressEvent(QKeyEvent* event)
{
    const int right = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
    const int up = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
    if (right == 0 && up == 0) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->modifiers() & Qt::ControlModifier)
        set(hue_ + (right + up) / 360.0, saturation_, value_);
    else
        set(hue_, saturation_ + right / 100.0, value_ + up / 100.0);
}

void ColorField::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QLinearGradient across(field().topLeft(), field().topRight());
    across.setColorAt(0, Qt::white);
    across.setColorAt(1, ofHsv(hue_, 1, 1));
    painter.fillRect(field(), across);
    QLinearGradient down(field().topLeft(), field().bottomLeft());
    down.setColorAt(0, QColor(0, 0, 0, 0));
    down.setColorAt(1, Qt::black);
    painter.fillRect(field(), down);
    QLinearGradient hues(bar().topLeft(), bar().topRight());
    for (int i = 0; i <= 6; ++i) hues.setColorAt(i / 6.0, ofHsv(i / 6.0, 1, 1));
    painter.fillRect(bar(), hues);

    const auto handle = [&](const QPointF& at, const QColor& fill) {
        painter.setPen(QPen(hasFocus() ? theme().accent : QColor(Qt::black), 1));
        painter.setBrush(Qt::white);
        painter.drawEllipse(at, 6, 6);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawEllipse(at, 4, 4);
    };
    handle(placeOf(saturation_, value_), color());
    handle(placeOfHue(hue_), ofHsv(hue_, 1, 1));
}

ColorDialog::ColorDialog(const QString& heading, const QColor& start, QWidget* parent)
    : InlineDialog(heading, tr("OK"), parent)
{
    auto* field = new ColorField(start, this);
    body().addWidget(field);
    connect(field, &ColorField::picked, this, &ColorDialog::picked);
    field->setFocus();
}

}  // namespace vitrine::ui

#include "moc_color_picker.cpp"
