#pragma once

#include "ui/preferences/key_bindings.h"

#include <QWidget>

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace vitrine::ui {

/// All commands with their shortcuts: found by words, given another one, reset. A shortcut that somebody else has is
/// taken only when the visitor says so.
class KeysPage final : public QWidget {
    Q_OBJECT

public:
    /// They must outlive it.
    explicit KeysPage(KeyBindings&, QWidget* parent = nullptr);

private:
    void build();
    void fill();
    void filter();
    void showChosen();
    [[nodiscard]] QAction* chosen() const;
    void typed();
    /// Gives these to the chosen command, or asks first, when another one has one of them.
    void give(const KeyBindings::Keys&);
    void say(const QString& words, bool asks);

    KeyBindings& keys_;
    QLineEdit* words_;
    QTreeWidget* list_;
    QLabel* name_;
    QKeySequenceEdit* edit_;
    QPushButton* none_;
    QPushButton* reset_;
    QPushButton* resetAll_;
    QLabel* message_;
    QPushButton* take_;
    QPushButton* leave_;
    KeyBindings::Keys asked_;  // Would be taken from somebody.
};

}  // namespace vitrine::ui
