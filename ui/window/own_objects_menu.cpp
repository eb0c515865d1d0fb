#include "ui/window/own_objects_menu.h"

#include "ui/kit/menu_text.h"
#include "ui/model/history.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QFileInfo>
#include <QMenu>

#include <algorithm>

namespace vitrine::ui {
namespace {

/// Resets all parameters of a group, which removes its object, as one undo step.
void removeGroup(History& history, const ParameterInfo& of, const QString& words)
{
    SceneState changed = history.sceneState();
    ParameterValues& hall = changed.hall();
    for (std::size_t row = 0; row < hall.rows().size(); ++row) {
        if (hall.rows()[row].array != of.array || hall.rows()[row].element != of.element) continue;
        hall.setMotion(row, std::nullopt);
        hall.resetParameter(row);
    }
    history.change(words, changed);
}

void addObject(QMenu& menu, MainWindow& window, const ParameterInfo& info, const QString& path,
               const std::vector<OwnObjectShown>& shown)
{
    const QString name = menuText(QFileInfo(path).fileName());
    if (!menu.isEmpty()) menu.addSeparator();
    QAction* visit = menu.addAction(QMenu::tr("Visit %1").arg(name));
    visit->setToolTip(path);
    const auto here = std::find_if(shown.begin(), shown.end(),
                                   [&](const OwnObjectShown& object) { return object.which == info.element; });
    visit->setEnabled(here != shown.end());
    if (here != shown.end())
        QObject::connect(visit, &QAction::triggered, &window,
                         [&window, object = *here] { window.viewport().visitor().visit(object); });
    QAction* remove = menu.addAction(QMenu::tr("Remove %1").arg(name));
    remove->setToolTip(QMenu::tr("Removes the object from the hall; its file is kept."));
    QObject::connect(remove, &QAction::triggered, &window, [&window, info, path] {
        removeGroup(window.history(), info, QMenu::tr("Remove %1 from the hall").arg(QFileInfo(path).fileName()));
    });
}

}  // namespace

QMenu* ownObjectsMenu(MainWindow& window)
{
    auto* menu = new QMenu(QMenu::tr("&Your objects"), &window);
    menu->setToolTipsVisible(true);
    QObject::connect(menu, &QMenu::aboutToShow, menu, [menu, &window] {
        menu->clear();
        const ParameterValues& hall = window.history().sceneState().hall();
        const std::vector<OwnObjectShown> shown =
            window.museum().surroundings().ownObjects(window.viewport().scene().prepared());
        for (std::size_t row = 0; row < hall.rows().size(); ++row) {
            const ParameterInfo& info = hall.rows()[row];
            if (info.array != "objects" || info.kind != Kind::file) continue;
            const QString path = QString::fromStdString(std::get<std::string>(hall.row(row)));
            if (!path.isEmpty()) addObject(*menu, window, info, path, shown);
        }
        if (menu->isEmpty())
            menu->addAction(QMenu::tr("None yet: drop a .glb or .gltf file on the window"))->setEnabled(false);
    });
    return menu;
}

}  // namespace vitrine::ui
