#include "ui/parameters/parameter_row.h"

#include "ui/kit/hyphens.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/make_editor.h"
#include "ui/parameters/row_marks.h"
#include "ui/parameters/shown_text.h"

#include <QGraphicsOpacityEffect>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QResizeEvent>
#include <QTextLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

/// Opacity of a parameter without effect.
float idleInk()
{
    return theme().highContrast ? 0.75F : 0.45F;
}

constexpr int mostLines = 3;     // Lines of a label.
constexpr int markRoom = 14;     // Width in pixels of a mark beside a label.
constexpr int labelShare = 36;   // Percent of a row's width.
constexpr int editorRoom = 231;  // Pixels that the rest of a row keeps before labels take more than their share.
constexpr int roomyLabel = 190;  // Pixels up to which they do so.
constexpr int gaugeWidth = 16;   // Pixels at the usual type size.
constexpr int betweenParts = 4;

void paintWave(QPainter& painter, const QPointF& middle)
{
    QPainterPath wave(middle - QPointF(5, 0));
    wave.cubicTo(middle + QPointF(-3, -6), middle + QPointF(-2, -6), middle);
    wave.cubicTo(middle + QPointF(2, 6), middle + QPointF(3, 6), middle + QPointF(5, 0));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme().accent, 1.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(wave);
}

}  // namespace

RowLabel::RowLabel(const QString& name, ValueEditor* editor, QWidget* parent) : QLabel(name, parent), editor_(editor)
{
    setTextFormat(Qt::PlainText);
    setMinimumWidth(24);
    if (editor->dragsByLabel()) setCursor(Qt::SizeHorCursor);
}

void RowLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QColor ink = isEnabled() ? theme().text : theme().dim;
    if (dim_) ink.setAlphaF(idleInk());
    painter.setPen(ink);
    const int marks = (locked_ ? 1 : 0) + (moving_ ? 1 : 0);
    const int room = roomIn(width());
    QStringList lines = linesIn(room);
    // A name that does not fit is elided in the middle, because names differ at their ends: "Handle radius", "Handle
    // width".
    const int most = std::clamp(height() / fontMetrics().height(), 1, mostLines);
    if (lines.size() > most) {
        const QString rest = lines.mid(most - 1).join(QLatin1Char(' '));
        lines = lines.mid(0, most - 1) << fontMetrics().elidedText(rest, Qt::ElideMiddle, room);
    }
    painter.drawText(QRect(0, 0, room, height()), Qt::AlignLeft | Qt::AlignVCenter, lines.join(QLatin1Char('\n')));
    painter.setRenderHint(QPainter::Antialiasing);
    if (locked_) paintPadlock(painter, {width() - markRoom / 2.0, height() / 2.0 + 1});
    if (moving_) paintWave(painter, {width() - (marks - 0.5) * markRoom, height() / 2.0});
}

int RowLabel::roomIn(int width) const
{
    return width - ((locked_ ? 1 : 0) + (moving_ ? 1 : 0)) * markRoom;
}

QStringList RowLabel::linesIn(int width) const
{
    if (fontMetrics().horizontalAdvance(text()) <= width || width <= 0) return {text()};
    // Only a word that is too long for a line of its own is broken.
    QStringList words = text().split(QLatin1Char(' '));
    for (QString& word : words)
        if (fontMetrics().horizontalAdvance(word) > width) word = withSoftHyphens(word);
    const QString breakable = words.join(QLatin1Char(' '));
    QTextLayout layout(breakable, font());
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    QStringList lines;
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        QString part = breakable.mid(line.textStart(), line.textLength()).trimmed();
        if (part.endsWith(softHyphen)) part.back() = QLatin1Char('-');
        lines << part.remove(softHyphen);
    }
    layout.endLayout();
    return lines;
}

int RowLabel::heightFor(int width) const
{
    const auto lines = static_cast<int>(linesIn(roomIn(width)).size());
    return std::min(lines, mostLines) * fontMetrics().height();
}

bool RowLabel::isWhole() const
{
    const auto lines = static_cast<int>(linesIn(roomIn(width())).size());
    return lines <= mostLines && lines * fontMetrics().height() <= height();
}

void RowLabel::setLocked(bool locked)
{
    locked_ = locked;
    update();
}

void RowLabel::setMoving(bool moving)
{
    if (moving_ == moving) return;
    moving_ = moving;
    update();
}

void RowLabel::setDim(bool dim)
{
    if (dim_ == dim) return;
    dim_ = dim;
    update();
}

void RowLabel::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !editor_->dragsByLabel()) {
        QLabel::mousePressEvent(event);
        return;
    }
    dragging_ = true;
    editor_->labelPressed(event->position().x());
}

void RowLabel::mouseMoveEvent(QMouseEvent* event)
{
    if (dragging_) editor_->labelMoved(event->position().x(), event->modifiers());
}

void RowLabel::mouseReleaseEvent(QMouseEvent*)
{
    if (dragging_) editor_->labelReleased();
    dragging_ = false;
}

ResetDot::ResetDot(QWidget* parent) : QAbstractButton(parent)
{
    growSize(*this, 18, 22);
    setAttribute(Qt::WA_Hover);
    setEnabled(false);
    setFocusPolicy(Qt::NoFocus);
}

void ResetDot::setDiffers(bool differs)
{
    if (differs_ == differs) return;
    differs_ = differs;
    setEnabled(differs);
    setFocusPolicy(differs ? Qt::StrongFocus : Qt::NoFocus);
    update();
}

void ResetDot::paintEvent(QPaintEvent*)
{
    if (!isEnabled()) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    // Painted at the usual font size and scaled.
    painter.translate(QRectF(rect()).center());
    painter.scale(grown(100, *this) / 100.0, grown(100, *this) / 100.0);
    const QPointF center;
    const QColor amber = theme().accent;
    if (!underMouse() && !hasFocus()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(amber);
        painter.drawEllipse(center, 3, 3);
        return;
    }
    // Arrow that turns back.
    painter.setPen(QPen(amber, 1.5, Qt::SolidLine, Qt::RoundCap));
    const QRectF circle(center.x() - 4.5, center.y() - 4.5, 9, 9);
    painter.drawArc(circle, 135 * 16, -270 * 16);
    QPainterPath head;
    const QPointF tip(center.x() - 3.2, center.y() - 3.2);
    head.moveTo(tip + QPointF(-2.6, 2.4));
    head.lineTo(tip + QPointF(-1.6, -2.6));
    head.lineTo(tip + QPointF(2.8, 1.2));
    head.closeSubpath();
    painter.setPen(Qt::NoPen);
    painter.setBrush(amber);
    painter.drawPath(head);
}

GaugeMark::GaugeMark(QWidget* parent) : QAbstractButton(parent)
{
    growSize(*this, gaugeWidth, 22);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
}

void GaugeMark::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(QRectF(rect()).center());
    painter.scale(grown(100, *this) / 100.0, grown(100, *this) / 100.0);
    const QPointF center(0, 2);
    painter.setPen(QPen(underMouse() || hasFocus() ? theme().accent : theme().dim, 1.3, Qt::SolidLine, Qt::RoundCap));
    painter.drawArc(QRectF(center.x() - 5, center.y() - 5, 10, 10), -20 * 16, 220 * 16);
    painter.drawLine(center, center + QPointF(2.6, -2.6));
}

IdleMark::IdleMark(QWidget* parent) : QAbstractButton(parent)
{
    growSize(*this, 16, 22);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
}

void IdleMark::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double radius = width() * 0.44;
    const QPointF center = QRectF(rect()).center();
    painter.setPen(QPen(underMouse() || hasFocus() ? theme().accent : theme().dim, 1.2));
    painter.drawEllipse(center, radius, radius);
    QFont small = painter.font();
    small.setPixelSize(static_cast<int>(1.5 * radius));
    painter.setFont(small);
    painter.drawText(rect(), Qt::AlignCenter, QStringLiteral("?"));
}

ParameterRow::ParameterRow(const ValueRef& value, QWidget* parent, Label words)
    : QWidget(parent), value_(value), editor_(makeEditor(value, this)),
      label_(new RowLabel(translatedText(words == Label::whole ? label(value.info()) : labelInGroup(value.info())),
                          editor_, this)),
      naming_(new QWidget(this)), dot_(new ResetDot(this))
{
    const ParameterInfo& row = info();
    const QString name = translatedText(label(row));
    setToolTip(tooltipText(row));
    setAttribute(Qt::WA_Hover);
    setFocusPolicy(Qt::NoFocus);
    dot_->setAccessibleName(tr("Reset %1").arg(name));
    dot_->setToolTip(tr("Reset to %1").arg(shownText(row, row.initial)));

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(16, 2, 2, 2);
    layout->setSpacing(4);
    const bool quality = row.qualityReference.has_value();
    if (quality) {
        gauge_ = new GaugeMark(this);
        gauge_->setAccessibleName(tr("%1: what does accuracy cost?").arg(name));
        gauge_->setToolTip(tr("What does accuracy cost?"));
        gauge_->hide();
        connect(gauge_, &QAbstractButton::clicked, this, &ParameterRow::accuracyAsked);
    }
    // Label and gauge share one width, so that all editors begin at the same place.
    auto* naming = new QHBoxLayout;
    naming->setContentsMargins(0, 0, 0, 0);
    naming->setSpacing(betweenParts);
    naming->addWidget(label_, 1);
    why_ = new IdleMark(this);
    why_->setAccessibleName(tr("%1: why does it have no effect?").arg(name));
    why_->setToolTip(tr("Why does it have no effect?"));
    why_->hide();
    connect(why_, &QAbstractButton::clicked, this,
            [this] { emit wayAsked(why_->mapToGlobal(QPoint(0, why_->height()))); });
    naming->addWidget(why_);
    if (gauge_) naming->addWidget(gauge_);
    naming_->setLayout(naming);
    followType(*this, [this] {
        alignEditors();
        if (isVisible())
            fitLabel();
        else
            setFixedHeight(grown(rowHeight, *this));  // Its width is not known yet.
    });
    layout->addWidget(naming_);
    layout->addWidget(editor_, 1);
    layout->addWidget(dot_);

    connect(dot_, &QAbstractButton::clicked, this, &ParameterRow::reset);
    showValue(value.value());
}

void ParameterRow::reset()
{
    value_.reset(newGesture(), tr("Reset %1").arg(midSentence(translatedText(label(info())))));
}

void ParameterRow::showValue(const Value& value)
{
    editor_->showValue(value);
    differs_ = !(value == info().initial) || !motion_.isEmpty();
    dot_->setDiffers(differs_);
}

void ParameterRow::setIdle(const QString& when)
{
    if (when == idleUntil_) return;
    idleUntil_ = when;
    label_->setDim(idle());
    why_->setVisible(idle());
    if (isVisible()) fitLabel();
    QGraphicsOpacityEffect* gray = nullptr;
    if (idle()) {
        gray = new QGraphicsOpacityEffect(editor_);
        gray->setOpacity(idleInk());
    }
    editor_->setGraphicsEffect(gray);
    describe();
}

QString ParameterRow::whyIdle() const
{
    return idle() ? tr("Not used now; only used when %1. Its value is kept.").arg(idleUntil_) : QString();
}

void ParameterRow::setMotion(const QString& how)
{
    if (how == motion_) return;
    motion_ = how;
    label_->setMoving(!how.isEmpty());
    if (isVisible()) fitLabel();
    describe();
}

void ParameterRow::describe()
{
    QStringList now;
    if (idle()) now << whyIdle();
    if (!controlledBy_.isEmpty()) now << controlledBy_;
    if (!motion_.isEmpty()) now << tr("Animated: %1. Setting it by hand stops the animation.").arg(motion_);
    setAccessibleDescription(now.join(QLatin1Char(' ')));
    now << tooltipText(info());
    setToolTip(now.join(QStringLiteral("\n\n")));
}

void ParameterRow::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    alignEditors();
    fitLabel();
}

void ParameterRow::setController(const ParameterNote& note)
{
    if (note.explanation == controlledBy_) return;
    controlledBy_ = note.explanation;
    if (!controller_) {
        controller_ = new QLabel(this);
        controller_->setTextFormat(Qt::PlainText);
        controller_->setForegroundRole(QPalette::PlaceholderText);
        followType(*controller_, [this] { placeController(); });
    }
    const bool shown = !note.text.isEmpty();
    if (shown == controller_->isHidden()) {
        controller_->setVisible(shown);
        placeController();
        if (isVisible()) fitLabel();
    }
    controller_->setText(note.text);
    controller_->setAccessibleName(tr("Controller of %1: %2").arg(translatedText(label(info())), note.text));
    describe();
}

void ParameterRow::placeController()
{
    const int height = controller_ && !controller_->isHidden() ? controller_->fontMetrics().height() : 0;
    const QMargins margins = layout()->contentsMargins();
    layout()->setContentsMargins(margins.left(), margins.top(), margins.right(), 2 + height);
    if (height > 0)
        controller_->setGeometry(margins.left(), this->height() - height - 1, width() - margins.left() - 2, height);
}

void ParameterRow::alignEditors()
{
    // All rows have the same width, so that all editors begin at the same place.
    const int roomy = std::min(width() - grown(editorRoom, *this), grown(roomyLabel, *this));
    naming_->setFixedWidth(std::clamp(std::max(width() * labelShare / 100, roomy), grown(narrowestLabel, *this),
                                      grown(widestLabel, *this)));
}

void ParameterRow::fitLabel()
{
    int room = naming_->maximumWidth();
    for (const QWidget* mark : std::initializer_list<QWidget*>{why_, gauge_})
        if (mark && !mark->isHidden()) room -= mark->maximumWidth() + betweenParts;
    const int below = controller_ && !controller_->isHidden() ? controller_->fontMetrics().height() : 0;
    setFixedHeight(std::max(grown(rowHeight, *this), label_->heightFor(room) + grown(4, *this)) + below);
    placeController();
}

int ParameterRow::widthForLabel(const ParameterInfo& parameter, const QWidget& panel)
{
    const int gauge = parameter.qualityReference ? grown(gaugeWidth, panel) + betweenParts : 0;
    const int naming = panel.fontMetrics().horizontalAdvance(
                           translatedText(parameter.essential ? label(parameter) : labelInGroup(parameter))) +
                       1 + gauge;
    if (naming <= grown(roomyLabel, panel)) return naming + grown(editorRoom, panel);
    return (std::min(naming, grown(widestLabel, panel)) * 100 + labelShare - 1) / labelShare;
}

void ParameterRow::addButton()
{
    auto* button = new QPushButton(tr("Press"), this);
    button->setAccessibleName(tr("Press %1").arg(midSentence(translatedText(label(info())))));
    button->setToolTip(tr("Press it for one step of the shader"));
    button->setAutoDefault(false);
    auto* line = static_cast<QHBoxLayout*>(layout());
    line->insertWidget(line->indexOf(editor_), button);
    connect(button, &QPushButton::clicked, this, &ParameterRow::pushed);
}

void ParameterRow::setGaugeShown(bool shown)
{
    if (gauge_) gauge_->setVisible(shown);
    if (isVisible()) fitLabel();
}

void ParameterRow::setLocked(bool locked)
{
    label_->setLocked(locked);
    if (isVisible()) fitLabel();
}

}  // namespace vitrine::ui

#include "moc_parameter_row.cpp"
