#pragma once

#include <QObject>

namespace vitrine::ui {

/// Opens context menus by keyboard, in the whole program. Shift+F10 opens one like the Menu key. In lists it is the
/// menu of the selected entry, not of the entry in the middle.
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
