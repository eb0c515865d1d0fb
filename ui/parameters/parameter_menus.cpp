#include "ui/parameters/parameter_menus.h"

#include "exhibits/framework/time/animation.h"
#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/model/settings_b.h"
#include "ui/parameters/controlled_parameters.h"
#include "ui/parameters/group_edits.h"
#include "ui/parameters/motion_dialog.h"
#include "ui/parameters/panel_choices.h"
#include "ui/parameters/panel_groups.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/shown_text.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QToolTip>

#include <algorithm>

namespace vitrine::ui {
namespace {

QString parameterLabel(const ParameterInfo& parameter)
{
    return translatedText(label(parameter));
}

}  // namespace

ParameterMenus::ParameterMenus(History& history, ParameterPanel& panel, PanelChoices& choices)
    : QObject(&panel), history_(history), panel_(panel), choices_(choices)
{
}

const ParameterValues& ParameterMenus::values() const
{
    return panel_.values();
}

ParameterRow& ParameterMenus::rowOf(std::size_t row) const
{
    return *panel_.row(values().rows()[row].name);
}

QMenu* ParameterMenus::newMenu()
{
    auto* menu = new QMenu(&panel_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    return menu;
}

void ParameterMenus::openRow(std::size_t row, const QPoint& at)
{
    QMenu* menu = newMenu();
    const ParameterInfo& info = values().rows()[row];
    QAction* reset =
        menu->addAction(tr("Reset to %1").arg(shownText(info, info.initial)), &rowOf(row), &ParameterRow::reset);
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
    addControllerTo(*menu, row);
    addOtherTo(*menu, row);
    addChoicesTo(*menu, row);
    menu->popup(at);
}

void ParameterMenus::openWay(std::size_t row, const QPoint& at)
{
    QMenu* menu = newMenu();
    menu->addAction(menuText(rowOf(row).whyIdle()))->setEnabled(false);
    addWayTo(*menu, row);
    menu->popup(at);
}

void ParameterMenus::addWayTo(QMenu& menu, std::size_t row)
{
    const std::optional<ParameterChanges> changes = changesToAct(values(), row);
    if (!changes || changes->empty()) return;
    menu.addAction(menuText(changesText(values(), *changes)), this, [this, changes = *changes] { make(changes); });
}

void ParameterMenus::make(const ParameterChanges& changes)
{
    SceneState next = history_.sceneState();
    for (const auto& [row, value] : changes) next.values[panel_.exhibit()].setParameter(row, value);
    history_.change(changesText(values(), changes), next);
}

void ParameterMenus::push(std::size_t row)
{
    const std::optional<ParameterChanges> changes = push_ ? push_(row) : std::nullopt;
    if (!changes) return;
    SceneState next = history_.sceneState();
    for (const auto& [changed, value] : *changes) next.values[panel_.exhibit()].setParameter(changed, value);
    history_.change(tr("Press %1").arg(midSentence(translatedText(label(values().rows()[row])))), next);
}

void ParameterMenus::addMotionTo(QMenu& menu, std::size_t row)
{
    const ParameterInfo& info = values().rows()[row];
    menu.addSeparator();
    const std::string_view why = whyUnmoved(info);
    QAction* animate = menu.addAction(tr("Animate…"), this, [this, row] {
        (new MotionDialog(history_, panel_.exhibit(), edits().parametersWith(row), &panel_))->openOver(rowOf(row));
    });
    animate->setEnabled(why.empty());
    animate->setToolTip(translatedText(why));
    menu.setToolTipsVisible(true);
    const Motion* motion = values().motion(row);
    if (!motion) return;
    const QString name = parameterLabel(info).toLower();
    const Motion next = motion->heldAt ? resumed(*motion, moment_) : held(*motion, moment_);
    const Value now = valueOf(info, *motion, moment_);
    menu.addAction(
        motion->heldAt ? tr("Resume the motion") : tr("Hold the motion"), this,
        [this, row, next, base = values().row(row),
         words = (motion->heldAt ? tr("Resume %1") : tr("Hold %1")).arg(name)] { setMotion(row, words, next, base); });
    menu.addAction(tr("Stop here"), this,
                   [this, row, now, words = tr("Stop %1").arg(name)] { setMotion(row, words, std::nullopt, now); });
}

void ParameterMenus::setMotion(std::size_t row, const QString& words, const std::optional<Motion>& motion,
                               const Value& base)
{
    edits().setMotion(row, words, motion, base);
}

void ParameterMenus::addControllerTo(QMenu& menu, std::size_t row)
{
    const QString key = panel_.keyOf(row);
    if (!controllers_ || !controllers_->mayLearn(key)) return;
    menu.addSeparator();
    const bool learning = controllers_->isLearning(key);
    menu.addAction(learning ? tr("Stop learning") : tr("Learn controller"), this,
                   [this, key, learning] { controllers_->learn(learning ? QString() : key); });
    if (controllers_->isControlled(key))
        menu.addAction(tr("Forget controller"), this, [this, key] { controllers_->forget(key); });
}

void ParameterMenus::addChoicesTo(QMenu& menu, std::size_t row)
{
    menu.addSeparator();
    if (panel_.mayPin(row))
        menu.addAction(panel_.isPinned(row) ? tr("Unpin") : tr("Pin under the essentials"), this,
                       [this, row] { togglePin(row); });
    const std::vector<std::size_t> group = panel_.groupOf(row);
    const bool all = allLocked(group);
    menu.addAction(panel_.isLocked(row) ? tr("Unlock") : tr("Exclude from randomizing"), this,
                   [this, row] { lock({row}, !panel_.isLocked(row)); });
    menu.addAction(all ? tr("Unlock the group") : tr("Lock the group"), this,
                   [this, group, all] { lock(group, !all); });
}

void ParameterMenus::togglePin(std::size_t row)
{
    if (panel_.mayPin(row)) choices_.set(PanelChoice::pinned, {panel_.keyOf(row)}, !panel_.isPinned(row));
}

bool ParameterMenus::allLocked(const std::vector<std::size_t>& rows) const
{
    return std::all_of(rows.begin(), rows.end(), [this](std::size_t row) { return panel_.isLocked(row); });
}

void ParameterMenus::lock(const std::vector<std::size_t>& rows, bool locked)
{
    QStringList keys;
    for (const std::size_t row : rows) keys << panel_.keyOf(row);
    choices_.set(PanelChoice::locked, keys, locked);
}

void ParameterMenus::addOtherTo(QMenu& menu, std::size_t row)
{
    if (!other_ || !other_->isSet()) return;
    const ParameterInfo& info = values().rows()[row];
    const ParameterValues& others = other_->sceneState().values[panel_.exhibit()];
    const std::optional<std::size_t> twin = others.table().find(info.name);
    if (!twin || others.rows()[*twin].kind != info.kind) return;
    menu.addSeparator();
    const std::string name(info.name);
    QAction* take = menu.addAction(menuText(tr("Copy from B: %1").arg(shownText(info, others.row(*twin)))), this,
                                   [this, name] { other_->take(panel_.exhibit(), name); });
    QAction* give = menu.addAction(tr("Copy to B"), this, [this, name] { other_->give(panel_.exhibit(), name); });
    for (QAction* action : {take, give}) action->setEnabled(!(others.row(*twin) == values().row(row)));
}

void ParameterMenus::copy(std::size_t row) const
{
    QApplication::clipboard()->setText(exactText(values().rows()[row], values().row(row)));
}

void ParameterMenus::paste(std::size_t row)
{
    QString problem;
    const std::optional<Value> value =
        typedValue(values().rows()[row], QApplication::clipboard()->text().trimmed(), &problem);
    if (value)
        edits().setValue(row, *value, newGesture(), tr("Paste %1").arg(parameterLabel(values().rows()[row]).toLower()));
    if (!problem.isEmpty()) showProblem(row, problem);
}

void ParameterMenus::pasteAll(std::size_t row)
{
    QString problem;
    const std::optional<ParameterValues> pasted =
        allFromJson(values().table(), panel_.name(), QApplication::clipboard()->text(), &problem);
    if (!problem.isEmpty()) showProblem(row, problem);
    if (!pasted) return;
    SceneState next = history_.sceneState();
    next.values[panel_.exhibit()] = *pasted;
    history_.change(tr("Paste all values"), next, newGesture());
}

void ParameterMenus::showProblem(std::size_t row, const QString& words)
{
    QToolTip::showText(rowOf(row).mapToGlobal(QPoint(16, rowOf(row).height())), words, &rowOf(row));
}

void ParameterMenus::copyAll() const
{
    QApplication::clipboard()->setText(allAsJson(values(), panel_.name()));
}

GroupEdits& ParameterMenus::edits()
{
    GroupEdits*& made = edits_[panel_.exhibit()];
    if (!made) {
        made = new GroupEdits(history_, panel_.exhibit(), this);
        connect(made, &GroupEdits::changed, this, &ParameterMenus::groupsChanged);
    }
    return *made;
}

void ParameterMenus::openGroup(const PanelGroup& group, const QString& title, const QPoint& at)
{
    QMenu* menu = newMenu();
    menu->setAccessibleName(tr("Menu of %1").arg(title));
    const bool locked = allLocked(group.members);
    menu->addAction(locked ? tr("Unlock the group") : tr("Lock the group"), this,
                    [this, rows = group.members, locked] { lock(rows, !locked); });
    menu->addAction(tr("Unfold all groups"), this, [this] { emit foldingAsked(false); });
    menu->addAction(tr("Fold all groups"), this, [this] { emit foldingAsked(true); });
    if (group.kind == PanelGroup::Kind::table) addArrayTo(*menu, values().rows()[group.members.front()]);
    menu->popup(at);
}

void ParameterMenus::addArrayTo(QMenu& menu, const ParameterInfo& first)
{
    GroupEdits& edit = edits();
    const std::string array(first.array);
    const std::size_t here = first.element;
    const std::vector<GroupEdits::Group> groups = edit.groupsOf(array);
    if (groups.size() < 2) return;
    menu.addSeparator();
    QAction* together = menu.addAction(tr("Edit all %n together", nullptr, static_cast<int>(groups.size())));
    together->setCheckable(true);
    together->setChecked(edit.together(array));
    connect(together, &QAction::triggered, this, [&edit, array](bool on) { edit.setTogether(array, on); });
    QAction* give =
        menu.addAction(tr("Copy to the others"), this, [&edit, array, here] { edit.copyToOthers(array, here); });
    give->setEnabled(std::any_of(groups.begin(), groups.end(), [&](const GroupEdits::Group& group) {
        return group.element != here && !edit.alike(array, here, group.element);
    }));
    for (const GroupEdits::Group& group : groups) {
        if (group.element == here) continue;
        QAction* take = menu.addAction(menuText(tr("Copy from %1").arg(translatedText(group.heading))), this,
                                       [&edit, array, from = group.element, here] { edit.copy(array, from, here); });
        take->setEnabled(!edit.alike(array, group.element, here));
    }
}

}  // namespace vitrine::ui

#include "moc_parameter_menus.cpp"
