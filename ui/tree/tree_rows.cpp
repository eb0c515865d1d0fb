#include "ui/tree/tree_rows.h"

#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/parameter_section.h"
#include "ui/tree/tree_editor.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

namespace vitrine::ui {

TreeRowsView::TreeRowsView(TreeEditor& editor, QWidget* parent)
    : QWidget(parent), editor_(editor), scroll_(new QScrollArea(this)), note_(new QLabel(this))
{
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    note_->setMargin(12);
    note_->setEnabled(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(note_);
    layout->addWidget(scroll_, 1);
    connect(&editor_, &TreeEditor::selectionChanged, this, &TreeRowsView::refresh);
    connect(&editor_, &TreeEditor::valuesChanged, this, &TreeRowsView::refresh);
    refresh();
}

ParameterRow* TreeRowsView::row(std::string_view name) const
{
    const auto found = values_ ? values_->table().find(name) : std::nullopt;
    return found ? rows_[*found] : nullptr;
}

void TreeRowsView::setValue(std::size_t row, const Value& value, Gesture gesture, const QString& text)
{
    const ParameterInfo& info = values_->rows()[row];
    const std::optional<Value> legal = nearestLegal(info, value);
    if (!legal || *legal == values_->row(row)) return;
    const QString name = midSentence(translatedText(label(info)));
    editor_.setParameter(
        row, *legal, gesture,
        tr("%1 of %2").arg(text.isEmpty() ? tr("Change %1").arg(name) : text, editor_.selectedTitle()));
}

void TreeRowsView::refresh()
{
    std::optional<TreeParameters> now;
    if (editor_.source() && !editor_.selected().empty())
        now = editor_.source()->parametersOf(editor_.values(), editor_.selected());
    const bool same = now && values_ && now->values.table().hasParametersOf(values_->table());
    if (!same) {
        values_.reset();
        if (now) values_ = now->values;
        rebuild();
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        values_->setParameter(i, now->values.row(i));
        rows_[i]->showValue(values_->row(i));
    }
    for (ParameterSection* section : sections_) section->refresh();
    note_->setText(now                ? translatedText(now->note)
                   : editor_.source() ? tr("Click a shape in the picture, or a node above.")
                                      : QString());
    note_->setVisible(!note_->text().isEmpty());
}

void TreeRowsView::rebuild()
{
    rows_.clear();
    sections_.clear();
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 4, 8);
    layout->setSpacing(0);
    for (std::size_t i = 0; values_ && i < values_->rows().size(); ++i) {
        const ParameterInfo& info = values_->rows()[i];
        if (i == 0 || info.group != values_->rows()[i - 1].group) {
            sections_.push_back(new ParameterSection(translatedText(info.group), content));
            layout->addWidget(sections_.back());
        }
        rows_.push_back(new ParameterRow(ValueRef(*this, i), sections_.back()));
        sections_.back()->add(rows_.back());
        rows_.back()->installEventFilter(this);
        for (QWidget* child : rows_.back()->findChildren<QWidget*>()) child->installEventFilter(this);
    }
    layout->addStretch(1);
    // The caller may be one of the removed controls, so they are deleted later.
    if (QWidget* before = scroll_->takeWidget()) before->deleteLater();
    scroll_->setWidget(content);
    for (ParameterSection* section : sections_) static_cast<void>(section->showOnlyChanged(false));
}

bool TreeRowsView::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::Wheel && !qobject_cast<QWidget*>(object)->hasFocus()) {
        event->ignore();  // The wheel scrolls and does not change values.
        return true;
    }
    return QWidget::eventFilter(object, event);
}

}  // namespace vitrine::ui

#include "moc_tree_rows.cpp"
