#include "ui/kit/theme.h"

#include "ui/kit/quiet_style.h"

#include <QApplication>
#include <QPalette>

namespace vitrine::ui {
namespace {

Theme& current()
{
    static Theme active = darkTheme();
    return active;
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

const Theme& theme()
{
    return current();
}

bool desktopPrefersDark(const QApplication& app)
{
    const QPalette palette = app.palette();
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

void applyTheme(QApplication& app, const Theme& chosen)
{
    current() = chosen;
    app.setStyle(new QuietStyle);
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
    QColor off = chosen.text;  // A button that cannot be pressed must not read like one that can.
    off.setAlphaF(0.35F);
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, off);
    app.setPalette(palette);
}

}  // namespace vitrine::ui
