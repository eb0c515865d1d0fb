#pragma once

#include "ui/model/history.h"

#include <QSet>
#include <QWidget>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QMenu;
class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace vitrine::ui {

class GroupEdits;
class OtherSettings;
class ParameterRow;
class ParameterSection;

/// The values of one exhibit in the history: everything here is derived from the rows of its table. Controls set values
/// in the history; when one changes, its row is shown anew and no other.
class ParameterPanel final : public QWidget {
    Q_OBJECT

public:
    /// The history must outlive it.
    explicit ParameterPanel(History&, QWidget* parent = nullptr);

    /// Shows the values of this exhibit from now on. `name`: under which it keeps what is folded, and copies and
    /// pastes.
    void showExhibit(std::size_t exhibit, const QString& name);
    /// Whose values are shown.
    [[nodiscard]] std::size_t exhibit() const { return exhibit_; }
    [[nodiscard]] const ParameterValues& values() const { return history_.sceneState().values[exhibit_]; }
    [[nodiscard]] ParameterRow* row(std::string_view name) const;
    /// Values that text parameters may be chosen from, by the parameter's name.
    void setOffers(const std::map<std::string, std::vector<std::string>, std::less<>>&);
    /// Shows only rows that are wanted; an empty function wants all.
    void setWanted(const std::function<bool(const ParameterInfo&)>&);
    /// The focus goes to the next row that is shown (1), or the one before (-1); from elsewhere, to the first.
    void stepRow(int step);
    /// Changes the row with the focus, as its arrow keys do: more (1) or less (-1). `again`: still the same gesture.
    void nudge(int step, bool again);
    [[nodiscard]] QString filterText() const;
    /// Another exhibit is on show: what was searched for belonged to the one before.
    void clearFilter();
    /// Says that something outside this table matches the filter; a click asks for it. Empty: nothing does.
    void offerElsewhere(const QString& what);
    /// Connect `accuracyAsked` before showing the gauge: a mark that does nothing is no mark.
    void setGaugesShown(bool);
    /// What rows can be copied from and to, in their menus; must outlive it. Null: nothing.
    void setOther(OtherSettings* other) { other_ = other; }

    /// Groups that the visitor folded, or unfolded where they are folded at first, "exhibit/group": kept with the
    /// window's layout.
    [[nodiscard]] QStringList foldedGroups() const;
    void setFoldedGroups(const QStringList&);

    /// The moment of the last picture, for rows that move: they show the values that they then have.
    void showMoment(const MotionMoment&);

    /// Rows that keep their values when the others are varied, "exhibit/row": kept with the window's layout.
    [[nodiscard]] QStringList lockedRows() const;
    void setLockedRows(const QStringList&);
    /// Of the table on show.
    [[nodiscard]] bool isLocked(std::size_t row) const { return locked_.contains(keyOf(row)); }
    /// Gives all rows of the exhibit that are not locked other values, by the next seed (`variation`). One undo step.
    void vary();

    /// Shows the rows that match these words, as if they were typed.
    void find(const QString& words);

public slots:
    void focusFilter();

signals:
    /// The gauge of a quality parameter: what does its accuracy cost?
    void accuracyAsked(std::size_t row);
    /// Which rows keep their values when the others are varied.
    void locksChanged();
    /// The words of the filter changed.
    void filtered();
    void elsewhereAsked();
    /// Esc in the empty filter: the visitor is done here.
    void filterLeft();

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void rebuild();
    void addRow(std::size_t row);
    void addSection(const ParameterInfo&);
    /// Follows the changes of the shown exhibit, and of no other.
    void watch();
    void showRow(std::size_t row);
    void showAll();
    void showWhatActs();
    void applyFilter();
    void focusFirst();
    void orderTabs();
    /// The row that has the focus; empty: none.
    [[nodiscard]] std::string focusedRow() const;
    void focusRow(std::string_view name);
    void openMenu(std::size_t row, const QPoint& at);
    /// Menu of a row that does nothing: why, and what would change that.
    void openWay(std::size_t row, const QPoint& at);
    /// Entry that makes the row act, where other rows can.
    void addWayTo(QMenu&, std::size_t row);
    void openGroupMenu(ParameterSection*, const QPoint& at);
    /// Entries of a group that is one of several of its kind.
    void addArrayTo(QMenu&, const ParameterInfo& first);
    [[nodiscard]] std::vector<std::size_t> rowsOf(const ParameterSection*) const;
    [[nodiscard]] bool allLocked(const std::vector<std::size_t>& rows) const;
    /// The marks of headings: locked, edited together with others.
    void showGroups();
    /// Of the exhibit on show: what its rows edit through.
    [[nodiscard]] GroupEdits& edits();
    /// Entries that copy the row from and to B, while there is one.
    void addOtherTo(QMenu&, std::size_t row);
    /// Entries that let the row move, hold it and stop it.
    void addMotionTo(QMenu&, std::size_t row);
    void setMotion(std::size_t row, const QString& text, const std::optional<Motion>&, const Value&);
    void showValue(std::size_t row);
    /// Entries that lock the row and its group.
    void addLocksTo(QMenu&, std::size_t row);
    [[nodiscard]] QString keyOf(std::size_t row) const;
    void lock(const std::vector<std::size_t>& rows, bool locked);
    static constexpr int leastWidth = 320;  ///< Pixels.
    /// Makes the panel as wide as its rows need, whatever their type.
    void makeRoom();
    void showLocks();
    void copy(std::size_t row) const;
    void paste(std::size_t row);
    void copyAll() const;
    void pasteAll(std::size_t row);
    /// Something about what was pasted, at the row where it was asked for.
    void tell(std::size_t row, const QString& words);
    /// Focuses the first control of a row that takes the focus; returns whether there is one.
    static bool focusIn(const ParameterRow&);
    [[nodiscard]] std::optional<std::size_t> rowAt(QObject*) const;

    History& history_;
    QLineEdit* filter_;
    QToolButton* onlyChanged_;
    QToolButton* elsewhere_;
    QScrollArea* scroll_;
    QLabel* nothing_;
    QWidget* content_ = nullptr;
    std::vector<ParameterRow*> rows_;
    std::vector<ParameterSection*> sections_;
    std::vector<ParameterSection*> sectionOf_;  // By row.
    std::vector<bool> foldedAtFirst_;           // By section.
    std::shared_ptr<const Parameters> table_;   // Whose rows are built; null: none yet.
    std::size_t exhibit_ = 0;
    QMetaObject::Connection watched_;
    QString name_;
    QSet<QString> folded_;
    bool gauges_ = false;
    OtherSettings* other_ = nullptr;
    QSet<QString> locked_;
    MotionMoment moment_;
    std::uint64_t seed_ = 0;                    // Of the last variation.
    std::map<std::size_t, GroupEdits*> edits_;  // By exhibit, each made when first shown.
};

}  // namespace vitrine::ui
