#pragma once

#include <QObject>

class QWidget;

namespace vitrine::ui {

/// Sets the Tab order of a widget's content to the reading order: layouts item by item, grids row by row.
void tabAsLaidOut(QWidget& root);

/// Does the same for all dialogs of the program, except Qt's own, when they are shown. Focuses the first widget if none
/// has the focus.
class TabOrder final : public QObject {
    Q_OBJECT

public:
    explicit TabOrder(QObject* parent);

protected:
    bool eventFilter(QObject*, QEvent*) override;
};

}  // namespace vitrine::ui
