#pragma once

#include "exhibits/framework/parameters.h"
#include "ui/window/undo.h"

#include <QSet>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

class ParameterRow;
class ParameterSection;

/// The parameters of one table: everything here is derived from its rows.
class ParameterPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ParameterPanel(QWidget* parent = nullptr);

    /// Shows these values under this exhibit's name; a table other than before rebuilds the rows.
    void showValues(const ParameterValues&, const QString& exhibit);
    [[nodiscard]] const std::optional<ParameterValues>& values() const { return values_; }
    [[nodiscard]] ParameterRow* row(std::string_view name) const;
    /// Shows only rows that are wanted; an empty function wants all.
    void setWanted(const std::function<bool(const ParameterInfo&)>&);
    [[nodiscard]] QString filterText() const;
    /// Another exhibit is on show: what was searched for belonged to the one before.
    void clearFilter();
    /// Says that something outside this table matches the filter; a click asks for it. Empty: nothing does.
    void offerElsewhere(const QString& what);
    /// Connect `accuracyAsked` before showing the gauge: a mark that does nothing is no mark.
    void setGaugesShown(bool);

    /// Groups that the visitor folded, or unfolded where they are folded at first, "exhibit/group": kept with the
    /// window's layout.
    [[nodiscard]] QStringList foldedGroups() const;
    void setFoldedGroups(const QStringList&);

public slots:
    void focusFilter();

signals:
    /// The visitor changed something; edits of one gesture are one undo step. `text` names it: "Change roughness".
    void edited(const vitrine::ParameterValues& values, int gesture, const QString& text);
    /// The gauge of a quality parameter: what does its accuracy cost?
    void accuracyAsked(std::size_t row);
    /// The words of the filter changed.
    void filtered();
    void elsewhereAsked();
    /// Esc in the empty filter: the visitor is done here.
    void filterLeft();

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void rebuild();
    void showWhatActs();
    void applyFilter();
    void edit(std::size_t row, const Value&, Gesture, const QString& text);
    void focusFirst();
    void orderTabs();
    void openMenu(std::size_t row, const QPoint& at);
    void copy(std::size_t row) const;
    void paste(std::size_t row);
    void copyAll() const;
    void pasteAll(std::size_t row);
    /// Something about what was pasted, at the row where it was asked for.
    void tell(std::size_t row, const QString& words);
    [[nodiscard]] std::optional<std::size_t> rowAt(QObject*) const;

    QLineEdit* filter_;
    QToolButton* onlyChanged_;
    QToolButton* elsewhere_;
    QScrollArea* scroll_;
    QLabel* nothing_;
    QWidget* content_ = nullptr;
    std::vector<ParameterRow*> rows_;
    std::vector<ParameterSection*> sections_;
    std::vector<bool> foldedAtFirst_;  // By section.
    std::optional<ParameterValues> values_;
    QString exhibit_;
    QSet<QString> folded_;
    bool gauges_ = false;
};

}  // namespace vitrine::ui
