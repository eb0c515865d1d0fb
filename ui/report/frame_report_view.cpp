#include "ui/report/frame_report_view.h"

#include "exhibits/compare/pass_costs.h"
#include "ui/kit/language.h"
#include "ui/kit/numbers.h"
#include "ui/kit/theme.h"

#include <QHeaderView>

#include <algorithm>

namespace vitrine::ui {
namespace {

enum Column { step, work, time, saved, reason, other };

QString millisecondsText(double ms)
{
    return ms < 0 ? QStringLiteral("–") : numberLocale().toString(ms, 'f', 2);
}

}  // namespace

FrameReportView::FrameReportView(QWidget* parent) : QTreeWidget(parent)
{
    setAccessibleName(tr("Frame report"));
    setHeaderLabels({tr("Step"), tr("Kind of work"), tr("ms"), tr("Saved"), tr("Why"), tr("B, ms")});
    headerItem()->setToolTip(
        saved, tr("Milliseconds that a skipped pass took when it last ran. “Run everything” measures all of them."));
    headerItem()->setToolTip(other, tr("Milliseconds of the same pass with settings B, in a complete frame that reuses "
                                       "nothing from the previous one."));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    header()->setStretchLastSection(true);
    header()->resizeSection(step, 220);
    header()->resizeSection(work, 96);
    header()->resizeSection(time, 72);
    header()->resizeSection(saved, 72);
    header()->resizeSection(other, 72);
    header()->moveSection(other, saved);  // Beside the milliseconds of A.
    setColumnHidden(other, true);
    timer_.setSingleShot(true);
    timer_.setInterval(500);
    connect(&timer_, &QTimer::timeout, this, &FrameReportView::renew);
}

void FrameReportView::note(const render::FrameReport& report)
{
    report_ = report;
    costs_.note(report);
    if (isVisible() && !timer_.isActive()) timer_.start();
}

void FrameReportView::noteOther(std::optional<render::FrameReport> report)
{
    if (!report && !other_) return;
    other_ = std::move(report);
    setColumnHidden(other, !other_);
    headerItem()->setText(time, other_ ? tr("A, ms") : tr("ms"));
    if (isVisible() && !timer_.isActive()) timer_.start();
}

void FrameReportView::setTitles(const QHash<QString, QString>& titles)
{
    titles_ = titles;
}

QString FrameReportView::stepText(const QString& name) const
{
    const qsizetype slash = name.indexOf(QLatin1Char('/'));
    const auto title = titles_.constFind(name.left(slash));
    if (title == titles_.constEnd()) return name;
    return slash < 0 ? *title : *title + QStringLiteral(": ") + name.mid(slash + 1);
}

void FrameReportView::showEvent(QShowEvent* event)
{
    renew();
    QTreeWidget::showEvent(event);
}

std::vector<std::pair<std::string, double>> FrameReportView::otherVariants(const render::StepReport& ran) const
{
    auto others = costs_.variantsOf(ran.name);
    std::erase_if(others, [&](const auto& variant) { return variant.first == ran.variant; });
    return others;
}

std::vector<FrameReportView::Line> FrameReportView::lines() const
{
    std::vector<Line> all;
    const auto add = [&](const std::string& name, render::Work kind, const QString& ms, const QString& notSpent,
                         const std::string& why, bool ran) {
        all.push_back({name, translatedText(render::toString(kind)), ms, {}, notSpent, translatedText(why), ran});
    };
    for (const render::StepReport& s : report_.ran) {
        add(s.name, s.work, millisecondsText(s.milliseconds), {},
            s.reason + (s.variant.empty() ? std::string() : "; " + s.variant) +
                (s.bound.isKnown() ? "; " + toString(s.bound) : std::string()),
            true);
        for (const render::Effect& e : s.effects)
            add(e.name, s.work, tr("in the step above"), {},
                e.bound.isKnown() ? toString(e.bound) : tr("may change any pixel").toStdString(), true);
        for (const auto& [variant, ms] : otherVariants(s))
            add(s.name, s.work, millisecondsText(ms), {}, variant + tr("; when it was last drawn").toStdString(),
                false);
    }
    for (const render::CulledPass& s : report_.skipped)
        add(s.name, s.work, tr("skipped"), millisecondsText(costs_.of(s.name)),
            s.reason + (s.boundIsZero ? "; would change nothing" : ""), false);
    return all;
}

void FrameReportView::addOther(std::vector<Line>& all) const
{
    const auto textOf = [](const compare::PassSide& side) {
        if (side.state == compare::PassSide::State::absent) return QStringLiteral("–");
        return side.state == compare::PassSide::State::skipped ? tr("skipped") : millisecondsText(side.milliseconds);
    };
    for (const compare::PassCost& cost : compare::passCosts(report_, *other_)) {
        // First line of this pass without a value for B.
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const Line& l) { return l.name == cost.name && l.other.isEmpty(); });
        if (cost.a.state == compare::PassSide::State::absent || found == all.end())
            all.push_back({cost.name,
                           translatedText(render::toString(cost.work)),
                           QStringLiteral("–"),
                           textOf(cost.b),
                           {},
                           tr("only B: %1").arg(translatedText(cost.b.why)),
                           cost.b.state == compare::PassSide::State::ran});
        else
            found->other = textOf(cost.b);
    }
    const auto count = [](const std::optional<std::int64_t>& n) {
        return n ? numberLocale().toString(static_cast<qlonglong>(*n)) : QStringLiteral("–");
    };
    for (const compare::CounterCost& cost : compare::counterCosts(report_, *other_))
        all.push_back({cost.name,
                       tr("count"),
                       count(cost.a),
                       count(cost.b),
                       {},
                       cost.a == cost.b ? tr("the same in both") : QString(),
                       cost.a != cost.b});
}

void FrameReportView::renew()
{
    std::vector<Line> all = lines();
    if (other_) addOther(all);
    const int wanted = static_cast<int>(all.size());
    while (topLevelItemCount() > wanted) delete takeTopLevelItem(topLevelItemCount() - 1);
    while (topLevelItemCount() < wanted) {
        auto* item = new QTreeWidgetItem(this);
        for (const int number : {time, saved, other}) item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
    }
    for (int row = 0; row < wanted; ++row) {
        const Line& line = all[static_cast<std::size_t>(row)];
        QTreeWidgetItem* item = topLevelItem(row);
        item->setText(step, stepText(QString::fromStdString(line.name)));
        item->setToolTip(step, QString::fromStdString(line.name));
        item->setText(work, line.work);
        item->setText(time, line.time);
        item->setText(other, line.other);
        item->setText(saved, line.saved);
        item->setText(reason, line.reason);
        item->setToolTip(reason, line.reason);
        for (int column = 0; column < columnCount(); ++column)
            item->setForeground(column, line.ran ? theme().text : theme().dim);
    }
    // Columns with a text in place of a number are widened to it.
    for (const int column : {work, time, saved, other})
        if (!isColumnHidden(column) && sizeHintForColumn(column) > columnWidth(column)) resizeColumnToContents(column);
}

}  // namespace vitrine::ui

#include "moc_frame_report_view.cpp"
