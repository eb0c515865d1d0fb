#include "ui/window/theme_menu.h"

#include "ui/kit/preferences.h"

#include <QActionGroup>
#include <QMenu>

#include <array>

namespace vitrine::ui {

QMenu* themeMenu(QWidget* parent, Preferences& preferences)
{
    auto* menu = new QMenu(QMenu::tr("&Theme"), parent);
    auto* group = new QActionGroup(menu);
    const std::array<QString, 4> texts{QMenu::tr("As the &desktop"), QMenu::tr("&Light"), QMenu::tr("D&ark"),
                                       QMenu::tr("&High contrast")};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const auto choice = static_cast<ThemeChoice>(i);
        QAction* action = menu->addAction(texts[i], menu, [&preferences, choice] {
            PreferenceValues values = preferences.values();
            values.theme = choice;
            preferences.set(values);
        });
        action->setCheckable(true);
        group->addAction(action);
        const auto show = [action, &preferences, choice] { action->setChecked(preferences.values().theme == choice); };
        show();
        QObject::connect(&preferences, &Preferences::changed, action, show);
    }
    return menu;
}

}  // namespace vitrine::ui
