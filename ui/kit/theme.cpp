#include "ui/kit/theme.h"

#include "render/image/srgb.h"
#include "ui/kit/flat_style.h"

#include <QApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

Theme& current()
{
    static Theme active = darkTheme();
    return active;
}

/// Returns the relative luminance of an sRGB color; white has 1.
double luminance(const QColor& color)
{
    using render::linearFromSrgb;
    const QColor rgb = color.toRgb();
    return 0.2126 * linearFromSrgb(rgb.redF()) + 0.7152 * linearFromSrgb(rgb.greenF()) +
           0.0722 * linearFromSrgb(rgb.blueF());
}

}  // namespace

Theme darkTheme()
{
    return {true, "#1f1f1e", "#272726", "#d8d4cc", "#9a958c", "#d9a05b", "#d9735b", "#8fae7a", "#74706a"};
}

Theme lightTheme()
{
    return {false, "#f1efeb", "#fbfaf8", "#2a2825", "#6d685f", "#9a5f14", "#a83a22", "#4a6b33", "#8f897e"};
}

Theme highContrastTheme(bool dark)
{
    if (dark)
        return {true, "#000000", "#0d0d0c", "#ffffff", "#dcd8d0", "#ffc266", "#ffab98", "#b9e095", "#bdb8b0", true};
    return {false, "#ffffff", "#ffffff", "#000000", "#3a3733", "#6b3d00", "#8a1500", "#234a0c", "#57534d", true};
}

Theme paperTheme()
{
    Theme theme = lightTheme();
    theme.window = theme.base = Qt::white;
    return theme;
}

double contrastOf(const QColor& a, const QColor& b)
{
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

const Theme& theme()
{
    return current();
}

ThemeScope::ThemeScope(const Theme& theme) : before_(current())
{
    current() = theme;
}

ThemeScope::~ThemeScope()
{
    current() = before_;
}

bool desktopPrefersDark(const QApplication& app)
{
    const QPalette palette = app.palette();
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

void applyTheme(QApplication& app, const Theme& chosen)
{
    current() = chosen;
    app.setStyle(new FlatStyle);
    QPalette palette;
    palette.setColor(QPalette::Window, chosen.window);
    palette.setColor(QPalette::Base, chosen.base);
    palette.setColor(QPalette::AlternateBase, chosen.window);
    palette.setColor(QPalette::Button, chosen.dark ? chosen.base.lighter(115) : chosen.base);
    palette.setColor(QPalette::ToolTipBase, chosen.base);
    for (const auto role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText})
        palette.setColor(role, chosen.text);
    palette.setColor(QPalette::PlaceholderText, chosen.dim);
    palette.setColor(QPalette::Highlight, chosen.accent);
    palette.setColor(QPalette::HighlightedText, chosen.dark ? chosen.window : QColor(Qt::white));
    palette.setColor(QPalette::Link, chosen.accent);
    for (const auto role : {QPalette::WindowText, QPalette::Text})
        palette.setColor(QPalette::Disabled, role, chosen.dim);
    QColor off = chosen.text;  // A disabled button must not look like an enabled one.
    off.setAlphaF(chosen.highContrast ? 0.6F : 0.35F);
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, off);
    app.setPalette(palette);
}

}  // namespace vitrine::ui
