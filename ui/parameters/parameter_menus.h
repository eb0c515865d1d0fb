#pragma once

#include "ui/model/history.h"
#include "ui/parameters/way_to_act.h"

#include <QObject>
#include <QPoint>

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

class QMenu;

namespace vitrine::ui {

class ControlledParameters;
class GroupEdits;
class SettingsB;
class PanelChoices;
class ParameterPanel;
class ParameterRow;
struct PanelGroup;

/// Menus of a panel's parameters and groups, and what their entries do.
class ParameterMenus final : public QObject {
    Q_OBJECT

public:
    /// All three must outlive it.
    ParameterMenus(History&, ParameterPanel&, PanelChoices&);

    /// Sets the settings B that values can be copied from and to; null: none.
    void setOther(SettingsB* other) { other_ = other; }
    /// Sets the time of the last picture, for animated parameters.
    void setMoment(const AnimationTime& moment) { moment_ = moment; }
    [[nodiscard]] const AnimationTime& moment() const { return moment_; }
    /// Sets whether menus of quality parameters offer to show the cost of accuracy.
    void setGaugesShown(bool shown) { gauges_ = shown; }
    [[nodiscard]] bool gaugesShown() const { return gauges_; }
    /// Changes that a push of a parameter's button makes now; nothing: the parameter has no button.
    using Push = std::function<std::optional<ParameterChanges>(std::size_t row)>;
    /// Sets the buttons of parameters, before they are shown.
    void setPush(Push push) { push_ = std::move(push); }
    [[nodiscard]] bool hasPush(std::size_t row) const { return push_ && push_(row); }
    /// Makes the changes of a parameter's button, as one undo step.
    void push(std::size_t row);

    /// Sets the controllers that parameters can learn; null: none.
    void setControllers(ControlledParameters* controllers) { controllers_ = controllers; }
    [[nodiscard]] ControlledParameters* controllers() const { return controllers_; }

    /// Opens the menu of a parameter at a position on the screen.
    void openRow(std::size_t row, const QPoint& at);
    /// Opens the menu of a parameter without effect: the reason, and the command that gives it one.
    void openWay(std::size_t row, const QPoint& at);
    void openGroup(const PanelGroup&, const QString& title, const QPoint& at);
    /// Makes changes that give a parameter an effect, as one undo step.
    void make(const ParameterChanges&);
    void togglePin(std::size_t row);
    [[nodiscard]] bool allLocked(const std::vector<std::size_t>& rows) const;
    /// Returns the edits of the shown exhibit, through which its parameters are changed.
    [[nodiscard]] GroupEdits& edits();

signals:
    void accuracyAsked(std::size_t row);
    /// Asks to fold or unfold all groups.
    void foldingAsked(bool folded);
    /// Emitted when other groups are edited together.
    void groupsChanged();

private:
    [[nodiscard]] const ParameterValues& values() const;
    [[nodiscard]] ParameterRow& rowOf(std::size_t row) const;
    [[nodiscard]] QMenu* newMenu();
    /// Adds the entry that gives the parameter an effect, if other parameters can.
    void addWayTo(QMenu&, std::size_t row);
    /// Adds the entries that animate the parameter, and pause and end its animation.
    void addMotionTo(QMenu&, std::size_t row);
    void setMotion(std::size_t row, const QString& text, const std::optional<Motion>&, const Value&);
    /// Adds the entries that copy the parameter from and to B, if there is one.
    void addOtherTo(QMenu&, std::size_t row);
    /// Adds the entries that pin the parameter and lock it and its group.
    void addChoicesTo(QMenu&, std::size_t row);
    /// Adds the entries that give the parameter to a controller and take it back.
    void addControllerTo(QMenu&, std::size_t row);
    /// Adds the entries of a group that is one of an array.
    void addArrayTo(QMenu&, const ParameterInfo& first);
    void lock(const std::vector<std::size_t>& rows, bool locked);
    void copy(std::size_t row) const;
    void paste(std::size_t row);
    void copyAll() const;
    void pasteAll(std::size_t row);
    /// Shows a message about pasted text below the parameter.
    void showProblem(std::size_t row, const QString& words);

    History& history_;
    ParameterPanel& panel_;
    PanelChoices& choices_;
    SettingsB* other_ = nullptr;
    ControlledParameters* controllers_ = nullptr;
    AnimationTime moment_;
    bool gauges_ = false;
    Push push_;
    std::map<std::size_t, GroupEdits*> edits_;  ///< By exhibit; each is made when it is first shown.
};

}  // namespace vitrine::ui
