#include "ui/window/ledger_view.h"

#include "ui/kit/theme.h"

#include <QHeaderView>
#include <QLocale>

namespace vitrine::ui {
namespace {

enum Column { step, work, time, saved, reason };

}  // namespace

LedgerView::LedgerView(QWidget* parent) : QTreeWidget(parent)
{
    setAccessibleName(tr("Ledger"));
    setHeaderLabels({tr("Step"), tr("Work"), tr("ms"), tr("Saved"), tr("Why")});
    headerItem()->setToolTip(
        saved, tr("Milliseconds that a skipped step took when it last ran. “Run everything” measures them all."));
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    header()->setStretchLastSection(true);
    header()->resizeSection(step, 220);
    header()->resizeSection(work, 96);
    header()->resizeSection(time, 72);
    header()->resizeSection(saved, 72);
    timer_.setSingleShot(true);
    timer_.setInterval(500);
    connect(&timer_, &QTimer::timeout, this, &LedgerView::renew);
}

void LedgerView::note(const render::FrameReport& report)
{
    report_ = report;
    costs_.note(report);
    if (isVisible() && !timer_.isActive()) timer_.start();
}

void LedgerView::setTitles(const QHash<QString, QString>& titles)
{
    titles_ = titles;
}

QString LedgerView::stepText(const QString& name) const
{
    const qsizetype slash = name.indexOf(QLatin1Char('/'));
    const auto title = titles_.constFind(name.left(slash));
    if (title == titles_.constEnd()) return name;
    return slash < 0 ? *title : *title + QStringLiteral(": ") + name.mid(slash + 1);
}

void LedgerView::showEvent(QShowEvent* event)
{
    renew();
    QTreeWidget::showEvent(event);
}

std::vector<std::pair<std::string, double>> LedgerView::otherVariants(const render::StepReport& ran) const
{
    auto others = costs_.variantsOf(ran.name);
    std::erase_if(others, [&](const auto& variant) { return variant.first == ran.variant; });
    return others;
}

void LedgerView::renew()
{
    std::size_t steps = report_.ran.size() + report_.skipped.size();
    for (const render::StepReport& s : report_.ran) steps += s.effects.size() + otherVariants(s).size();
    const int wanted = static_cast<int>(steps);
    while (topLevelItemCount() > wanted) delete takeTopLevelItem(topLevelItemCount() - 1);
    while (topLevelItemCount() < wanted) {
        auto* item = new QTreeWidgetItem(this);
        for (const int number : {time, saved}) item->setTextAlignment(number, Qt::AlignRight | Qt::AlignVCenter);
    }
    int row = 0;
    const auto milliseconds = [](double ms) {
        return ms < 0 ? QStringLiteral("–") : QLocale::c().toString(ms, 'f', 2);
    };
    const auto fill = [&](const std::string& name, render::Work kind, const QString& ms, const QString& notSpent,
                          const std::string& why, bool ran) {
        QTreeWidgetItem* item = topLevelItem(row++);
        item->setText(step, stepText(QString::fromStdString(name)));
        item->setToolTip(step, QString::fromStdString(name));
        item->setText(work, QString::fromLatin1(render::toString(kind)));
        item->setText(time, ms);
        item->setText(saved, notSpent);
        item->setText(reason, QString::fromStdString(why));
        item->setToolTip(reason, item->text(reason));
        for (int column = 0; column < columnCount(); ++column)
            item->setForeground(column, ran ? theme().text : theme().dim);
    };
    for (const render::StepReport& s : report_.ran) {
        fill(s.name, s.work, milliseconds(s.milliseconds), {},
             s.reason + (s.variant.empty() ? std::string() : "; " + s.variant) +
                 (s.bound.isKnown() ? "; " + toString(s.bound) : std::string()),
             true);
        for (const render::Effect& e : s.effects)
            fill(e.name, s.work, tr("in the step above"), {},
                 e.bound.isKnown() ? toString(e.bound) : tr("may change any pixel").toStdString(), true);
        for (const auto& [variant, ms] : otherVariants(s))
            fill(s.name, s.work, milliseconds(ms), {}, variant + tr("; when it was last drawn").toStdString(), false);
    }
    for (const render::CulledPass& s : report_.skipped)
        fill(s.name, s.work, tr("skipped"), milliseconds(costs_.of(s.name)),
             s.reason + (s.boundIsZero ? "; would change nothing" : ""), false);
}

}  // namespace vitrine::ui

#include "moc_ledger_view.cpp"
