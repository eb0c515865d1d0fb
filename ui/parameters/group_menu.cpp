// The menu of a group's heading: rows locked together, groups of one kind edited together and copied.
#include "ui/parameters/parameter_panel.h"

#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/parameters/group_edits.h"
#include "ui/parameters/parameter_section.h"

#include <QMenu>

#include <algorithm>

namespace vitrine::ui {

GroupEdits& ParameterPanel::edits()
{
    GroupEdits*& made = edits_[exhibit_];
    if (!made) {
        made = new GroupEdits(history_, exhibit_, this);
        connect(made, &GroupEdits::changed, this, &ParameterPanel::showGroups);
    }
    return *made;
}

std::vector<std::size_t> ParameterPanel::rowsOf(const ParameterSection* section) const
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < sectionOf_.size(); ++i)
        if (sectionOf_[i] == section) rows.push_back(i);
    return rows;
}

void ParameterPanel::openGroupMenu(ParameterSection* section, const QPoint& at)
{
    const std::vector<std::size_t> rows = rowsOf(section);
    if (rows.empty()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setAccessibleName(tr("Menu of %1").arg(section->title()));
    const bool locked = allLocked(rows);
    menu->addAction(locked ? tr("Unlock the group") : tr("Lock the group"), this,
                    [this, rows, locked] { lock(rows, !locked); });
    addArrayTo(*menu, values().rows()[rows.front()]);
    menu->popup(at);
}

void ParameterPanel::addArrayTo(QMenu& menu, const ParameterInfo& first)
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
        QAction* take = menu.addAction(menuText(tr("Copy from %1").arg(said(group.heading))), this,
                                       [&edit, array, from = group.element, here] { edit.copy(array, from, here); });
        take->setEnabled(!edit.alike(array, group.element, here));
    }
}

bool ParameterPanel::allLocked(const std::vector<std::size_t>& rows) const
{
    return std::all_of(rows.begin(), rows.end(), [this](std::size_t row) { return isLocked(row); });
}

void ParameterPanel::showGroups()
{
    for (ParameterSection* section : sections_) {
        const std::vector<std::size_t> rows = rowsOf(section);
        if (rows.empty()) continue;
        const std::string_view array = values().rows()[rows.front()].array;
        const bool together = !array.empty() && edits().together(array);
        section->setTogether(together ? static_cast<int>(edits().groupsOf(array).size()) : 0);
        section->setLocked(allLocked(rows));
    }
}

}  // namespace vitrine::ui
