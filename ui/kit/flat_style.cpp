#include "ui/kit/flat_style.h"

#include "ui/kit/appearance.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"

#include <QLabel>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include <algorithm>

namespace vitrine::ui {
namespace {

QColor veil(float part)
{
    QColor color = theme().text;
    // Faint colors are stronger in a high-contrast theme.
    color.setAlphaF(theme().highContrast ? std::min(1.0F, 2 * part) : part);
    return color;
}

/// Draws the box around text fields, buttons and combo boxes.
void drawField(QPainter* painter, const QRect& rect, QStyle::State state, bool accented = false)
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool enabled = state & QStyle::State_Enabled;
    const bool hovered = enabled && (state & QStyle::State_MouseOver);
    const bool pressed = state & (QStyle::State_Sunken | QStyle::State_On);
    painter->setBrush(veil(pressed ? 0.16F : hovered ? 0.1F : 0.055F));
    const bool focused = state & QStyle::State_HasFocus;
    const double width = focused && theme().highContrast ? 2 : 1;
    painter->setPen(focused && accented   ? QPen(theme().text, width)
                    : focused || accented ? QPen(theme().accent, width)
                                          : QPen(enabled ? theme().outline : veil(0.2F)));
    painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    painter->restore();
}

/// Returns the factor by which marks grow with the widget's font, relative to the usual font size.
double growthOf(const QWidget* widget)
{
    return widget ? grown(100, *widget) / 100.0 : 1;
}

void drawChevron(QPainter* painter, const QPointF& middle, bool enabled, double growth, bool up = false)
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(enabled ? theme().dim : veil(0.2F), 1.4 * growth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const double tip = (up ? -1.5 : 1.5) * growth;
    const double side = 3 * growth;
    const QPointF points[3] = {middle + QPointF(-side, -tip), middle + QPointF(0, tip), middle + QPointF(side, -tip)};
    painter->drawPolyline(points, 3);
    painter->restore();
}

void drawCheckBox(QPainter* painter, const QStyleOption& option)
{
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool on = option.state & QStyle::State_On;
    const bool focused = option.state & QStyle::State_HasFocus;
    QColor fill = theme().accent;
    if (!(option.state & QStyle::State_Enabled)) fill.setAlphaF(0.4F);
    painter->setBrush(on ? fill : veil(option.state & QStyle::State_MouseOver ? 0.14F : 0.08F));
    painter->setPen(focused ? QPen(theme().text) : QPen(on ? QColor(Qt::transparent) : theme().outline));
    painter->drawRoundedRect(box, 3, 3);
    if (on) {
        painter->setPen(
            QPen(theme().dark ? theme().window : QColor(Qt::white), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->translate(box.center());
        painter->scale(box.width() / 14, box.width() / 14);  // The tick grows with its box.
        constexpr QPointF tick[3] = {{-3.4, 0.2}, {-1, 2.8}, {3.6, -2.8}};
        painter->drawPolyline(tick, 3);
    }
    painter->restore();
}

}  // namespace

FlatStyle::FlatStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void FlatStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    // A tooltip is polished before it has a text, and its label is used again for all later texts.
    if (auto* label = qobject_cast<QLabel*>(widget); label && label->textFormat() == Qt::AutoText)
        label->setTextFormat(Qt::PlainText);
}

void FlatStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                              const QWidget* widget) const
{
    switch (element) {
    case PE_PanelLineEdit:
        if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option); frame && frame->lineWidth > 0)
            drawField(painter, option->rect, option->state & ~State_Sunken);
        return;
    case PE_FrameLineEdit: return;
    case PE_IndicatorCheckBox: drawCheckBox(painter, *option); return;
    case PE_PanelButtonTool:
    case PE_PanelButtonCommand: {
        const bool autoRaise = option->state & State_AutoRaise;
        if (autoRaise && !(option->state & (State_MouseOver | State_HasFocus | State_Sunken | State_On))) return;
        drawField(painter, option->rect, option->state, option->state & State_On);
        return;
    }
    case PE_FrameFocusRect: return;  // All our controls show the focus in their own edge.
    case PE_PanelTipLabel:
        painter->save();
        painter->setPen(theme().outline);
        painter->setBrush(theme().base);
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
        painter->restore();
        return;
    case PE_IndicatorArrowDown:
        drawChevron(painter, QRectF(option->rect).center(), option->state & State_Enabled, growthOf(widget));
        return;
    default: QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void FlatStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                            const QWidget* widget) const
{
    if (element == CE_Splitter) return;
    if (element == CE_FocusFrame) {
        painter->setPen(QPen(theme().accent, theme().highContrast ? 2 : 1));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option->rect.adjusted(1, 1, -1, -1));
        return;
    }
    if (element == CE_TabBarTabShape) {
        const bool selected = option->state & State_Selected;
        if (selected)
            painter->fillRect(QRect(option->rect.left() + 8, option->rect.bottom() - 1, option->rect.width() - 16, 2),
                              theme().accent);
        else if (option->state & State_MouseOver)
            painter->fillRect(option->rect, veil(0.05F));
        if (option->state & State_HasFocus) drawField(painter, option->rect, State_Enabled | State_HasFocus);
        return;
    }
    if (element == CE_HeaderSection) {
        painter->fillRect(option->rect, theme().base);
        painter->fillRect(QRect(option->rect.left(), option->rect.bottom(), option->rect.width(), 1), veil(0.1F));
        return;
    }
    if (element == CE_ProgressBarGroove) {
        painter->fillRect(option->rect, veil(0.1F));
        return;
    }
    if (element == CE_ProgressBarContents) {
        if (const auto* bar = qstyleoption_cast<const QStyleOptionProgressBar*>(option);
            bar && bar->maximum > bar->minimum) {
            const double part = static_cast<double>(bar->progress - bar->minimum) / (bar->maximum - bar->minimum);
            painter->fillRect(QRectF(bar->rect.left(), bar->rect.top(), bar->rect.width() * std::clamp(part, 0.0, 1.0),
                                     bar->rect.height()),
                              theme().accent);
        }
        return;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

void FlatStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                                   const QWidget* widget) const
{
    const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    if (button && (button->features & QStyleOptionToolButton::HasMenu) && widget &&
        widget->property(hidesMenuArrow).toBool()) {
        QStyleOptionToolButton plain = *button;
        plain.features &= ~QStyleOptionToolButton::ToolButtonFeatures(QStyleOptionToolButton::HasMenu);
        drawComplexControl(control, &plain, painter, widget);
        return;
    }
    // Fusion draws no panel, and so no focus, for a raised button without the pointer on it.
    constexpr State drawnAnyhow = State_MouseOver | State_Sunken | State_On;
    if (control == CC_ToolButton && (option->state & State_AutoRaise) && (option->state & State_HasFocus) &&
        !(option->state & drawnAnyhow))
        drawField(painter, option->rect, option->state);
    if (control == CC_ComboBox) {
        drawField(painter, option->rect, option->state & ~(State_Sunken | State_On));
        const double growth = growthOf(widget);
        drawChevron(painter, QPointF(option->rect.right() - 10 * growth, QRectF(option->rect).center().y()),
                    option->state & State_Enabled, growth);
        return;
    }
    if (control == CC_SpinBox) {
        drawField(painter, option->rect, option->state & ~(State_Sunken | State_On));
        const QRectF up = subControlRect(CC_SpinBox, option, SC_SpinBoxUp, widget);
        const QRectF down = subControlRect(CC_SpinBox, option, SC_SpinBoxDown, widget);
        drawChevron(painter, up.center(), option->state & State_Enabled, growthOf(widget), true);
        drawChevron(painter, down.center(), option->state & State_Enabled, growthOf(widget));
        return;
    }
    if (control == CC_ScrollBar) {
        const QRect slider = subControlRect(CC_ScrollBar, option, SC_ScrollBarSlider, widget);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(Qt::NoPen);
        painter->setBrush(veil(option->state & State_MouseOver ? 0.35F : 0.18F));
        const QRectF thumb = QRectF(slider).adjusted(2, 2, -2, -2);
        const double radius = std::min(thumb.width(), thumb.height()) / 2;
        painter->drawRoundedRect(thumb, radius, radius);
        painter->restore();
        return;
    }
    QProxyStyle::drawComplexControl(control, option, painter, widget);
}

int FlatStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const
{
    switch (metric) {
    case PM_ScrollBarExtent: return 10;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight: return widget ? grown(15, *widget) : 15;
    case PM_DockWidgetSeparatorExtent: return 4;
    case PM_ToolTipLabelFrameWidth: return 7;
    case PM_FocusFrameHMargin:
    case PM_FocusFrameVMargin: return 0;
    case PM_ButtonShiftHorizontal:
    case PM_ButtonShiftVertical: return 0;
    default: return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

int FlatStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                         QStyleHintReturn* returned) const
{
    if (hint == SH_FocusFrame_AboveWidget) return 1;
    // The desktop's icons may be black, which is invisible on dark themes.
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    if (hint == SH_Widget_Animation_Duration && reducedMotion()) return 0;
    return QProxyStyle::styleHint(hint, option, widget, returned);
}

QSize FlatStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                  const QWidget* widget) const
{
    QSize wanted = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (type == CT_ItemViewItem || type == CT_MenuItem) wanted.rheight() += 4;
    return wanted;
}

QRect FlatStyle::subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                const QWidget* widget) const
{
    const auto* bar = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (control != CC_ScrollBar || !bar) return QProxyStyle::subControlRect(control, option, part, widget);
    // There are no arrow buttons: the thumb moves along the whole length.
    const bool across = bar->orientation == Qt::Horizontal;
    const int length = across ? bar->rect.width() : bar->rect.height();
    const int range = bar->maximum - bar->minimum;
    const int thumb =
        range <= 0 ? length
                   : std::clamp(static_cast<int>(static_cast<double>(length) * bar->pageStep / (range + bar->pageStep)),
                                24, std::max(24, length));
    const int start =
        sliderPositionFromValue(bar->minimum, bar->maximum, bar->sliderPosition, length - thumb, bar->upsideDown);
    const auto at = [&](int from, int size) {
        return across ? QRect(from, 0, size, bar->rect.height()) : QRect(0, from, bar->rect.width(), size);
    };
    switch (part) {
    case SC_ScrollBarSlider: return at(start, thumb);
    case SC_ScrollBarSubPage: return at(0, start);
    case SC_ScrollBarAddPage: return at(start + thumb, length - start - thumb);
    case SC_ScrollBarGroove: return at(0, length);
    default: return {};
    }
}

}  // namespace vitrine::ui

#include "moc_flat_style.cpp"
