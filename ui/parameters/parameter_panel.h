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

/// Panel with the parameters of one exhibit. All controls are derived from its parameter table and set values in the
/// history. If a value changes, only its own row is updated.
class ParameterPanel final : public QWidget {
    Q_OBJECT

public:
    /// The history must outlive it.
    explicit ParameterPanel(History&, QWidget* parent = nullptr);

    /// Shows the values of this exhibit. `name` is the key of its folded groups, and of copied values.
    void showExhibit(std::size_t exhibit, const QString& name);
    /// Returns the exhibit whose values are shown.
    [[nodiscard]] std::size_t exhibit() const { return exhibit_; }
    [[nodiscard]] const ParameterValues& values() const { return history_.sceneState().values[exhibit_]; }
    [[nodiscard]] ParameterRow* row(std::string_view name) const;
    /// Sets the values that text parameters offer, by the parameter's name.
    void setOffers(const std::map<std::string, std::vector<std::string>, std::less<>>&);
    /// Shows only the parameters for which the function returns true; without a function, all.
    void setWanted(const std::function<bool(const ParameterInfo&)>&);
    /// Focuses the next visible row (1) or the previous one (-1); the first one if no row has the focus.
    void stepRow(int step);
    /// Changes the focused row as its arrow keys do: up (1) or down (-1). `again`: continues the same gesture.
    void nudge(int step, bool again);
    [[nodiscard]] QString filterText() const;
    /// Clears the filter, for example because another exhibit is shown.
    void clearFilter();
    /// Shows a link to matches of the filter outside of this table; a click emits `elsewhereAsked`. Empty: no link.
    void offerElsewhere(const QString& what);
    /// Shows gauge buttons. Connect `accuracyAsked` first, because they only emit that signal.
    void setGaugesShown(bool);
    /// Sets the settings B, for the commands that copy rows from and to B; must outlive the panel. Null: none.
    void setOther(OtherSettings* other) { other_ = other; }

    /// Groups, as "exhibit/group", that the visitor has folded, or unfolded if they are folded by default. Stored with
    /// the window's layout.
    [[nodiscard]] QStringList foldedGroups() const;
    void setFoldedGroups(const QStringList&);

    /// Sets the time of the last picture, for animated parameters: their rows show the values at that time.
    void showMoment(const MotionMoment&);

    /// Parameters, as "exhibit/row", that keep their values when the others are varied. Stored with the window's
    /// layout.
    [[nodiscard]] QStringList lockedRows() const;
    void setLockedRows(const QStringList&);
    /// Returns whether a parameter of the shown table is locked.
    [[nodiscard]] bool isLocked(std::size_t row) const { return locked_.contains(keyOf(row)); }
    /// Sets all parameters of the exhibit that are not locked to random values, with the next seed (`variation`). One
    /// undo step.
    void vary();

    /// Filters by these words, as if they were typed.
    void find(const QString& words);

public slots:
    void focusFilter();

signals:
    /// Emitted when the gauge of a quality parameter is pressed, which asks what its accuracy costs.
    void accuracyAsked(std::size_t row);
    /// Emitted when parameters were locked or unlocked against varying.
    void locksChanged();
    /// Emitted when the words of the filter changed.
    void filtered();
    void elsewhereAsked();
    /// Emitted when Esc is pressed in the empty filter.
    void filterLeft();

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void rebuild();
    void addRow(std::size_t row);
    void addSection(const ParameterInfo&);
    /// Watches the shown exhibit only.
    void watch();
    void showRow(std::size_t row);
    void showAll();
    void showWhatActs();
    void applyFilter();
    void focusFirst();
    void orderTabs();
    /// Returns the row with the focus; empty: none.
    [[nodiscard]] std::string focusedRow() const;
    void focusRow(std::string_view name);
    void openMenu(std::size_t row, const QPoint& at);
    /// Opens the menu of a parameter without effect: the reason, and changes that would give it an effect.
    void openWay(std::size_t row, const QPoint& at);
    /// Adds a command that gives the parameter an effect, if other parameters can do that.
    void addWayTo(QMenu&, std::size_t row);
    void openGroupMenu(ParameterSection*, const QPoint& at);
    /// Adds the commands of a group that belongs to an array of groups.
    void addArrayTo(QMenu&, const ParameterInfo& first);
    [[nodiscard]] std::vector<std::size_t> rowsOf(const ParameterSection*) const;
    [[nodiscard]] bool allLocked(const std::vector<std::size_t>& rows) const;
    /// Updates the marks of headings: locked, edited together.
    void showGroups();
    /// Returns the edits of the shown exhibit, through which rows set values.
    [[nodiscard]] GroupEdits& edits();
    /// Adds the commands that copy the row from and to B, if there is a B.
    void addOtherTo(QMenu&, std::size_t row);
    /// Adds the commands that animate the row, hold it and stop it.
    void addMotionTo(QMenu&, std::size_t row);
    void setMotion(std::size_t row, const QString& text, const std::optional<Motion>&, const Value&);
    void showValue(std::size_t row);
    /// Adds the commands that lock the row and its group.
    void addLocksTo(QMenu&, std::size_t row);
    [[nodiscard]] QString keyOf(std::size_t row) const;
    void lock(const std::vector<std::size_t>& rows, bool locked);
    static constexpr int leastWidth = 320;  ///< Pixels.
    /// Makes the panel as wide as its rows need with the current font.
    void makeRoom();
    void showLocks();
    void copy(std::size_t row) const;
    void paste(std::size_t row);
    void copyAll() const;
    void pasteAll(std::size_t row);
    /// Shows a message about pasted values at this row.
    void tell(std::size_t row, const QString& words);
    /// Focuses the first focusable control of a row. Returns whether there is one.
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
