#include "ui/parameters/parameter_section.h"

#include "ui/kit/menu_text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/row_marks.h"

#include <QContextMenuEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {

SectionHeading::SectionHeading(const QString& title, QWidget* parent) : QAbstractButton(parent)
{
    setText(title);
    setAccessibleName(title);
    setCheckable(true);
    setChecked(true);
    growHeight(*this, 28);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_Hover);
    describe();
}

void SectionHeading::setLocked(bool locked)
{
    if (locked_ == locked) return;
    locked_ = locked;
    describe();
}

void SectionHeading::setTogether(int groups)
{
    if (together_ == groups) return;
    together_ = groups;
    describe();
}

void SectionHeading::setIdle(const QString& why)
{
    if (whyIdle_ == why) return;
    whyIdle_ = why;
    describe();
}

void SectionHeading::describe()
{
    QStringList now;
    if (!whyIdle_.isEmpty()) now << whyIdle_;
    if (locked_) now << tr("All its parameters are excluded from randomizing.");
    if (together_ > 0) now << tr("Edited together: a change here changes all %n groups.", nullptr, together_);
    setAccessibleDescription(now.join(QLatin1Char(' ')));
    now << tr("Fold or unfold %1; a right click, or the dots at its end, offers more.").arg(text());
    setToolTip(now.join(QStringLiteral("\n\n")));
    update();
}

QRect SectionHeading::menuPlace() const
{
    return {width() - 46, 0, 26, height()};
}

bool SectionHeading::hitButton(const QPoint& at) const
{
    return QAbstractButton::hitButton(at) && !menuPlace().contains(at);
}

void SectionHeading::mousePressEvent(QMouseEvent* event)
{
    QAbstractButton::mousePressEvent(event);
    if (event->button() == Qt::LeftButton && menuPlace().contains(event->pos()))
        emit menuAsked(mapToGlobal(menuPlace().bottomLeft()));
}

void SectionHeading::contextMenuEvent(QContextMenuEvent* event)
{
    emit menuAsked(event->reason() == QContextMenuEvent::Mouse ? event->globalPos()
                                                               : mapToGlobal(QPoint(22, height())));
}

void SectionHeading::setMarked(bool marked)
{
    if (marked_ == marked) return;
    marked_ = marked;
    update();
}

void SectionHeading::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colors = theme();
    QColor line = colors.text;
    line.setAlphaF(0.08F);
    painter.fillRect(QRect(0, 0, width(), 1), line);

    const double growth = grown(100, *this) / 100.0;
    painter.save();
    painter.translate(11 * growth, height() / 2.0 + 1);
    painter.scale(growth, growth);
    painter.setPen(QPen(hasFocus() ? colors.accent : colors.dim, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    constexpr QPointF chevronOpen[3] = {{-3, -1.5}, {0, 1.5}, {3, -1.5}};
    constexpr QPointF chevronClosed[3] = {{-1.5, -3}, {1.5, 0}, {-1.5, 3}};
    painter.drawPolyline(isChecked() ? chevronOpen : chevronClosed, 3);
    painter.restore();

    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    const bool active = hasFocus() || underMouse();
    painter.setPen(active ? colors.text : colors.dim);
    const QRect room = rect().adjusted(grown(22, *this), 1, -50, 0);
    const QString words = painter.fontMetrics().elidedText(text(), Qt::ElideRight, room.width());
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, words);
    int right = room.left() + painter.fontMetrics().horizontalAdvance(words) + 10;
    if (locked_) {
        paintPadlock(painter, {right + 4.0, height() / 2.0 + 2});
        right += 16;
    }
    if (together_ > 0) {
        font.setWeight(QFont::Normal);
        painter.setFont(font);
        painter.setPen(colors.accent);
        const QRect rest(right, room.top(), room.right() - right, room.height());
        painter.drawText(
            rest, Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(tr("all %n together", nullptr, together_), Qt::ElideRight, rest.width()));
    }
    if (active) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.text);
        for (const int x : {-5, 0, 5}) painter.drawEllipse(QPointF(menuPlace().center()) + QPointF(x, 1), 1.4, 1.4);
    }
    if (marked_) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(colors.accent);
        painter.drawEllipse(QPointF(width() - 11, height() / 2.0), 3, 3);
    }
}

ParameterSection::ParameterSection(const QString& title, QWidget* parent) : QWidget(parent), title_(title)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, title.isEmpty() ? 4 : 6);
    layout->setSpacing(0);
    if (title.isEmpty()) return;
    heading_ = new SectionHeading(title, this);
    layout->addWidget(heading_);
    addNotice();
    connect(heading_, &SectionHeading::menuAsked, this, &ParameterSection::menuAsked);
    // `clicked` is not used, because screen readers toggle without a click.
    connect(heading_, &QAbstractButton::toggled, this, [this](bool open) {
        layOut();
        emit foldedByVisitor(!open);
    });
}

void ParameterSection::add(ParameterRow* row)
{
    rows_.push_back(row);
    layout()->addWidget(row);
}

bool ParameterSection::folded() const
{
    return heading_ && !heading_->isChecked();
}

void ParameterSection::setFolded(bool folded)
{
    if (!heading_) return;
    const QSignalBlocker quiet(heading_);
    heading_->setChecked(!folded);
    layOut();
}

bool ParameterSection::shows(const ParameterRow& row) const
{
    return row.wanted() && (!onlyChanged_ || row.differs());
}

int ParameterSection::showOnlyChanged(bool only)
{
    onlyChanged_ = only;
    layOut();
    return static_cast<int>(
        std::count_if(rows_.begin(), rows_.end(), [this](const ParameterRow* row) { return shows(*row); }));
}

void ParameterSection::refresh()
{
    const bool changed =
        std::any_of(rows_.begin(), rows_.end(), [](const ParameterRow* row) { return row->differs(); });
    if (heading_) heading_->setMarked(changed && folded());
}

void ParameterSection::setLocked(bool locked)
{
    if (heading_) heading_->setLocked(locked);
}

void ParameterSection::setTogether(int groups)
{
    if (heading_) heading_->setTogether(groups);
    together_ = groups > 0;
    update();
}

void ParameterSection::addNotice()
{
    notice_ = new QWidget(this);
    reason_ = new QLabel(notice_);
    reason_->setTextFormat(Qt::PlainText);
    reason_->setWordWrap(true);
    reason_->setForegroundRole(QPalette::PlaceholderText);
    act_ = new QPushButton(notice_);
    act_->setFocusPolicy(Qt::StrongFocus);
    act_->setMinimumWidth(80);  // A long command is cut off before it widens the panel.
    connect(act_, &QPushButton::clicked, this, &ParameterSection::actAsked);
    auto* lines = new QVBoxLayout(notice_);
    lines->setContentsMargins(22, 0, 8, 6);
    lines->setSpacing(4);
    lines->addWidget(reason_);
    lines->addWidget(act_, 0, Qt::AlignLeft);
    layout()->addWidget(notice_);
    notice_->hide();
}

void ParameterSection::setIdle(const QString& when, const QString& command)
{
    if (!heading_ || (when == when_ && command == act_->toolTip())) return;
    when_ = when;
    const QString why = when.isEmpty() ? QString() : tr("No effect now; only used when %1.").arg(when);
    reason_->setText(why);
    heading_->setIdle(why);
    act_->setText(menuText(command));
    act_->setToolTip(command);
    act_->setAccessibleName(tr("%1: %2").arg(title_, command));
    act_->setVisible(!command.isEmpty());
    layOut();
}

void ParameterSection::paintEvent(QPaintEvent*)
{
    if (!together_) return;
    QPainter(this).fillRect(QRect(0, 1, 3, height() - 1), theme().accent);
}

void ParameterSection::layOut()
{
    bool any = false;
    for (ParameterRow* row : rows_) {
        any = any || shows(*row);
        row->setVisible(shows(*row) && (onlyChanged_ || !folded()));
    }
    if (notice_) notice_->setVisible(!when_.isEmpty() && !onlyChanged_);
    setVisible(any);
    refresh();
}

}  // namespace vitrine::ui

#include "moc_parameter_section.cpp"
