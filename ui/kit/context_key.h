#pragma once

#include <QObject>

namespace vitrine::ui {

/// Context menus from the keyboard, in the whole program: Shift+F10 opens one, as the Menu key does, and in lists it
/// is that of the selected entry and not of whatever lies in the middle.
class ContextKey final : public QObject {
    Q_OBJECT

public:
    explicit ContextKey(QObject* parent);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    static bool open(QWidget&);
};

}  // namespace vitrine::ui
