#pragma once

#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>

class QAction;

namespace vitrine::ui {

class Preferences;

/// Shortcuts of the window's actions: the usual ones, or the visitor's own, which are stored in the preferences by
/// action id (object name). No two actions have the same shortcut: the visitor's own one wins over a usual one.
class KeyBindings final : public QObject {
    Q_OBJECT

public:
    using Keys = QList<QKeySequence>;

    /// Takes the actions with their usual shortcuts. Actions without an id keep these. The actions and the preferences
    /// must outlive this object.
    KeyBindings(const QList<QAction*>& actions, Preferences&, QObject* parent = nullptr);

    /// Returns the actions whose shortcuts can be changed, in the order of the menus.
    [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
    [[nodiscard]] Keys usual(const QAction& action) const { return usual_.value(&action); }
    /// Returns whether the action's shortcuts are the visitor's own.
    [[nodiscard]] bool differs(const QAction&) const;
    [[nodiscard]] bool anyDiffers() const;
    /// Returns another action that has one of the shortcuts; null if there is none.
    [[nodiscard]] QAction* user(const Keys&, const QAction& except) const;
    /// Gives the shortcuts to the action, and takes them from other actions.
    void set(QAction&, const Keys&);
    void resetAll();
    /// Returns a sentence why this shortcut cannot be used; empty if it can.
    [[nodiscard]] static QString refusal(const QKeySequence&);
    /// Returns the action's name without the marks of menu keys.
    [[nodiscard]] static QString nameOf(const QAction&);
    /// Formats shortcuts as the desktop names them, "Ctrl+Shift+Z, Ctrl+Y"; empty for none.
    [[nodiscard]] static QString textOf(const Keys&);

signals:
    void changed();

private:
    void apply();

    QList<QAction*> actions_;
    QHash<const QAction*, Keys> usual_;
    Preferences& preferences_;
};

}  // namespace vitrine::ui
