#include "ui/tree/kind_menu.h"

#include "ui/kit/idle_undo.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QWidgetAction>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr std::size_t fewKinds = 12;  // With fewer kinds, the menu has no search field.

QString wordsOf(const TreeKind& kind)
{
    // "cone between" also finds "cappedConeBetween".
    QString spelledOut;
    for (const char c : kind.name) {
        if (c >= 'A' && c <= 'Z') spelledOut += QLatin1Char(' ');
        spelledOut += QLatin1Char(c);
    }
    return QStringList{text(kind.name),           spelledOut,      translatedText(kind.group),
                       translatedText(kind.help), text(kind.help), QString::fromStdString(kind.words)}
        .join(QLatin1Char(' '));
}

}  // namespace

KindMenu::KindMenu(const QString& title, QWidget* parent) : QMenu(title, parent)
{
    setToolTipsVisible(true);
}

QAction* KindMenu::add(QMenu& menu, const TreeKind& kind)
{
    QAction* action = menu.addAction(text(kind.name));
    action->setToolTip(translatedText(kind.help));
    connect(action, &QAction::triggered, this, [this, name = std::string(kind.name)] { emit chosen(name); });
    return action;
}

void KindMenu::offer(const std::vector<TreeKind>& kinds)
{
    clear();
    qDeleteAll(groups_);
    groups_.clear();
    found_.clear();
    field_ = nullptr;
    words_ = nullptr;
    nothing_ = nullptr;
    if (kinds.size() <= fewKinds) {
        for (const TreeKind& kind : kinds) add(*this, kind);
        return;
    }
    addSearch(kinds);
    std::string_view group;
    for (const TreeKind& kind : kinds) {
        if (groups_.empty() || kind.group != group) {
            groups_.push_back(addMenu(translatedText(kind.group)));
            groups_.back()->setToolTipsVisible(true);
        }
        group = kind.group;
        add(*groups_.back(), kind);
    }
    search({});
}

void KindMenu::addSearch(const std::vector<TreeKind>& kinds)
{
    field_ = new QWidgetAction(this);
    auto* room = new QWidget;
    auto* layout = new QHBoxLayout(room);
    layout->setContentsMargins(8, 4, 8, 4);
    words_ = new QLineEdit(room);
    words_->setPlaceholderText(tr("Find"));
    words_->setAccessibleName(tr("Find a shape or an operation"));
    words_->setToolTip(tr("Finds shapes and operations by name and by what they do, such as “smooth union”."));
    words_->setProperty(IdleUndo::searches, true);
    words_->setClearButtonEnabled(true);
    words_->installEventFilter(this);
    layout->addWidget(words_);
    field_->setDefaultWidget(room);
    addAction(field_);
    connect(words_, &QLineEdit::textChanged, this, &KindMenu::search);
    for (const TreeKind& kind : kinds) found_.push_back({add(*this, kind), wordsOf(kind)});
    nothing_ = addAction(tr("No shape or operation matches."));
    nothing_->setEnabled(false);
}

void KindMenu::search(const QString& words)
{
    const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    bool any = false;
    for (const Found& each : found_) {
        const bool fits = !wanted.isEmpty() && std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
            return each.text.contains(word, Qt::CaseInsensitive);
        });
        each.action->setVisible(fits);
        any = any || fits;
    }
    for (const QMenu* group : groups_) group->menuAction()->setVisible(wanted.isEmpty());
    nothing_->setVisible(!wanted.isEmpty() && !any);
    setActiveAction(nullptr);
}

void KindMenu::showEvent(QShowEvent* event)
{
    QMenu::showEvent(event);
    if (words_) words_->setFocus();
}

bool KindMenu::eventFilter(QObject* object, QEvent* event)
{
    if (object != words_ || event->type() != QEvent::KeyPress) return QMenu::eventFilter(object, event);
    auto* key = static_cast<QKeyEvent*>(event);
    const bool enters = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    const bool marked = activeAction() && activeAction() != field_;
    if (key->key() == Qt::Key_Down || key->key() == Qt::Key_Up || key->key() == Qt::Key_Escape ||
        (marked && (enters || (key->key() == Qt::Key_Right && words_->text().isEmpty())))) {
        keyPressEvent(key);
        return true;
    }
    if (!enters) return QMenu::eventFilter(object, event);
    const auto first =
        std::find_if(found_.begin(), found_.end(), [](const Found& each) { return each.action->isVisible(); });
    if (first == found_.end()) return true;
    QAction* action = first->action;
    while (QWidget* popup = QApplication::activePopupWidget()) popup->close();
    action->trigger();
    return true;
}

}  // namespace vitrine::ui

#include "moc_kind_menu.cpp"
