#include "ui/preferences/key_bindings.h"

#include "ui/kit/preferences.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

QStringList portable(const KeyBindings::Keys& keys)
{
    QStringList texts;
    for (const QKeySequence& key : keys) texts << key.toString(QKeySequence::PortableText);
    return texts;
}

KeyBindings::Keys fromPortable(const QStringList& texts)
{
    KeyBindings::Keys keys;
    for (const QString& text : texts) keys << QKeySequence::fromString(text, QKeySequence::PortableText);
    return keys;
}

KeyBindings::Keys without(KeyBindings::Keys keys, const KeyBindings::Keys& taken)
{
    for (const QKeySequence& key : taken) keys.removeAll(key);
    return keys;
}

}  // namespace

KeyBindings::KeyBindings(const QList<QAction*>& actions, Preferences& preferences, QObject* parent)
    : QObject(parent), preferences_(preferences)
{
    for (QAction* action : actions) {
        if (action->objectName().isEmpty()) continue;
        actions_ << action;
        usual_.insert(action, action->shortcuts());
    }
    connect(&preferences_, &Preferences::changed, this, [this](const PreferenceValues& before) {
        if (before.keys != preferences_.values().keys) apply();
    });
    if (!preferences_.values().keys.isEmpty()) apply();
}

void KeyBindings::apply()
{
    const QMap<QString, QStringList>& own = preferences_.values().keys;
    Keys taken;
    QHash<const QAction*, Keys> given;
    for (const bool ofVisitor : {true, false})
        for (const QAction* action : std::as_const(actions_)) {
            if (own.contains(action->objectName()) != ofVisitor) continue;
            const Keys wanted = ofVisitor ? fromPortable(own.value(action->objectName())) : usual(*action);
            const Keys keys = without(wanted, taken);
            given.insert(action, keys);
            taken << keys;
        }
    for (QAction* action : std::as_const(actions_)) action->setShortcuts(given.value(action));
    emit changed();
}

bool KeyBindings::differs(const QAction& action) const
{
    return action.shortcuts() != usual(action);
}

bool KeyBindings::anyDiffers() const
{
    return std::any_of(actions_.begin(), actions_.end(), [this](const QAction* action) { return differs(*action); });
}

QAction* KeyBindings::user(const Keys& keys, const QAction& except) const
{
    for (QAction* action : actions_)
        if (action != &except)
            for (const QKeySequence& key : keys)
                if (action->shortcuts().contains(key)) return action;
    return nullptr;
}

void KeyBindings::set(QAction& action, const Keys& keys)
{
    PreferenceValues values = preferences_.values();
    const auto keep = [&](const QAction& of, const Keys& now) {
        if (now == usual(of))
            values.keys.remove(of.objectName());
        else
            values.keys.insert(of.objectName(), portable(now));
    };
    for (const QAction* other : std::as_const(actions_))
        if (other != &action && user(keys, action))
            if (const Keys left = without(other->shortcuts(), keys); left != other->shortcuts()) keep(*other, left);
    keep(action, keys);
    preferences_.set(values);
}

void KeyBindings::resetAll()
{
    PreferenceValues values = preferences_.values();
    values.keys.clear();
    preferences_.set(values);
}

QString KeyBindings::refusal(const QKeySequence& keys)
{
    if (keys.isEmpty()) return {};
    const QKeyCombination key = keys[0];
    const bool plain = !(key.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
    const bool function = (key.key() >= Qt::Key_F1 && key.key() <= Qt::Key_F35) || key.key() == Qt::Key_Pause;
    if (plain && !function)
        return tr("%1 alone is used for typing and walking. Add Ctrl or Alt, or use a function key.")
            .arg(keys.toString(QKeySequence::NativeText));
    if (keys.count() > 1) return tr("A shortcut has only one key combination.");
    return {};
}

QString KeyBindings::nameOf(const QAction& action)
{
    QString name = action.text();
    name.replace(QStringLiteral("&&"), QStringLiteral("\1"));
    return name.remove(QLatin1Char('&')).remove(QStringLiteral("…")).replace(QLatin1Char('\1'), QLatin1Char('&'));
}

QString KeyBindings::textOf(const Keys& keys)
{
    QStringList texts;
    for (const QKeySequence& key : keys) texts << key.toString(QKeySequence::NativeText);
    return texts.join(QStringLiteral(", "));
}

}  // namespace vitrine::ui

#include "moc_key_bindings.cpp"
