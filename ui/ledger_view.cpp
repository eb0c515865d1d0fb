#include "ui/ledger_view.h"

#include "ui/theme.h"

#include <QHeaderView>
#include <QLocale>

namespace vitrine::ui {
namespace {

enum Column { step, work, time, reason };

}  // namespace

LedgerView::LedgerView(QWidget* parent) : QTreeWidget(parent)
{
    setAccessibleName(tr("Ledger"));
    setHeaderLabels({tr("Step"), tr("Work"), tr("ms"), tr("Why")});
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    header()->setStretchLastSection(true);
    header()->resizeSection(step, 220);
    header()->resizeSection(work, 96);
    header()->resizeSection(time, 72);
    timer_.setSingleShot(true);
    timer_.setInterval(500);
    connect(&timer_, &QTimer::timeout, this, &LedgerView::renew);
}

void LedgerView::note(const render::FrameReport& report)
{
    report_ = report;
    if (isVisible() && !timer_.isActive()) timer_.start();
}

void LedgerView::showEvent(QShowEvent* event)
{
    renew();
    QTreeWidget::showEvent(event);
}

void LedgerView::renew()
{
    const int wanted = static_cast<int>(report_.ran.size() + report_.skipped.size());
    while (topLevelItemCount() > wanted) delete takeTopLevelItem(topLevelItemCount() - 1);
    while (topLevelItemCount() < wanted) {
        auto* item = new QTreeWidgetItem(this);
        item->setTextAlignment(time, Qt::AlignRight | Qt::AlignVCenter);
    }
    int row = 0;
    const auto fill = [&](const std::string& name, render::Work kind, const QString& ms, const std::string& why, bool ran) {
        QTreeWidgetItem* item = topLevelItem(row++);
        item->setText(step, QString::fromStdString(name));
        item->setText(work, QString::fromLatin1(render::toString(kind)));
        item->setText(time, ms);
        item->setText(reason, QString::fromStdString(why));
        item->setToolTip(reason, item->text(reason));
        for (int column = 0; column < columnCount(); ++column) item->setForeground(column, ran ? theme().text : theme().dim);
    };
    for (const render::StepReport& s : report_.ran)
        fill(s.name, s.work, s.milliseconds < 0 ? QStringLiteral("–") : QLocale::c().toString(s.milliseconds, 'f', 2), s.reason,
             true);
    for (const render::Skipped& s : report_.skipped) fill(s.name, s.work, tr("skipped"), s.reason, false);
}

}  // namespace vitrine::ui

#include "moc_ledger_view.cpp"
