#include "ui/parameters/value_editor.h"

namespace vitrine::ui {

void ValueEditor::edit(const Value& value, Gesture gesture)
{
    value_.set(value, gesture);
    if (value_.value() != value) showValue(value_.value());  // The value was corrected to a legal one.
}

}  // namespace vitrine::ui

#include "moc_value_editor.cpp"
