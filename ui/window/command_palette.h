#pragma once

#include <QDialog>
#include <QList>

class QAction;
class QLineEdit;
class QListWidget;

namespace vitrine::ui {

/// Command palette: finds every command of the window by a few letters of its name; Enter runs it.
class CommandPalette final : public QDialog {
    Q_OBJECT

public:
    CommandPalette(const QList<QAction*>& actions, QWidget* window);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void fill();
    void run();

    QList<QAction*> actions_;
    QLineEdit* words_;
    QListWidget* list_;
};

/// Sheet with all shortcuts on one page.
class ShortcutSheet final : public QDialog {
    Q_OBJECT

public:
    ShortcutSheet(const QList<QAction*>& actions, QWidget* window);
};

}  // namespace vitrine::ui
