#include "ui/editor/code_colors.h"

#include <QFontDatabase>
#include <QWidget>

namespace vitrine::ui {
namespace {

QColor mixed(const QColor& a, const QColor& b, double share)
{
    return QColor::fromRgbF(static_cast<float>(a.redF() + (b.redF() - a.redF()) * share),
                            static_cast<float>(a.greenF() + (b.greenF() - a.greenF()) * share),
                            static_cast<float>(a.blueF() + (b.blueF() - a.blueF()) * share));
}

}  // namespace

CodeColors codeColors(const Theme& theme)
{
    CodeColors colors;
    colors.background = theme.base;
    colors.text = theme.text;
    colors.margin = theme.window;
    colors.marginText = theme.dim;
    colors.currentLine = mixed(theme.base, theme.text, theme.highContrast ? 0.08 : 0.03);
    colors.selection = theme.accent;
    colors.selectionText = theme.dark ? theme.window : QColor(Qt::white);
    colors.keyword = theme.accent;
    colors.comment = theme.dim;
    colors.number = theme.good;
    colors.directive = theme.dark ? QColor(0xc9a0c8) : QColor(0x74386f);
    colors.type = theme.dark ? QColor(0x8fb6cf) : QColor(0x235d80);
    if (theme.highContrast) {
        colors.directive = theme.dark ? QColor(0xf0c2ee) : QColor(0x561a51);
        colors.type = theme.dark ? QColor(0xa9dcf8) : QColor(0x003f63);
    }
    colors.function = mixed(colors.type, theme.text, 0.5);
    colors.error = theme.error;
    colors.remark = theme.dim;
    return colors;
}

QFont codeFont(const QWidget& widget)
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSizeF(QFontInfo(widget.font()).pointSizeF());
    return font;
}

}  // namespace vitrine::ui
