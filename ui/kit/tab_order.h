#pragma once

#include <QObject>

class QWidget;

namespace vitrine::ui {

/// Has the Tab key go through what is laid out in this widget as one reads it: layouts item by item, grids row by row.
void tabAsLaidOut(QWidget& root);

/// Does that for every dialog of the program when it is shown, but for those of Qt; one that has put the focus nowhere
/// gets it at its first stop.
class TabOrder final : public QObject {
    Q_OBJECT

public:
    explicit TabOrder(QObject* parent);

protected:
    bool eventFilter(QObject*, QEvent*) override;
};

}  // namespace vitrine::ui
