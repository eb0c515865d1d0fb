#include "ui/window/theme_choice.h"

#include "exhibits/framework/state_folder.h"
#include "ui/kit/theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QMenu>
#include <QSettings>
#include <QWidget>

#include <array>

namespace vitrine::ui {
namespace {

constexpr std::array<const char*, 3> names{"desktop", "light", "dark"};

QSettings themeSettings()
{
    return QSettings(QString::fromStdString((configFolder() / "window.ini").string()), QSettings::IniFormat);
}

QString themeKey()
{
    return QStringLiteral("theme");
}

}  // namespace

ThemeChoice savedThemeChoice()
{
    const QString saved = themeSettings().value(themeKey()).toString();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (saved == QLatin1String(names[i])) return static_cast<ThemeChoice>(i);
    return ThemeChoice::desktop;
}

void chooseTheme(QApplication& app, ThemeChoice choice)
{
    static const bool desktopIsDark = desktopPrefersDark(app);
    const bool dark = choice == ThemeChoice::dark || (choice == ThemeChoice::desktop && desktopIsDark);
    applyTheme(app, dark ? darkTheme() : lightTheme());
    for (QWidget* widget : QApplication::allWidgets())
        widget->update();  // What paints itself asks for the theme's colors.
    QSettings kept = themeSettings();
    kept.setValue(themeKey(), QLatin1String(names[static_cast<std::size_t>(choice)]));
}

QMenu* themeMenu(QWidget* parent)
{
    auto* menu = new QMenu(QMenu::tr("&Theme"), parent);
    auto* group = new QActionGroup(menu);
    const std::array<QString, 3> texts{QMenu::tr("As the &desktop"), QMenu::tr("&Light"), QMenu::tr("D&ark")};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const auto choice = static_cast<ThemeChoice>(i);
        QAction* action = menu->addAction(texts[i], menu, [choice] { chooseTheme(*qApp, choice); });
        action->setCheckable(true);
        action->setChecked(choice == savedThemeChoice());
        group->addAction(action);
    }
    return menu;
}

}  // namespace vitrine::ui
