#include "ui/parameters/number_editor.h"

#include "ui/kit/language.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/value_slider.h"

#include <QHBoxLayout>

#include <algorithm>

namespace vitrine::ui {

NumberEditor::NumberEditor(const ValueRef& value, QWidget* parent)
    : ValueEditor(value, parent), slider_(new ValueSlider(row(), this)), field_(new NumberField(row(), this))
{
    const QString name = translatedText(label(row()));
    slider_->setAccessibleName(tr("%1, slider").arg(name));
    field_->setAccessibleName(name);
    followType(*field_, [this] {
        int width = grown(NumberField::usualWidth, *field_);
        for (const Word& word : row().words)  // "automatisch" is wider than a number.
            width = std::max(width,
                             field_->fontMetrics().horizontalAdvance(translatedText(word.text)) + grown(16, *field_));
        field_->setFixedWidth(width);
    });

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(slider_, 1);
    layout->addWidget(field_);

    connect(slider_, &ValueSlider::edited, this, &NumberEditor::edit);
    connect(field_, &NumberField::edited, this, &NumberEditor::edit);
}

void NumberEditor::showValue(const Value& value)
{
    slider_->showValue(std::get<double>(value));
    field_->showValue(std::get<double>(value));
}

void NumberEditor::labelPressed(double x)
{
    field_->setFocus(Qt::MouseFocusReason);  // The field then receives Esc.
    field_->dragFrom(x);
}

void NumberEditor::labelMoved(double x, Qt::KeyboardModifiers modifiers)
{
    field_->dragTo(x, modifiers);
}

void NumberEditor::labelReleased()
{
    field_->dragEnd();
}

}  // namespace vitrine::ui

#include "moc_number_editor.cpp"
