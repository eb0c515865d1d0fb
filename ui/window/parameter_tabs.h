#pragma once

#include "exhibits/framework/scene/scene_object.h"
#include "exhibits/museum/scene_state.h"

#include <QWidget>

class QAction;
class QTabBar;
class QToolButton;

namespace vitrine::ui {

class History;
class ParameterPanel;

/// Parameters of the chosen exhibit, and in a second tab those of the hall.
class ParameterTabs final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the tabs.
    ParameterTabs(Subjects, History&, QWidget* parent = nullptr);

    /// Shows the parameters of this subject and, in the second tab, of the hall.
    void choose(std::size_t subject);
    /// Shows the parameters of this subject if it has a tab. Returns whether it has one.
    bool turnTo(std::size_t subject);
    /// Puts a button for this command beside the tabs.
    void setSearch(QAction*);
    /// Returns the subject whose parameters the panel shows.
    [[nodiscard]] std::size_t shown() const;
    /// Returns the width at which the longest label of all subjects is shown whole, in pixels.
    [[nodiscard]] int widthForLabels() const;
    [[nodiscard]] ParameterPanel& panel() const { return *panel_; }

signals:
    /// Emitted when the visitor changed the tab.
    void turned();

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    void show();
    /// Puts the tabs on a line of their own if there is no room for them beside the buttons.
    void arrange();

    Subjects subjects_;
    QWidget* heading_;       ///< Tabs, if they fit, and the button for the search.
    bool areAbove_ = false;  ///< Whether the tabs have a line of their own.
    QTabBar* tabs_;
    QToolButton* search_;
    ParameterPanel* panel_;
};

}  // namespace vitrine::ui
