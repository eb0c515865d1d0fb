#pragma once

#include <QHash>
#include <QKeySequence>
#include <QList>
#include <QObject>

class QAction;

namespace vitrine::ui {

class Preferences;

/// The shortcuts of the window's actions: the usual ones, or the visitor's own, kept in the preferences by the actions'
/// ids (their object names). No two actions ever have the same one: the visitor's own goes before a usual one.
class KeyBindings final : public QObject {
    Q_OBJECT

public:
    using Keys = QList<QKeySequence>;

    /// Actions with their usual shortcuts; those without an id keep them. Both must outlive it.
    KeyBindings(const QList<QAction*>& actions, Preferences&, QObject* parent = nullptr);

    /// Those that can get others, in the order of the menus.
    [[nodiscard]] const QList<QAction*>& actions() const { return actions_; }
    [[nodiscard]] Keys usual(const QAction& action) const { return usual_.value(&action); }
    /// Its shortcuts are the visitor's own.
    [[nodiscard]] bool differs(const QAction&) const;
    [[nodiscard]] bool anyDiffers() const;
    /// Who else has one of them; null when nobody has.
    [[nodiscard]] QAction* user(const Keys&, const QAction& except) const;
    /// Gives them to it, and takes them from whoever has them.
    void set(QAction&, const Keys&);
    void resetAll();
    /// Why no action can have this one, a sentence; empty when one can.
    [[nodiscard]] static QString refusal(const QKeySequence&);
    /// Its name without the marks of a menu.
    [[nodiscard]] static QString nameOf(const QAction&);
    /// In the desktop's own words, "Ctrl+Shift+Z, Ctrl+Y"; empty for none.
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
