#include "ui/kit/appearance.h"

#include "ui/kit/flat_style.h"

#include <QApplication>
#include <QFont>
#include <QWidget>

#include <array>

namespace vitrine::ui {
namespace {

bool& motionIsReduced()
{
    static bool reduced = false;
    return reduced;
}

QFont sized(const QFont& plain, int percent)
{
    QFont font = plain;
    if (plain.pointSizeF() > 0)
        font.setPointSizeF(plain.pointSizeF() * percent / 100);
    else
        font.setPixelSize(plain.pixelSize() * percent / 100);
    return font;
}

void applyTypeSize(int percent)
{
    static const QFont plain = QApplication::font();
    static int applied = PreferenceValues::typeSizes.initial;
    if (percent == applied) return;
    applied = percent;
    QApplication::setFont(sized(plain, percent));
}

void applyMotion(bool reduced)
{
    if (reduced == motionIsReduced()) return;
    motionIsReduced() = reduced;
    constexpr std::array effects{Qt::UI_AnimateMenu,    Qt::UI_FadeMenu,    Qt::UI_AnimateCombo,
                                 Qt::UI_AnimateTooltip, Qt::UI_FadeTooltip, Qt::UI_AnimateToolBox};
    static std::array<bool, effects.size()> before{};
    for (std::size_t i = 0; i < effects.size(); ++i) {
        if (reduced) before[i] = QApplication::isEffectEnabled(effects[i]);
        QApplication::setEffectEnabled(effects[i], !reduced && before[i]);
    }
}

}  // namespace

Theme themeFor(const PreferenceValues& values, const DesktopPreferences& desktopPreferences, bool desktopIsDark)
{
    const bool dark = desktopPreferences.dark.value_or(desktopIsDark);
    switch (values.theme) {
    case ThemeChoice::light: return lightTheme();
    case ThemeChoice::dark: return darkTheme();
    case ThemeChoice::highContrast: return highContrastTheme(dark);
    case ThemeChoice::desktop: break;
    }
    if (desktopPreferences.highContrast) return highContrastTheme(dark);
    return dark ? darkTheme() : lightTheme();
}

bool reducesMotion(const PreferenceValues& values, const DesktopPreferences& desktopPreferences)
{
    return values.motion == MotionChoice::reduced ||
           (values.motion == MotionChoice::desktop && desktopPreferences.reducedMotion);
}

bool reducedMotion()
{
    return motionIsReduced();
}

void applyAppearance(QApplication& app, const PreferenceValues& values, const DesktopPreferences& desktopPreferences)
{
    static const bool desktopIsDark = desktopPrefersDark(app);
    applyMotion(reducesMotion(values, desktopPreferences));
    const Theme wanted = themeFor(values, desktopPreferences, desktopIsDark);
    if (!(wanted == theme()) || !qobject_cast<FlatStyle*>(QApplication::style())) {
        applyTheme(app, wanted);
        for (QWidget* widget : QApplication::allWidgets())
            widget->update();  // Widgets that paint themselves use the theme's colors.
    }
    applyTypeSize(values.typeSize);
}

Appearance::Appearance(const Preferences& preferences, const DesktopPortal& portal, QObject* parent)
    : QObject(parent), preferences_(preferences), portal_(portal)
{
    connect(&preferences, &Preferences::changed, this, &Appearance::apply);
    connect(&portal, &DesktopPortal::changed, this, &Appearance::apply);
}

void Appearance::apply()
{
    applyAppearance(*qApp, preferences_.values(), portal_.desktopPreferences());
    emit applied();
}

}  // namespace vitrine::ui

#include "moc_appearance.cpp"
