#pragma once

#include "ui/window/search_ranking.h"

#include <QDialog>
#include <QString>

#include <functional>
#include <vector>

class QKeySequence;
class QLabel;
class QLineEdit;
class QTreeWidget;

namespace vitrine::ui {

/// Something that the search finds, and what its keys and buttons do with it.
struct SearchEntry {
    QString title;  ///< "Shell count".
    QString place;  ///< "Fur: Accuracy".
    QString help;   ///< Sentence about it.
    QString more;   ///< Further words by which it is found: choices, keys, the text of a page.
    QString keys = {};
    bool command = false;  ///< Commands are listed before anything is typed.
    std::function<void()> go = {};
    std::function<void()> measure = {};  ///< Measures what the accuracy of a parameter costs; empty: `go` instead.
    std::function<void()> figure = {};   ///< Measures it and saves the chart; empty: `go` instead.
    int recent = 0;                      ///< 1 is the thing used last; these are listed first of all. 0: not recent.
};

/// Search over parameters, presets, commands and pages. The arrow keys choose, Enter goes there or runs the command,
/// Esc closes. Ctrl+Enter measures what the accuracy of a parameter costs, and Ctrl+Shift+Enter saves the chart, too;
/// buttons do the same.
class SearchDialog final : public QDialog {
    Q_OBJECT

public:
    SearchDialog(std::vector<SearchEntry>, QWidget* window);

protected:
    bool eventFilter(QObject*, QEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    void find();
    void showHelp();
    void go() { act(&SearchEntry::go); }
    /// Closes the search and does this with the chosen entry, or goes there if it has nothing of the kind.
    void act(std::function<void()> SearchEntry::*what);
    /// Adds a button that does this, as the keys do.
    void addButton(const QString& face, const QString& tip, const QKeySequence&,
                   std::function<void()> SearchEntry::*what);
    [[nodiscard]] const SearchEntry* current() const;

    std::vector<SearchEntry> entries_;
    std::vector<SearchText> texts_;  ///< Searched text of each entry.
    QLineEdit* words_;
    QTreeWidget* list_;
    QLabel* help_;
    QWidget* buttons_;  ///< Visible while the chosen entry can be measured.
};

}  // namespace vitrine::ui
