#pragma once

#include "exhibits/framework/subject.h"
#include "exhibits/museum/scene_state.h"

#include <QWidget>

class QTabBar;

namespace vitrine::ui {

class History;
class ParameterPanel;

/// The parameters of the chosen exhibit, and in a second tab those of the hall around it.
class ParameterTabs final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive it.
    ParameterTabs(Subjects, History&, QWidget* parent = nullptr);

    /// Shows the parameters of this subject and, beside them, of the hall.
    void choose(std::size_t subject);
    /// Whose parameters the panel shows.
    [[nodiscard]] std::size_t shown() const;
    [[nodiscard]] ParameterPanel& panel() const { return *panel_; }

signals:
    /// The visitor went to the other tab.
    void turned();

private:
    void show();
    void searchElsewhere();

    Subjects subjects_;
    const History& history_;
    QTabBar* tabs_;
    ParameterPanel* panel_;
};

}  // namespace vitrine::ui
