#pragma once

#include "exhibits/framework/exhibit.h"

#include <QWidget>

#include <memory>
#include <span>

class QTabBar;

namespace vitrine::ui {

class History;
class ParameterPanel;

/// The parameters of the chosen exhibit, and in a second tab those of the hall around it.
class ParameterTabs final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive it.
    ParameterTabs(std::span<const std::unique_ptr<Exhibit>>, History&, QWidget* parent = nullptr);

    /// Shows this exhibit's parameters; 0 is the hall.
    void choose(std::size_t exhibit);
    /// Whose parameters the panel shows.
    [[nodiscard]] std::size_t shown() const;
    [[nodiscard]] ParameterPanel& panel() const { return *panel_; }

signals:
    /// The visitor went to the other tab.
    void turned();

private:
    void show();
    void searchElsewhere();

    std::span<const std::unique_ptr<Exhibit>> exhibits_;
    const History& history_;
    QTabBar* tabs_;
    ParameterPanel* panel_;
};

}  // namespace vitrine::ui
