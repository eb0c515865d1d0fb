#include "ui/parameters/value_editor.h"

#include "ui/parameters/color_editor.h"
#include "ui/parameters/direction_editor.h"
#include "ui/parameters/number_editor.h"
#include "ui/parameters/pick_editors.h"

namespace vitrine::ui {

ValueEditor* makeEditor(const ParameterInfo& row, QWidget* parent)
{
    switch (row.kind) {
    case Kind::real:
    case Kind::count: return new NumberEditor(row, parent);
    case Kind::toggle: return new ToggleEditor(row, parent);
    case Kind::choice: return new ChoiceEditor(row, parent);
    case Kind::color: return new ColorEditor(row, parent);
    case Kind::direction: return new DirectionEditor(row, parent);
    case Kind::file: return new FileEditor(row, parent);
    }
    return nullptr;
}

}  // namespace vitrine::ui

#include "moc_value_editor.cpp"
