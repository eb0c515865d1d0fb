#pragma once

#include "ui/window/search_ranking.h"

#include <QDialog>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QLineEdit;
class QTreeWidget;

namespace vitrine::ui {

/// Something that the search finds, and what Enter does with it.
struct SearchEntry {
    QString title;  ///< "Shell count".
    QString place;  ///< "Fur: Accuracy".
    QString help;   ///< Sentence about it.
    QString more;   ///< Further words by which it is found: choices, keys, the text of a page.
    QString keys = {};
    bool command = false;  ///< Commands are listed before anything is typed.
    std::function<void()> go = {};
};

/// Search over parameters, presets, commands and pages. The arrow keys choose, Enter goes there or runs the command,
/// Esc closes.
class SearchDialog final : public QDialog {
    Q_OBJECT

public:
    SearchDialog(std::vector<SearchEntry>, QWidget* window);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void find();
    void showHelp();
    void go();

    std::vector<SearchEntry> entries_;
    std::vector<SearchText> texts_;  ///< Searched text of each entry.
    QLineEdit* words_;
    QTreeWidget* list_;
    QLabel* help_;
};

}  // namespace vitrine::ui
