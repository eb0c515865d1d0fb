#include "ui/kit/spoken_line.h"

#include <QLineEdit>

namespace vitrine::ui {

SpokenLine::SpokenLine(QLineEdit* line) : SpokenWidget(line) {}

QLineEdit& SpokenLine::line() const
{
    return *static_cast<QLineEdit*>(object());
}

QAccessible::State SpokenLine::state() const
{
    QAccessible::State now = SpokenWidget::state();
    now.editable = !line().isReadOnly();
    now.readOnly = line().isReadOnly();
    now.selectableText = true;
    return now;
}

void* SpokenLine::interface_cast(QAccessible::InterfaceType type)
{
    if (type == QAccessible::TextInterface) return static_cast<QAccessibleTextInterface*>(this);
    if (type == QAccessible::EditableTextInterface) return static_cast<QAccessibleEditableTextInterface*>(this);
    return SpokenWidget::interface_cast(type);
}

void SpokenLine::selection(int selectionIndex, int* startOffset, int* endOffset) const
{
    const bool some = selectionIndex == 0 && line().hasSelectedText();
    *startOffset = some ? line().selectionStart() : 0;
    *endOffset = some ? line().selectionEnd() : 0;
}

int SpokenLine::selectionCount() const
{
    return line().hasSelectedText() ? 1 : 0;
}

void SpokenLine::addSelection(int startOffset, int endOffset)
{
    setSelection(0, startOffset, endOffset);
}

void SpokenLine::removeSelection(int selectionIndex)
{
    if (selectionIndex == 0) line().deselect();
}

void SpokenLine::setSelection(int selectionIndex, int startOffset, int endOffset)
{
    if (selectionIndex == 0) line().setSelection(startOffset, endOffset - startOffset);
}

int SpokenLine::cursorPosition() const
{
    return line().cursorPosition();
}

void SpokenLine::setCursorPosition(int position)
{
    line().setCursorPosition(position);
}

QString SpokenLine::text(int startOffset, int endOffset) const
{
    if (startOffset > endOffset) return {};
    return line().text().mid(startOffset, endOffset - startOffset);
}

int SpokenLine::characterCount() const
{
    return static_cast<int>(line().text().size());
}

QRect SpokenLine::characterRect(int offset) const
{
    // The numbers are aligned to the right.
    const QFontMetrics metrics = line().fontMetrics();
    const QString all = line().text();
    const QRect inside = line().rect().marginsRemoved(line().textMargins());
    const int left = inside.right() + 1 - metrics.horizontalAdvance(all) + metrics.horizontalAdvance(all.left(offset));
    const QRect place(left, inside.top(), metrics.horizontalAdvance(all.mid(offset, 1)), inside.height());
    return {line().mapToGlobal(place.topLeft()), place.size()};
}

int SpokenLine::offsetAtPoint(const QPoint& point) const
{
    return line().cursorPositionAt(line().mapFromGlobal(point));
}

void SpokenLine::scrollToSubstring(int startIndex, int)
{
    line().setCursorPosition(startIndex);
}

QString SpokenLine::attributes(int, int* startOffset, int* endOffset) const
{
    *startOffset = *endOffset = 0;
    return {};
}

void SpokenLine::deleteText(int startOffset, int endOffset)
{
    replaceText(startOffset, endOffset, {});
}

void SpokenLine::insertText(int offset, const QString& text)
{
    replaceText(offset, offset, text);
}

void SpokenLine::replaceText(int startOffset, int endOffset, const QString& text)
{
    if (line().isReadOnly()) return;
    line().setText(line().text().replace(startOffset, endOffset - startOffset, text));
    line().setModified(true);
}

}  // namespace vitrine::ui
