#pragma once

#include "exhibits/framework/scene/tree.h"

#include <QMenu>

#include <string>
#include <vector>

class QLineEdit;
class QWidgetAction;

namespace vitrine::ui {

/// Menu of kinds of nodes. A long list has a search field at the top and one submenu per group.
class KindMenu final : public QMenu {
    Q_OBJECT

public:
    KindMenu(const QString& title, QWidget* parent);

    /// Replaces the kinds on offer. Kinds of one group must be adjacent.
    void offer(const std::vector<TreeKind>&);

signals:
    void chosen(const std::string& kind);

protected:
    void showEvent(QShowEvent*) override;
    bool eventFilter(QObject*, QEvent*) override;

private:
    /// Entry of the flat list, which is shown while words are typed.
    struct Found {
        QAction* action;
        QString text;  ///< Name, group, help and further words, in both languages.
    };
    QAction* add(QMenu&, const TreeKind&);
    void addSearch(const std::vector<TreeKind>&);
    void search(const QString& words);

    QWidgetAction* field_ = nullptr;
    QLineEdit* words_ = nullptr;
    QAction* nothing_ = nullptr;
    std::vector<Found> found_;
    std::vector<QMenu*> groups_;
};

}  // namespace vitrine::ui
