#include "ui/parameters/make_editor.h"

#include "ui/parameters/color_editor.h"
#include "ui/parameters/direction_editor.h"
#include "ui/parameters/number_editor.h"
#include "ui/parameters/pick_editors.h"

namespace vitrine::ui {

ValueEditor* makeEditor(const ValueRef& value, QWidget* parent)
{
    switch (value.info().kind) {
    case Kind::real:
    case Kind::count: return new NumberEditor(value, parent);
    case Kind::toggle: return new ToggleEditor(value, parent);
    case Kind::choice: return new ChoiceEditor(value, parent);
    case Kind::color: return new ColorEditor(value, parent);
    case Kind::direction: return new DirectionEditor(value, parent);
    case Kind::file: return new FileEditor(value, parent);
    case Kind::text:
        if (value.info().addsParameters) return new TextMark(value, parent);
        return new TextEditor(value, parent);
    }
    return nullptr;
}

}  // namespace vitrine::ui
