// The menu of a row: values copied and pasted, rows that move, that are copied from and to B, that are locked.
#include "ui/kit/language.h"
#include "ui/parameters/parameter_panel.h"

#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/model/other_settings.h"
#include "ui/parameters/group_edits.h"
#include "ui/parameters/motion_dialog.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/shown_text.h"
#include "ui/parameters/way_to_act.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QToolTip>

namespace vitrine::ui {
namespace {

QString rowLabel(const ParameterInfo& row)
{
    return said(label(row));
}

}  // namespace

void ParameterPanel::openMenu(std::size_t row, const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const ParameterInfo& info = values().rows()[row];
    QAction* reset =
        menu->addAction(tr("Reset to %1").arg(shownText(info, info.initial)), rows_[row], &ParameterRow::reset);
    reset->setEnabled(!values().isInitial(row) || values().motion(row));
    addWayTo(*menu, row);
    menu->addSeparator();
    if (gauges_ && info.qualityReference)
        menu->addAction(tr("What does accuracy cost?"), this, [this, row] { emit accuracyAsked(row); });
    menu->addAction(tr("Copy value"), this, [this, row] { copy(row); });
    menu->addAction(tr("Paste"), this, [this, row] { paste(row); });
    menu->addAction(tr("Copy all as JSON"), this, [this] { copyAll(); });
    menu->addAction(tr("Paste all"), this, [this, row] { pasteAll(row); });
    addMotionTo(*menu, row);
    addOtherTo(*menu, row);
    addLocksTo(*menu, row);
    menu->popup(at);
}

void ParameterPanel::openWay(std::size_t row, const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(menuText(rows_[row]->whyIdle()))->setEnabled(false);
    addWayTo(*menu, row);
    menu->popup(at);
}

void ParameterPanel::addWayTo(QMenu& menu, std::size_t row)
{
    const std::optional<RowChanges> changes = changesToAct(values(), row);
    if (!changes || changes->empty()) return;
    QStringList parts;
    for (const auto& [other, value] : *changes) {
        const ParameterInfo& info = values().rows()[other];
        parts << tr("“%1”: %2").arg(rowLabel(info), shownText(info, value));
    }
    const QString words = tr("Set %1").arg(parts.join(QStringLiteral("; ")));
    menu.addAction(menuText(words), this, [this, words, changes = *changes] {
        SceneState next = history_.sceneState();
        for (const auto& [other, value] : changes) next.values[exhibit_].setRow(other, value);
        history_.change(words, next);
    });
}

void ParameterPanel::addMotionTo(QMenu& menu, std::size_t row)
{
    const ParameterInfo& info = values().rows()[row];
    menu.addSeparator();
    const std::string_view why = whyUnmoved(info);
    QAction* animate = menu.addAction(tr("Animate…"), this, [this, row] {
        (new MotionDialog(history_, exhibit_, edits().rowsWith(row), this))->openOver(*rows_[row]);
    });
    animate->setEnabled(why.empty());
    animate->setToolTip(said(why));
    menu.setToolTipsVisible(true);
    const Motion* motion = values().motion(row);
    if (!motion) return;
    const QString name = rowLabel(info).toLower();
    const Motion next = motion->heldAt ? resumed(*motion, moment_) : held(*motion, moment_);
    const Value now = valueOf(info, *motion, moment_);
    menu.addAction(
        motion->heldAt ? tr("Move on") : tr("Hold"), this,
        [this, row, next, base = values().row(row),
         words = (motion->heldAt ? tr("Move %1 on") : tr("Hold %1")).arg(name)] { setMotion(row, words, next, base); });
    menu.addAction(tr("Stop here"), this,
                   [this, row, now, words = tr("Stop %1").arg(name)] { setMotion(row, words, std::nullopt, now); });
}

void ParameterPanel::setMotion(std::size_t row, const QString& words, const std::optional<Motion>& motion,
                               const Value& base)
{
    edits().setMotion(row, words, motion, base);
}

void ParameterPanel::addLocksTo(QMenu& menu, std::size_t row)
{
    const std::vector<std::size_t> group = rowsOf(sectionOf_[row]);
    const bool all = allLocked(group);
    menu.addSeparator();
    menu.addAction(isLocked(row) ? tr("Unlock") : tr("Lock against varying"), this,
                   [this, row] { lock({row}, !isLocked(row)); });
    menu.addAction(all ? tr("Unlock the group") : tr("Lock the group"), this,
                   [this, group, all] { lock(group, !all); });
}

void ParameterPanel::lock(const std::vector<std::size_t>& rows, bool locked)
{
    for (const std::size_t row : rows) {
        if (locked)
            locked_.insert(keyOf(row));
        else
            locked_.remove(keyOf(row));
    }
    showLocks();
    emit locksChanged();
}

void ParameterPanel::addOtherTo(QMenu& menu, std::size_t row)
{
    if (!other_ || !other_->held()) return;
    const ParameterInfo& info = values().rows()[row];
    const ParameterValues& others = other_->sceneState().values[exhibit_];
    const std::optional<std::size_t> twin = others.table().find(info.name);
    if (!twin || others.rows()[*twin].kind != info.kind) return;
    menu.addSeparator();
    const std::string name(info.name);
    QAction* take = menu.addAction(menuText(tr("Copy from B: %1").arg(shownText(info, others.row(*twin)))), this,
                                   [this, name] { other_->take(exhibit_, name); });
    QAction* give = menu.addAction(tr("Copy to B"), this, [this, name] { other_->give(exhibit_, name); });
    for (QAction* action : {take, give}) action->setEnabled(!(others.row(*twin) == values().row(row)));
}

void ParameterPanel::copy(std::size_t row) const
{
    QApplication::clipboard()->setText(exactText(values().rows()[row], values().row(row)));
}

void ParameterPanel::paste(std::size_t row)
{
    QString problem;
    const std::optional<Value> value =
        typedValue(values().rows()[row], QApplication::clipboard()->text().trimmed(), &problem);
    if (value) edits().hold(row, *value, newGesture(), tr("Paste %1").arg(rowLabel(values().rows()[row]).toLower()));
    if (!problem.isEmpty()) tell(row, problem);
}

void ParameterPanel::pasteAll(std::size_t row)
{
    QString problem;
    const std::optional<ParameterValues> pasted =
        allFromJson(values().table(), name_, QApplication::clipboard()->text(), &problem);
    if (!problem.isEmpty()) tell(row, problem);
    if (!pasted) return;
    SceneState next = history_.sceneState();
    next.values[exhibit_] = *pasted;
    history_.change(tr("Paste all values"), next, newGesture());
}

void ParameterPanel::tell(std::size_t row, const QString& words)
{
    QToolTip::showText(rows_[row]->mapToGlobal(QPoint(16, rows_[row]->height())), words, rows_[row]);
}

void ParameterPanel::copyAll() const
{
    QApplication::clipboard()->setText(allAsJson(values(), name_));
}

}  // namespace vitrine::ui
