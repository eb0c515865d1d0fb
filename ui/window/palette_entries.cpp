#include "ui/window/palette_entries.h"

#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/presets/preset_shelf.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>

#include <functional>

namespace vitrine::ui {
namespace {

QString plainTitle(const QString& title)
{
    return QString(title).remove(QLatin1Char('&'));
}

}  // namespace

QList<QAction*> paletteEntries(MainWindow& window, const QList<QAction*>& commands, QObject& owner)
{
    QList<QAction*> all = commands;
    const auto add = [&](const QString& words, const std::function<void()>& work) {
        auto* action = new QAction(menuText(words), &owner);
        QObject::connect(action, &QAction::triggered, &window, work);
        all << action;
    };
    for (const QMenu* menu : window.menuBar()->findChildren<QMenu*>())
        for (QAction* action : menu->actions())
            if (!action->menu() && !action->isSeparator() && !commands.contains(action))
                add(QObject::tr("%1: %2").arg(plainTitle(menu->title()), plainTitle(action->text())),
                    [chosen = QPointer<QAction>(action)] {
                        if (chosen) chosen->trigger();
                    });
    for (const auto& [name, id] : window.shelf().choices())
        add(QObject::tr("Preset: %1").arg(name), [&window, preset = id] { window.shelf().load(preset); });
    for (std::size_t i = 0; i < window.museum().subjects().size(); ++i)
        for (const ParameterInfo& row : window.history().sceneState().values[i].rows()) {
            const QString name = said(label(row));
            add(QObject::tr("%1: %2").arg(said(window.museum().subject(i).title()), name), [&window, i, name] {
                window.choose(i);
                window.findParameter();
                window.panel().find(name);
            });
        }
    return all;
}

}  // namespace vitrine::ui
