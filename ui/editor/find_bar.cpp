#include "ui/editor/find_bar.h"

#include "ui/kit/idle_undo.h"
#include "ui/kit/type_size.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace vitrine::ui {

FindBar::FindBar(QWidget* parent) : QWidget(parent), words_(new QLineEdit(this)), result_(new QLabel(this))
{
    words_->setPlaceholderText(tr("Find in the text"));
    words_->setAccessibleName(tr("Find in the text"));
    words_->setToolTip(tr("Enter goes to the next place, Shift+Enter to the last one, Esc back to the text."));
    words_->setProperty(IdleUndo::searches, true);
    words_->setClearButtonEnabled(true);
    words_->installEventFilter(this);
    growHeight(*words_, 26);
    result_->setAccessibleName(tr("Result of the search"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    layout->addWidget(words_, 1);
    for (const bool forward : {false, true}) {
        auto* button = new QToolButton;
        button->setText(forward ? tr("Next") : tr("Previous"));
        button->setAccessibleName(forward ? tr("Next place") : tr("Previous place"));
        button->setFocusPolicy(Qt::StrongFocus);
        growHeight(*button, 26);
        layout->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, forward] { emit asked(words_->text(), forward); });
    }
    layout->addWidget(result_);
    connect(words_, &QLineEdit::textEdited, this, [this] { setFound(true); });
    hide();
}

void FindBar::open(const QString& words)
{
    if (!words.isEmpty()) words_->setText(words);
    setFound(true);
    show();
    words_->setFocus(Qt::ShortcutFocusReason);
    words_->selectAll();
}

void FindBar::setFound(bool found)
{
    result_->setText(found ? QString() : tr("Not found"));
}

void FindBar::close()
{
    hide();
    emit closed();
}

bool FindBar::eventFilter(QObject* object, QEvent* event)
{
    if (object != words_ || event->type() != QEvent::KeyPress) return QWidget::eventFilter(object, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    switch (key.key()) {
    case Qt::Key_Escape: close(); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: emit asked(words_->text(), !(key.modifiers() & Qt::ShiftModifier)); return true;
    default: return false;
    }
}

}  // namespace vitrine::ui

#include "moc_find_bar.cpp"
