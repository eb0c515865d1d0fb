#pragma once

#include "ui/model/history.h"
#include "ui/parameters/panel_groups.h"

#include <QWidget>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QScrollArea;
class QToolButton;

namespace vitrine::ui {

class PanelChoices;
class ParameterMenus;
class ParameterRow;
class ParameterSection;
enum class PanelChoice : std::uint8_t;

/// Panel with the parameters of one exhibit. All controls are derived from its parameter table and set values in the
/// history. If a value changes, only its own row is updated.
class ParameterPanel final : public QWidget {
    Q_OBJECT

public:
    /// The history must outlive it.
    explicit ParameterPanel(History&, QWidget* parent = nullptr);

    /// Shows the values of this exhibit. `name` is the key of its choices, and of copied values.
    void showExhibit(std::size_t exhibit, const QString& name);
    /// Returns the exhibit whose values are shown.
    [[nodiscard]] std::size_t exhibit() const { return exhibit_; }
    [[nodiscard]] const QString& name() const { return name_; }
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
    /// Shows gauge buttons. Connect `accuracyAsked` first, because they only emit that signal.
    void setGaugesShown(bool);
    /// Groups that the visitor folded or unfolded, and parameters that are locked or pinned.
    [[nodiscard]] PanelChoices& choices() const { return *choices_; }
    [[nodiscard]] ParameterMenus& menus() const { return *menus_; }

    /// Sets the time of the last picture, for animated parameters: their rows show the values at that time.
    void showMoment(const AnimationTime&);

    /// Shows the note of a parameter's controller again; `key` as of `keyOf`.
    void showController(const QString& key);

    /// Puts a widget beside the button "Changed", in the first line of the panel, which then owns it.
    void setHeading(QWidget*);
    // The following functions take the index or the name of a parameter of the shown table.
    [[nodiscard]] QString keyOf(std::size_t row) const;
    [[nodiscard]] bool isLocked(std::size_t row) const;
    [[nodiscard]] bool isPinned(std::size_t row) const;
    /// Returns false for essential parameters, and for tables without any.
    [[nodiscard]] bool mayPin(std::size_t row) const;
    /// Returns all parameters of the parameter's group in the table.
    [[nodiscard]] std::vector<std::size_t> groupOf(std::size_t row) const;
    /// Unfolds the parameter's group and gives the parameter the focus. Returns false if it is not shown.
    bool reveal(std::string_view name);
    /// Pins the parameter with the focus, or unpins it.
    void pinFocused();
    /// Sets all parameters of the exhibit that are not locked to random values, with the next seed (`variation`). One
    /// undo step.
    void vary();

signals:
    /// Emitted when the gauge of a quality parameter is pressed, which asks what its accuracy costs.
    void accuracyAsked(std::size_t row);

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    /// Makes all controls anew for the present table and pins.
    void rebuild();
    /// The same, and keeps focus and scroll position.
    void rearrange();
    void placeRows();
    void addRow(std::size_t row);
    void addSection(std::size_t group);
    [[nodiscard]] QString titleOf(const PanelGroup&) const;
    [[nodiscard]] QString keyOf(const PanelGroup&) const;
    /// Returns the index of the group under whose heading the parameter is shown.
    [[nodiscard]] std::size_t groupShowing(std::size_t row) const;
    /// Returns the parameters in the order in which they are shown.
    [[nodiscard]] std::vector<std::size_t> inOrder() const;
    /// Watches the shown exhibit only.
    void watch();
    void showRow(std::size_t row);
    void showAll();
    void showValues();
    void showValue(std::size_t row);
    void showWhatActs();
    void showControllers();
    void showChoice(PanelChoice);
    void foldAll(bool folded);
    /// Shows the wanted parameters, and of these only the changed ones if the visitor asked for that.
    void showOnlyWanted();
    void orderTabs();
    /// Returns the row with the focus; empty: none.
    [[nodiscard]] std::string focusedParameter() const;
    /// Updates the marks of headings: locked, edited together.
    void showGroups();
    static constexpr int leastWidth = 320;  ///< Pixels.
    /// Makes the panel as wide as its rows need with the current font.
    void makeRoom();
    void showLocks();
    /// Focuses the first focusable control of a row. Returns whether there is one.
    static bool focusIn(const ParameterRow&);
    [[nodiscard]] std::optional<std::size_t> rowAt(QObject*) const;

    History& history_;
    QToolButton* onlyChanged_;
    QScrollArea* scroll_;
    QLabel* nothing_;
    PanelChoices* choices_;
    ParameterMenus* menus_;
    QWidget* content_ = nullptr;
    std::vector<PanelGroup> groups_;
    std::vector<ParameterSection*> sections_;  // Sections, in the order of `groups_`.
    std::vector<ParameterRow*> rows_;          // Rows, by index of the parameter in the table.
    std::shared_ptr<const Parameters> table_;  // Table of the rows; null: none yet.
    std::size_t exhibit_ = 0;
    QMetaObject::Connection watched_;
    QString name_;
    std::uint64_t seed_ = 0;  // Seed of the last variation.
};

}  // namespace vitrine::ui
