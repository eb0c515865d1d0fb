#pragma once

#include "ui/compare/compare_mode.h"

#include <QList>
#include <QObject>

#include <array>
#include <utility>
#include <vector>

class QAction;
class QMenu;

namespace vitrine::ui {

class CompareController;

/// Commands of the comparison. The menu, the search and the bar are made from them.
class CompareActions final : public QObject {
    Q_OBJECT

public:
    explicit CompareActions(CompareController&);

    /// Returns the commands in the order of the menu; null is a separator.
    [[nodiscard]] const QList<QAction*>& all() const { return all_; }
    /// Returns the commands that are in the menu of sources, or in no menu.
    [[nodiscard]] const QList<QAction*>& more() const { return more_; }
    [[nodiscard]] QAction& mode(CompareMode mode) const { return *modes_.at(static_cast<std::size_t>(mode)); }
    /// Returns the command "Selected preset as B", which the list of presets also offers.
    [[nodiscard]] QAction* preset() const { return preset_; }
    [[nodiscard]] QAction& otherAlone() const { return *otherAlone_; }
    [[nodiscard]] QAction& swap() const { return *swap_; }
    [[nodiscard]] QAction& takeAll() const { return *takeAll_; }
    [[nodiscard]] QAction& giveAll() const { return *giveAll_; }
    [[nodiscard]] QAction& letGo() const { return *letGo_; }
    /// Returns the menu of sources for B: the present values, a preset, a file, an undo step. Filled when it opens.
    [[nodiscard]] QMenu& sources() const { return *sources_; }

    /// Updates the commands to the present B and mode.
    void refresh();
    /// Lists the comparisons that the visited subject offers.
    void refreshOffers();
    /// Returns the command of the first comparison that the visited subject offers; null if there is none.
    [[nodiscard]] QAction* firstOffer() const;

private:
    QAction* add(const QString& text, const QKeySequence&, const QString& tip);
    /// Gives each command an id, under which its shortcuts are stored.
    void nameAll();
    void addSources();
    void addOffers();
    void addModes();
    void fillSources();

    CompareController& controller_;
    QList<QAction*> all_, more_;
    QAction* hold_ = nullptr;
    QAction* preset_ = nullptr;
    QAction* file_ = nullptr;
    QAction* step_ = nullptr;
    std::vector<std::pair<std::size_t, QAction*>> offers_;  // Offered comparisons, each with its subject.
    std::array<QAction*, 6> modes_{};                       // Actions by mode; null for `off`.
    QAction* otherAlone_ = nullptr;
    QAction* swap_ = nullptr;
    QAction* takeAll_ = nullptr;
    QAction* giveAll_ = nullptr;
    QAction* letGo_ = nullptr;
    QMenu* sources_ = nullptr;
};

}  // namespace vitrine::ui
