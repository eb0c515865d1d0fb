#include "ui/kit/accessible_line.h"

#include <QLineEdit>

namespace vitrine::ui {

AccessibleLine::AccessibleLine(QLineEdit* line) : AccessibleWidget(line) {}

QLineEdit& AccessibleLine::line() const
{
    return *static_cast<QLineEdit*>(object());
}

QAccessible::State AccessibleLine::state() const
{
    QAccessible::State now = AccessibleWidget::state();
    now.editable = !line().isReadOnly();
    now.readOnly = line().isReadOnly();
    now.selectableText = true;
    return now;
}

void* AccessibleLine::interface_cast(QAccessible::InterfaceType type)
{
    if (type == QAccessible::TextInterface) return static_cast<QAccessibleTextInterface*>(this);
    if (type == QAccessible::EditableTextInterface) return static_cast<QAccessibleEditableTextInterface*>(this);
    return AccessibleWidget::interface_cast(type);
}

void AccessibleLine::selection(int selectionIndex, int* startOffset, int* endOffset) const
{
    const bool some = selectionIndex == 0 && line().hasSelectedText();
    *startOffset = some ? line().selectionStart() : 0;
    *endOffset = some ? line().selectionEnd() : 0;
}

int AccessibleLine::selectionCount() const
{
    return line().hasSelectedText() ? 1 : 0;
}

void AccessibleLine::addSelection(int startOffset, int endOffset)
{
    setSelection(0, startOffset, endOffset);
}

void AccessibleLine::removeSelection(int selectionIndex)
{
    if (selectionIndex == 0) line().deselect();
}

void AccessibleLine::setSelection(int selectionIndex, int startOffset, int endOffset)
{
    if (selectionIndex == 0) line().setSelection(startOffset, endOffset - startOffset);
}

int AccessibleLine::cursorPosition() const
{
    return line().cursorPosition();
}

void AccessibleLine::setCursorPosition(int position)
{
    line().setCursorPosition(position);
}

QString AccessibleLine::text(int startOffset, int endOffset) const
{
    if (startOffset > endOffset) return {};
    return line().text().mid(startOffset, endOffset - startOffset);
}

int AccessibleLine::characterCount() const
{
    return static_cast<int>(line().text().size());
}

QRect AccessibleLine::characterRect(int offset) const
{
    // The numbers are aligned to the right.
    const QFontMetrics metrics = line().fontMetrics();
    const QString all = line().text();
    const QRect inside = line().rect().marginsRemoved(line().textMargins());
    const int left = inside.right() + 1 - metrics.horizontalAdvance(all) + metrics.horizontalAdvance(all.left(offset));
    const QRect place(left, inside.top(), metrics.horizontalAdvance(all.mid(offset, 1)), inside.height());
    return {line().mapToGlobal(place.topLeft()), place.size()};
}

int AccessibleLine::offsetAtPoint(const QPoint& point) const
{
    return line().cursorPositionAt(line().mapFromGlobal(point));
}

void AccessibleLine::scrollToSubstring(int startIndex, int)
{
    line().setCursorPosition(startIndex);
}

QString AccessibleLine::attributes(int, int* startOffset, int* endOffset) const
{
    *startOffset = *endOffset = 0;
    return {};
}

void AccessibleLine::deleteText(int startOffset, int endOffset)
{
    replaceText(startOffset, endOffset, {});
}

void AccessibleLine::insertText(int offset, const QString& text)
{
    replaceText(offset, offset, text);
}

void AccessibleLine::replaceText(int startOffset, int endOffset, const QString& text)
{
    if (line().isReadOnly()) return;
    line().setText(line().text().replace(startOffset, endOffset - startOffset, text));
    line().setModified(true);
}

}  // namespace vitrine::ui
