#include "ui/parameters/parameter_section.h"

#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/parameter_row.h"

#include <QPainter>
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
    setToolTip(tr("Fold or unfold %1").arg(title));
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

    const QPointF middle(11, height() / 2.0 + 1);
    painter.setPen(QPen(hasFocus() ? colors.accent : colors.dim, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF chevronOpen[3] = {middle + QPointF(-3, -1.5), middle + QPointF(0, 1.5), middle + QPointF(3, -1.5)};
    const QPointF chevronClosed[3] = {middle + QPointF(-1.5, -3), middle + QPointF(1.5, 0), middle + QPointF(-1.5, 3)};
    painter.drawPolyline(isChecked() ? chevronOpen : chevronClosed, 3);

    QFont font = painter.font();
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(hasFocus() || underMouse() ? colors.text : colors.dim);
    painter.drawText(rect().adjusted(22, 1, -24, 0), Qt::AlignLeft | Qt::AlignVCenter, text());
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
    connect(heading_, &QAbstractButton::clicked, this, [this](bool open) {
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
    heading_->setChecked(!folded);
    layOut();
}

int ParameterSection::filter(const QString& words, bool onlyChanged)
{
    words_ = words;
    onlyChanged_ = onlyChanged;
    layOut();
    return static_cast<int>(std::count_if(rows_.begin(), rows_.end(), [&](const ParameterRow* row) {
        return row->wanted() && row->matches(words_) && (!onlyChanged_ || row->differs());
    }));
}

void ParameterSection::refresh()
{
    const bool changed =
        std::any_of(rows_.begin(), rows_.end(), [](const ParameterRow* row) { return row->differs(); });
    if (heading_) heading_->setMarked(changed && folded());
}

void ParameterSection::layOut()
{
    const bool filtering = !words_.isEmpty() || onlyChanged_;
    bool any = false;
    for (ParameterRow* row : rows_) {
        const bool matches = row->wanted() && row->matches(words_) && (!onlyChanged_ || row->differs());
        any = any || matches;
        row->setVisible(matches && (filtering || !folded()));
    }
    setVisible(any);
    refresh();
}

}  // namespace vitrine::ui

#include "moc_parameter_section.cpp"
